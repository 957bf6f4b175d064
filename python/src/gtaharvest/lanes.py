"""The lanes of a frame as typed records. docs/lanes.md has the meaning, unit, frame and range of each field."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, Optional, Tuple

import numpy as np

from .camera import Array

INDICATOR_NAMES: Tuple[str, ...] = (
    "angle", "toMarkingL", "toMarkingM", "toMarkingR", "distL", "distR", "toMarkingLL", "toMarkingML", "toMarkingMR", "toMarkingRR",
    "distLL", "distMM", "distRR")
"""DeepDriving's thirteen indicators, in the order of the arrays."""


@dataclass(frozen=True)
class Indicators:
    """The thirteen indicators: values in metres (angle in radians) and which of them are active, both in the order INDICATOR_NAMES."""

    values: Array
    valid: np.ndarray[Any, np.dtype[np.bool_]]

    @staticmethod
    def from_json(values: Mapping[str, Any], valid: Mapping[str, Any]) -> Indicators:
        """The record of indicators and their flags."""
        return Indicators(
            np.array([values[name] for name in INDICATOR_NAMES], dtype=np.float64),
            np.array([valid[name] for name in INDICATOR_NAMES], dtype=np.bool_))


@dataclass(frozen=True)
class VehicleInLane:
    """A vehicle ahead on the same road."""

    id: int
    lane: int
    oncoming: bool
    distance_metres: float
    bumper_distance_metres: float


@dataclass(frozen=True)
class LaneLine:
    """A boundary or painted marking in the image, nearest point first.

    points: (n, 3), metres, world. in_camera: (n, 3), metres. pixels: (n, 2). hidden: one of True, False, None (no ray) for each point.
    style, colour, width_metres and painted are None for a boundary.
    """

    index: int
    side: str
    points: Array
    in_camera: Array
    pixels: Array
    hidden: Tuple[Optional[bool], ...]
    style: Optional[str]
    colour: Optional[str]
    width_metres: Optional[float]
    painted: Optional[Tuple[bool, ...]]

    @staticmethod
    def from_json(line: Mapping[str, Any]) -> LaneLine:
        """The record of an entry of boundaries or markings."""
        painted = line.get("painted")
        return LaneLine(
            line["index"], line["side"],
            np.array(line["points"], dtype=np.float64).reshape(-1, 3),
            np.array(line["inCamera"], dtype=np.float64).reshape(-1, 3),
            np.array(line["pixels"], dtype=np.float64).reshape(-1, 2),
            tuple(line["hidden"]), line.get("style"), line.get("colour"), line.get("widthMetres"),
            None if painted is None else tuple(painted))


@dataclass(frozen=True)
class Lanes:
    """The lanes around the car, the vehicles in them, and the thirteen indicators."""

    status: str
    source: str
    confidence: float
    in_junction: bool
    lane_count: Optional[int]
    lane: Optional[int]
    lane_width_metres: Optional[float]
    lane_width_source: Optional[str]
    offset_from_lane_centre_metres: Optional[float]
    look_ahead_metres: float
    curvature_per_metre: float
    fast: bool
    indicators: Indicators
    torcs_equivalent: Indicators
    at_car: Indicators
    vehicles: Tuple[VehicleInLane, ...]
    boundaries: Tuple[LaneLine, ...]
    markings: Optional[Tuple[LaneLine, ...]]

    @staticmethod
    def from_json(lanes: Mapping[str, Any]) -> Lanes:
        """The record of a label's lanes."""
        markings = lanes["markings"]
        return Lanes(
            lanes["status"], lanes["source"], lanes["confidence"], lanes["inJunction"], lanes["laneCount"], lanes["lane"],
            lanes["laneWidthMetres"], lanes["laneWidthSource"], lanes["offsetFromLaneCentreMetres"], lanes["lookAheadMetres"],
            lanes["curvaturePerMetre"], lanes["fast"],
            Indicators.from_json(lanes["indicators"], lanes["valid"]),
            Indicators.from_json(lanes["torcsEquivalent"], lanes["valid"]),
            Indicators.from_json(lanes["atCar"]["indicators"], lanes["atCar"]["valid"]),
            tuple(VehicleInLane(each["id"], each["lane"], each["oncoming"], each["distanceMetres"], each["bumperDistanceMetres"])
                  for each in lanes["vehicles"]),
            tuple(map(LaneLine.from_json, lanes["boundaries"])),
            None if markings is None else tuple(map(LaneLine.from_json, markings)))
