"""The labels of a frame as typed records. docs/dataset-format.md has the meaning, unit, frame and range of each field.

Names are those of the format in snake case. None means that a value is unknown or does not apply, as null does in the files. Fields that
this version does not know are in the dictionary `raw` of View and Frame.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, Optional, Tuple

import numpy as np

from .camera import Array, Camera, orthonormal
from .checks import Box, Vector, box, each, flag, integer, number, optional, text, vector

JOINT_NAMES: Tuple[str, ...] = (
    "head_top",
    "head_center",
    "neck",
    "right_clavicle",
    "right_shoulder",
    "right_elbow",
    "right_wrist",
    "left_clavicle",
    "left_shoulder",
    "left_elbow",
    "left_wrist",
    "spine0",
    "spine1",
    "spine2",
    "spine3",
    "spine4",
    "right_hip",
    "right_knee",
    "right_ankle",
    "left_hip",
    "left_knee",
    "left_ankle",
)
"""The joints of a person, in the order of the labels (that of the dataset JTA)."""

CLASS_NAMES: Tuple[str, ...] = (
    "car",
    "truck",
    "bus",
    "motorcycle",
    "bicycle",
    "trailer",
    "pedestrian",
    "sign",
    "trafficLight",
    "other",
    "rider",
)
"""The classes of the format, in the order of their numbers."""

SEMANTIC_CLASS_NAMES: Tuple[str, ...] = (
    "none",
    "road",
    "pavement",
    "laneMarking",
    "building",
    "vegetation",
    "terrain",
    "sky",
    "water",
    "pole",
    "fence",
) + CLASS_NAMES
"""The classes of class maps, in the order of their numbers."""

# The corners of a cuboid as signs of (right, forward, up), and its edges as pairs of corners.
_CORNERS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=np.float64)
CUBOID_EDGES: Tuple[Tuple[int, int], ...] = (
    (0, 1),
    (2, 3),
    (4, 5),
    (6, 7),
    (0, 2),
    (1, 3),
    (4, 6),
    (5, 7),
    (0, 4),
    (1, 5),
    (2, 6),
    (3, 7),
)
"""The twelve edges of a cuboid, as pairs of indices into Cuboid.corners."""


@dataclass(frozen=True)
class Cuboid:
    """The oriented box of an object in the world. half_extents are along right, forward, up, metres."""

    centre: Vector
    half_extents: Vector
    right: Vector
    forward: Vector
    up: Vector

    @staticmethod
    def from_json(cuboid: Mapping[str, Any]) -> Cuboid:
        """The cuboid of a label."""
        return Cuboid(
            vector(cuboid["centre"]),
            vector(cuboid["halfExtents"]),
            vector(cuboid["right"]),
            vector(cuboid["forward"]),
            vector(cuboid["up"]),
        )

    @property
    def corners(self) -> Array:
        """The eight corners, (8, 3), metres, world."""
        return np.asarray(
            (_CORNERS * self.half_extents) @ orthonormal(self.right, self.forward) + np.array(self.centre)
        )


@dataclass(frozen=True)
class Light:
    """The state of the head of a traffic light."""

    state: str
    method: str
    lit_fraction: Optional[float]


@dataclass(frozen=True)
class Face:
    """What only the face of a sign or the head of a traffic light has."""

    face: int
    mutcd: Optional[str]
    faces_camera: bool
    facing_angle_degrees: float
    provenance: str
    light: Optional[Light]

    @staticmethod
    def from_json(space: Mapping[str, Any]) -> Face:
        """The face of a label."""
        light = space["light"]
        return Face(
            integer(space["face"]),
            optional(text, space["mutcd"]),
            flag(space["facesCamera"]),
            number(space["facingAngleDegrees"]),
            text(space["provenance"]),
            None
            if light is None
            else Light(text(light["state"]), text(light["method"]), optional(number, light["litFraction"])),
        )


@dataclass(frozen=True)
class VehicleLights:
    """Which lamps of a vehicle shine."""

    brake: bool
    left: bool
    right: bool
    head: bool

    @staticmethod
    def from_json(lights: Mapping[str, Any]) -> VehicleLights:
        """The lamps of a label."""
        return VehicleLights(flag(lights["brake"]), flag(lights["left"]), flag(lights["right"]), flag(lights["head"]))


@dataclass(frozen=True)
class Joint:
    """A joint of a person. visibility: outside, occluded, selfOccluded, visible or unknown."""

    name: str
    position: Vector
    pixel: Optional[Tuple[float, float]]
    visibility: str

    @staticmethod
    def from_json(joint: Mapping[str, Any]) -> Joint:
        """The record of an entry of joints."""
        return Joint(
            text(joint["joint"]), vector(joint["position"]), optional(_pixel, joint["pixel"]), text(joint["visibility"])
        )


def _pixel(value: Any) -> Tuple[float, float]:
    u, v = value
    return number(u), number(v)


@dataclass(frozen=True)
class ObjectLabel:
    """An object in an image. Boxes are (xMin, yMin, xMax, yMax) in continuous pixels."""

    id: int
    class_name: str
    model: str
    name: Optional[str]
    parent: Optional[int]
    known_parts: Optional[int]
    has_rider: Optional[bool]
    vehicle: Optional[int]
    box2d: Box
    box2d_amodal: Box
    box2d_visible: Optional[Box]
    box2d_whole: Optional[Box]
    truncated_fraction: float
    occluded_fraction: Optional[float]
    occlusion_method: str
    visible_fraction: Optional[float]
    true_occluded_fraction: Optional[float]
    lane_id: Optional[str]
    governed_lanes: Optional[Tuple[str, ...]]
    box3d: Cuboid
    distance_metres: float
    velocity: Vector
    face: Optional[Face]
    lights: Optional[VehicleLights]
    box2d_joints: Optional[Box]
    joints: Optional[Tuple[Joint, ...]]

    @staticmethod
    def from_json(item: Mapping[str, Any]) -> ObjectLabel:
        """The record of an entry of objects."""
        return ObjectLabel(
            id=integer(item["id"]),
            class_name=text(item["class"]),
            model=text(item["model"]),
            name=optional(text, item["name"]),
            parent=optional(integer, item["parent"]),
            known_parts=optional(integer, item["knownParts"]),
            has_rider=optional(flag, item["hasRider"]),
            vehicle=optional(integer, item.get("vehicle")),
            box2d=box(item["box2d"]),
            box2d_amodal=box(item["box2dAmodal"]),
            box2d_visible=optional(box, item["box2dVisible"]),
            box2d_whole=optional(box, item.get("box2dWhole")),
            truncated_fraction=number(item["truncatedFraction"]),
            occluded_fraction=optional(number, item["occludedFraction"]),
            occlusion_method=text(item["occlusionMethod"]),
            visible_fraction=optional(number, item["visibleFraction"]),
            true_occluded_fraction=optional(number, item.get("trueOccludedFraction")),
            lane_id=optional(text, item.get("laneId")),
            governed_lanes=None if item.get("governedLanes") is None else each(text, item["governedLanes"]),
            box3d=Cuboid.from_json(item["box3d"]),
            distance_metres=number(item["distanceMetres"]),
            velocity=vector(item["velocity"]),
            face=optional(Face.from_json, item["space"]),
            lights=optional(VehicleLights.from_json, item.get("lights")),
            box2d_joints=optional(box, item.get("box2dJoints")),
            joints=optional(_joints, item.get("joints")),
        )


def _joints(value: Any) -> Tuple[Joint, ...]:
    joints = each(Joint.from_json, value)
    if len(joints) > len(JOINT_NAMES):
        raise ValueError(f"a person has {len(joints)} joints")
    return joints


@dataclass(frozen=True)
class Pair:
    """A further picture of the moment of a frame, which shares its labels. file is None if the harvest dropped it, for the reason
    dropped: unsettled, notHidden or noPicture. without has the ids of the hidden objects."""

    file: Optional[str]
    weather: str
    time_of_day: str
    without: Tuple[int, ...]
    dropped: Optional[str]

    @staticmethod
    def from_json(pair: Mapping[str, Any]) -> Pair:
        """The record of an entry of pairs."""
        return Pair(
            optional(text, pair["file"]),
            text(pair["weather"]),
            text(pair["timeOfDay"]),
            each(integer, pair["without"]),
            optional(text, pair.get("dropped")),
        )


@dataclass(frozen=True)
class IgnoreRegion:
    """A part of an image that shows, or may show, an object without a label."""

    reason: str
    class_name: str
    box2d: Box
    distance_metres: float

    @staticmethod
    def from_json(region: Mapping[str, Any]) -> IgnoreRegion:
        """The record of an entry of ignoreRegions."""
        return IgnoreRegion(
            text(region["reason"]), text(region["class"]), box(region["box2d"]), number(region["distanceMetres"])
        )


@dataclass(frozen=True)
class Ego:
    """The vehicle that carries the camera. Fields that a game does not report are None."""

    position: Vector
    heading_degrees: float
    velocity: Vector
    model: str
    right: Optional[Vector]
    forward: Optional[Vector]
    up: Optional[Vector]
    height_above_ground_metres: Optional[float]
    yaw_rate: Optional[float]
    acceleration: Optional[float]
    steering: Optional[float]
    throttle: Optional[float]
    brake: Optional[float]
    manoeuvre: Optional[str]

    @staticmethod
    def from_json(ego: Mapping[str, Any]) -> Ego:
        """The record of a label's ego."""
        right, forward, up = (optional(vector, ego.get(axis)) for axis in ("right", "forward", "up"))
        height, yaw_rate, acceleration, steering, throttle, brake = (
            optional(number, ego.get(name))
            for name in ("heightAboveGroundMetres", "yawRate", "acceleration", "steering", "throttle", "brake")
        )
        return Ego(
            vector(ego["position"]),
            number(ego["headingDegrees"]),
            vector(ego["velocity"]),
            text(ego["model"]),
            right,
            forward,
            up,
            height,
            yaw_rate,
            acceleration,
            steering,
            throttle,
            brake,
            optional(text, ego.get("manoeuvre")),
        )


__all__ = [
    "Box",
    "CLASS_NAMES",
    "CUBOID_EDGES",
    "Camera",
    "Cuboid",
    "Ego",
    "Face",
    "IgnoreRegion",
    "JOINT_NAMES",
    "Joint",
    "Light",
    "ObjectLabel",
    "SEMANTIC_CLASS_NAMES",
    "Vector",
    "VehicleLights",
]
