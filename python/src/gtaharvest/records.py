"""The labels of a frame as typed records. docs/dataset-format.md has the meaning, unit, frame and range of each field.

Names are those of the format in snake case. None means that a value is unknown or does not apply, as null does in the files. Fields that
this version does not know are in the dictionary `raw` of View and Frame.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, Optional, Tuple

import numpy as np

from .camera import Array, Camera, Vector, orthonormal, vector

Box = Tuple[float, float, float, float]

JOINT_NAMES: Tuple[str, ...] = (
    "head_top", "head_center", "neck",
    "right_clavicle", "right_shoulder", "right_elbow", "right_wrist",
    "left_clavicle", "left_shoulder", "left_elbow", "left_wrist",
    "spine0", "spine1", "spine2", "spine3", "spine4",
    "right_hip", "right_knee", "right_ankle",
    "left_hip", "left_knee", "left_ankle",
)
"""The joints of a person, in the order of the labels (that of the dataset JTA)."""

CLASS_NAMES: Tuple[str, ...] = (
    "car", "truck", "bus", "motorcycle", "bicycle", "trailer", "pedestrian", "sign", "trafficLight", "other")
"""The classes of the format, in the order of their numbers."""

SEMANTIC_CLASS_NAMES: Tuple[str, ...] = (
    "none", "road", "pavement", "laneMarking", "building", "vegetation", "terrain", "sky", "water", "pole", "fence") + CLASS_NAMES
"""The classes of class maps, in the order of their numbers."""

# The corners of a cuboid as signs of (right, forward, up), and its edges as pairs of corners.
_CORNERS = np.array([[x, y, z] for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)], dtype=np.float64)
CUBOID_EDGES: Tuple[Tuple[int, int], ...] = (
    (0, 1), (2, 3), (4, 5), (6, 7), (0, 2), (1, 3), (4, 6), (5, 7), (0, 4), (1, 5), (2, 6), (3, 7))
"""The twelve edges of a cuboid, as pairs of indices into Cuboid.corners."""


def _box(value: Any) -> Optional[Box]:
    return None if value is None else (value[0], value[1], value[2], value[3])


@dataclass(frozen=True)
class Cuboid:
    """The oriented box of an object in the world. half_extents are along right, forward, up, metres."""

    centre: Vector
    half_extents: Vector
    right: Vector
    forward: Vector
    up: Vector

    @staticmethod
    def from_json(box: Mapping[str, Any]) -> Cuboid:
        """The cuboid of a label."""
        return Cuboid(
            vector(box["centre"]), vector(box["halfExtents"]), vector(box["right"]), vector(box["forward"]), vector(box["up"]))

    @property
    def corners(self) -> Array:
        """The eight corners, (8, 3), metres, world."""
        return np.asarray((_CORNERS * self.half_extents) @ orthonormal(self.right, self.forward) + np.array(self.centre))


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
            space["face"], space["mutcd"], space["facesCamera"], space["facingAngleDegrees"], space["provenance"],
            None if light is None else Light(light["state"], light["method"], light["litFraction"]))


@dataclass(frozen=True)
class VehicleLights:
    """Which lamps of a vehicle shine."""

    brake: bool
    left: bool
    right: bool
    head: bool


@dataclass(frozen=True)
class Joint:
    """A joint of a person. visibility: outside, occluded, selfOccluded, visible or unknown."""

    name: str
    position: Vector
    pixel: Optional[Tuple[float, float]]
    visibility: str


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
    box2d: Box
    box2d_amodal: Box
    box2d_visible: Optional[Box]
    box2d_whole: Optional[Box]
    truncated_fraction: float
    occluded_fraction: Optional[float]
    occlusion_method: str
    visible_fraction: Optional[float]
    true_occluded_fraction: Optional[float]
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
        space, lights, joints = item["space"], item.get("lights"), item.get("joints")
        return ObjectLabel(
            item["id"], item["class"], item["model"], item["name"], item["parent"], item["knownParts"], item["hasRider"],
            (item["box2d"][0], item["box2d"][1], item["box2d"][2], item["box2d"][3]),
            (item["box2dAmodal"][0], item["box2dAmodal"][1], item["box2dAmodal"][2], item["box2dAmodal"][3]),
            _box(item["box2dVisible"]), _box(item.get("box2dWhole")), item["truncatedFraction"], item["occludedFraction"],
            item["occlusionMethod"], item["visibleFraction"], item.get("trueOccludedFraction"), Cuboid.from_json(item["box3d"]),
            item["distanceMetres"], vector(item["velocity"]),
            None if space is None else Face.from_json(space),
            None if lights is None else VehicleLights(lights["brake"], lights["left"], lights["right"], lights["head"]),
            _box(item.get("box2dJoints")),
            None if joints is None else tuple(
                Joint(each["joint"], vector(each["position"]), None if each["pixel"] is None else (each["pixel"][0], each["pixel"][1]),
                      each["visibility"]) for each in joints))


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
        return Pair(pair["file"], pair["weather"], pair["timeOfDay"], tuple(pair["without"]), pair.get("dropped"))


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
        box = region["box2d"]
        return IgnoreRegion(region["reason"], region["class"], (box[0], box[1], box[2], box[3]), region["distanceMetres"])


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
        right, forward, up = (None if ego.get(axis) is None else vector(ego[axis]) for axis in ("right", "forward", "up"))
        return Ego(
            vector(ego["position"]), ego["headingDegrees"], vector(ego["velocity"]), ego["model"], right, forward, up,
            ego.get("heightAboveGroundMetres"), ego.get("yawRate"), ego.get("acceleration"), ego.get("steering"),
            ego.get("throttle"), ego.get("brake"), ego.get("manoeuvre"))


__all__ = [
    "Box", "CLASS_NAMES", "CUBOID_EDGES", "Camera", "Cuboid", "Ego", "Face", "IgnoreRegion", "JOINT_NAMES", "Joint", "Light",
    "ObjectLabel", "SEMANTIC_CLASS_NAMES", "Vector", "VehicleLights"]
