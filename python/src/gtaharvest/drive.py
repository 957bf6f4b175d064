"""The actions of a recorded drive. docs/dataset-format.md has the meaning, unit and range of each field."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Mapping, Optional, Tuple

from .checks import Vector, each, flag, integer, number, optional, text, vector
from .lanes import INDICATOR_NAMES

DRIVERS: Tuple[str, ...] = ("none", "builtIn", "controller", "client")
"""Who can drive."""


def _driver(value: Any) -> str:
    if value not in DRIVERS:
        raise ValueError(f"the driver is {value!r}")
    return str(value)


@dataclass(frozen=True)
class Controls:
    """Steering, -1 to 1 (full lock left), throttle and brake, 0 to 1."""

    steering: float
    throttle: float
    brake: float

    @staticmethod
    def from_json(controls: Optional[Mapping[str, Any]]) -> Optional[Controls]:
        """The controls of a label; None if it has none."""
        if controls is None:
            return None
        return Controls(number(controls["steering"]), number(controls["throttle"]), number(controls["brake"]))


@dataclass(frozen=True)
class DriveTick:
    """The car after one tick of the game between two frames."""

    time_seconds: float
    driver: str
    speed: float
    acceleration: Optional[Vector]
    angular_rate: Optional[Vector]
    applied: Optional[Controls]

    @staticmethod
    def from_json(tick: Mapping[str, Any]) -> DriveTick:
        """The tick of a label."""
        return DriveTick(
            number(tick["timeSeconds"]),
            _driver(tick["driver"]),
            number(tick["speed"]),
            optional(vector, tick["acceleration"]),
            optional(vector, tick["angularRate"]),
            Controls.from_json(tick["applied"]),
        )


@dataclass(frozen=True)
class DriveTruth:
    """What a simulated game knows about a drive at a frame."""

    driven_metres: float
    collision: Optional[str]
    outside_lanes: bool
    lane_offset_metres: Optional[float]
    lane_angle_radians: Optional[float]
    light: Optional[str]
    stop_sign: bool
    red_lights_run: int
    stop_signs_run: int
    repositioned: int

    @staticmethod
    def from_json(truth: Optional[Mapping[str, Any]]) -> Optional[DriveTruth]:
        """The truth of a label; None if it has none."""
        if truth is None:
            return None
        return DriveTruth(
            number(truth["drivenMetres"]),
            optional(text, truth["collision"]),
            flag(truth["outsideLanes"]),
            optional(number, truth["laneOffsetMetres"]),
            optional(number, truth["laneAngleRadians"]),
            optional(text, truth["light"]),
            flag(truth["stopSign"]),
            integer(truth["redLightsRun"]),
            integer(truth["stopSignsRun"]),
            integer(truth["repositioned"]),
        )


@dataclass(frozen=True)
class DriveTarget:
    """What a controller aimed at: a speed (m/s), and a line by its distance to the right of the car (m); None if that is unknown."""

    speed: float
    right_metres: Optional[float]

    @staticmethod
    def from_json(target: Optional[Mapping[str, Any]]) -> Optional[DriveTarget]:
        """The target of a label; None for null."""
        return None if target is None else DriveTarget(number(target["speed"]), optional(number, target["rightMetres"]))


@dataclass(frozen=True)
class Drive:
    """The action that belongs to a frame: the answer of its driver, and the ticks up to the next frame.

    indicators has the 13 numbers of INDICATOR_NAMES, scaled to TORCS; None if the driver answered by controls.
    """

    driver: str
    controls: Optional[Controls]
    answer_seconds: Optional[float]
    applied: Optional[Controls]
    disturbed: bool
    indicators: Optional[Tuple[float, ...]]
    target: Optional[DriveTarget]
    route: Optional[str]
    route_metres: Optional[float]
    speed: float
    acceleration: Optional[Vector]
    angular_rate: Optional[Vector]
    bridge_frame: Optional[int]
    truth: Optional[DriveTruth]
    ticks: Tuple[DriveTick, ...]

    @staticmethod
    def from_json(drive: Mapping[str, Any]) -> Drive:
        """The action of a label. Raises ValueError for an unknown driver and a wrong number of indicators."""
        indicators = drive["indicators"]
        if indicators is not None and len(indicators) != len(INDICATOR_NAMES):
            raise ValueError(f"there are {len(indicators)} indicators")
        return Drive(
            driver=_driver(drive["driver"]),
            controls=Controls.from_json(drive["controls"]),
            answer_seconds=optional(number, drive["answerSeconds"]),
            applied=Controls.from_json(drive["applied"]),
            disturbed=flag(drive["disturbed"]),
            indicators=None if indicators is None else each(number, indicators),
            target=DriveTarget.from_json(drive.get("target")),
            route=optional(text, drive["route"]),
            route_metres=optional(number, drive["routeMetres"]),
            speed=number(drive["speed"]),
            acceleration=optional(vector, drive["acceleration"]),
            angular_rate=optional(vector, drive["angularRate"]),
            bridge_frame=optional(integer, drive["bridgeFrame"]),
            truth=DriveTruth.from_json(drive["truth"]),
            ticks=each(DriveTick.from_json, drive["ticks"]),
        )
