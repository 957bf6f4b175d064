"""The events of a session: what happened between road users."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, Mapping, Optional, Tuple

from .checks import Vector, each, integer, number, optional, text, vector

EVENT_KINDS = (
    "nearMiss",
    "hardBraking",
    "collision",
    "cutIn",
    "redLightRun",
    "stopSignRun",
    "offRoad",
    "wrongWay",
)
"""The kinds of events, by the names in files."""


@dataclass(frozen=True)
class EventMark:
    """An event that is open at the moment of a frame."""

    id: int
    kind: str

    @staticmethod
    def from_json(value: Mapping[str, Any]) -> EventMark:
        """Reads an entry of a label's events."""
        return EventMark(integer(value["id"]), text(value["kind"]))


@dataclass(frozen=True)
class Participant:
    """A road user of an event, at its peak. object is its id in labels and class_name its class; both are None for the ego."""

    object: Optional[int]
    class_name: Optional[str]
    model: str
    position: Vector
    right: Vector
    forward: Vector
    up: Vector
    model_min: Vector
    model_max: Vector
    velocity: Vector
    yaw_rate: float

    @staticmethod
    def from_json(value: Mapping[str, Any]) -> Participant:
        """Reads a participant of a line of events.jsonl."""
        return Participant(
            optional(integer, value["object"]),
            optional(text, value["class"]),
            text(value["model"]),
            vector(value["position"]),
            vector(value["right"]),
            vector(value["forward"]),
            vector(value["up"]),
            vector(value["modelMin"]),
            vector(value["modelMax"]),
            vector(value["velocity"]),
            number(value["yawRate"]),
        )


@dataclass(frozen=True)
class Contact:
    """Where two participants touched first, and how hard: metres, m/s, N s."""

    position: Vector
    on_first: Tuple[float, float]
    on_second: Tuple[float, float]
    relative_speed: float
    first_speed_change: float
    second_speed_change: float
    impulse: float
    impulse_min: float
    impulse_max: float

    @staticmethod
    def from_json(value: Mapping[str, Any]) -> Contact:
        """Reads the contact of a line of events.jsonl."""
        (first_right, first_forward), (second_right, second_forward) = value["onFirst"], value["onSecond"]
        return Contact(
            vector(value["position"]),
            (number(first_right), number(first_forward)),
            (number(second_right), number(second_forward)),
            number(value["relativeSpeed"]),
            number(value["firstSpeedChange"]),
            number(value["secondSpeedChange"]),
            number(value["impulse"]),
            number(value["impulseMin"]),
            number(value["impulseMax"]),
        )


@dataclass(frozen=True)
class Event:
    """An event. measures has numbers by name, None where unknown; docs/events.md has their units."""

    id: int
    kind: str
    begin_seconds: float
    peak_seconds: float
    end_seconds: float
    end: str
    first_frame: Optional[int]
    last_frame: Optional[int]
    participants: Tuple[Participant, ...]
    measures: Dict[str, Optional[float]]
    contact: Optional[Contact]

    @staticmethod
    def from_json(value: Mapping[str, Any]) -> Event:
        """Reads a line of events.jsonl."""
        return Event(
            integer(value["id"]),
            text(value["kind"]),
            number(value["beginSeconds"]),
            number(value["peakSeconds"]),
            number(value["endSeconds"]),
            text(value["end"]),
            optional(integer, value["firstFrame"]),
            optional(integer, value["lastFrame"]),
            each(Participant.from_json, value["participants"]),
            {text(name): optional(number, measure) for name, measure in value["measures"].items()},
            Contact.from_json(value["contact"]) if "contact" in value else None,
        )
