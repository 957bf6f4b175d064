"""The lanes of a frame as typed records. docs/lanes.md has the meaning, unit, frame and range of each field."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, Optional, Tuple

import numpy as np

from .camera import Array
from .checks import each, flag, integer, number, numbers, optional, text

INDICATOR_NAMES: Tuple[str, ...] = (
    "angle",
    "toMarkingL",
    "toMarkingM",
    "toMarkingR",
    "distL",
    "distR",
    "toMarkingLL",
    "toMarkingML",
    "toMarkingMR",
    "toMarkingRR",
    "distLL",
    "distMM",
    "distRR",
)
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
            np.array([number(values[name]) for name in INDICATOR_NAMES], dtype=np.float64),
            np.array([flag(valid[name]) for name in INDICATOR_NAMES], dtype=np.bool_),
        )


@dataclass(frozen=True)
class VehicleInLane:
    """A vehicle ahead on the same road."""

    id: int
    lane: int
    oncoming: bool
    distance_metres: float
    bumper_distance_metres: float

    @staticmethod
    def from_json(vehicle: Mapping[str, Any]) -> VehicleInLane:
        """The record of an entry of vehicles."""
        return VehicleInLane(
            integer(vehicle["id"]),
            integer(vehicle["lane"]),
            flag(vehicle["oncoming"]),
            number(vehicle["distanceMetres"]),
            number(vehicle["bumperDistanceMetres"]),
        )


@dataclass(frozen=True, repr=False)
class LaneLine:
    """A boundary or painted marking in the image, nearest point first.

    points: (n, 3), metres, world. in_camera: (n, 3), metres. pixels: (n, 2). hidden: one of True, False, None (no ray) for each point.
    style, colour, width_metres and painted are None for a boundary. source ("paint") and sigma_metres, the standard deviation of the
    line's position across the road, are those of a measured marking; None for others.
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
    source: Optional[str]
    sigma_metres: Optional[float]

    @staticmethod
    def from_json(line: Mapping[str, Any]) -> LaneLine:
        """The record of an entry of boundaries or markings."""
        return LaneLine(
            integer(line["index"]),
            text(line["side"]),
            _points(line["points"], 3),
            _points(line["inCamera"], 3),
            _points(line["pixels"], 2),
            each(_hidden, line["hidden"]),
            optional(text, line.get("style")),
            optional(text, line.get("colour")),
            optional(number, line.get("widthMetres")),
            None if line.get("painted") is None else each(flag, line["painted"]),
            optional(text, line.get("source")),
            optional(number, line.get("sigmaMetres")),
        )

    def __repr__(self) -> str:
        return f"LaneLine({self.side} {self.index}, {self.style or 'boundary'}, {len(self.points)} points)"


def _points(value: Any, columns: int) -> Array:
    rows = each(numbers, value)
    if any(len(row) != columns for row in rows):
        raise ValueError(f"a point does not have {columns} numbers")
    return np.array(rows, dtype=np.float64).reshape(-1, columns)


def _hidden(value: Any) -> Optional[bool]:
    return optional(flag, value)


@dataclass(frozen=True, repr=False)
class Lanes:
    """The lanes around the car, the vehicles in them, and the thirteen indicators.

    lane_widths_metres is None if all lanes have the same width. lane_id names the lane or way of docs/maps.md on which the car is, and
    lanes_ahead those that it reaches, nearest first; lanes_ahead is None in sessions of earlier versions.
    """

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
    lane_widths_metres: Optional[Tuple[float, ...]]
    lane_id: Optional[str]
    lanes_ahead: Optional[Tuple[str, ...]]

    @staticmethod
    def from_json(lanes: Mapping[str, Any]) -> Lanes:
        """The record of a label's lanes."""
        markings = lanes["markings"]
        return Lanes(
            text(lanes["status"]),
            text(lanes["source"]),
            number(lanes["confidence"]),
            flag(lanes["inJunction"]),
            optional(integer, lanes["laneCount"]),
            optional(integer, lanes["lane"]),
            optional(number, lanes["laneWidthMetres"]),
            optional(text, lanes["laneWidthSource"]),
            optional(number, lanes["offsetFromLaneCentreMetres"]),
            number(lanes["lookAheadMetres"]),
            number(lanes["curvaturePerMetre"]),
            flag(lanes["fast"]),
            Indicators.from_json(lanes["indicators"], lanes["valid"]),
            Indicators.from_json(lanes["torcsEquivalent"], lanes["valid"]),
            Indicators.from_json(lanes["atCar"]["indicators"], lanes["atCar"]["valid"]),
            each(VehicleInLane.from_json, lanes["vehicles"]),
            each(LaneLine.from_json, lanes["boundaries"]),
            None if markings is None else each(LaneLine.from_json, markings),
            None if lanes.get("laneWidthsMetres") is None else each(number, lanes["laneWidthsMetres"]),
            optional(text, lanes.get("laneId")),
            None if lanes.get("lanesAhead") is None else each(text, lanes["lanesAhead"]),
        )

    def __repr__(self) -> str:
        place = "" if self.lane is None else f", lane {self.lane} of {self.lane_count}"
        offset = (
            ""
            if self.offset_from_lane_centre_metres is None
            else f", {self.offset_from_lane_centre_metres:+.2f} m from its centre"
        )
        markings = "" if self.markings is None else f", {len(self.markings)} markings"
        return f"Lanes({self.status}{place}{offset}, {len(self.vehicles)} vehicles, {len(self.boundaries)} boundaries{markings})"
