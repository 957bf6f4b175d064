"""The sets of sessions and drives: which towns, weathers and hours are for training and which are held out."""
from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Dict, List, Mapping, Optional, Protocol, Tuple

TRAINING_WEATHERS = (
    "clear",
    "rain",
    "clouds",
    "extrasunny",
    "foggy",
    "neutral",
    "snow",
    "overcast",
    "clearing",
    "xmas",
)
OTHER_WEATHERS = ("smog", "thunder", "snowlight", "blizzard", "halloween")

SIZE = "280x210"
HZ = 5
TRAFFIC = 0.7


class Plan(Protocol):
    """A session to make."""

    def is_of(self, session: Mapping[str, Any]) -> bool:
        """Whether what session.json describes is of this plan, or longer."""


@dataclass(frozen=True)
class SessionPlan:
    """A session to harvest: its folder's name, and what the command needs."""

    name: str
    frames: int
    seed: int
    weather: str
    time: str
    wander: float = 1.0
    lane_changes: float = 1.0
    on_roads: bool = False

    def options(self, roads: Optional[str]) -> List[str]:
        """The options of harvester harvest, without its folder."""
        chosen = [
            "--frames",
            str(self.frames),
            "--seed",
            str(self.seed),
            "--size",
            SIZE,
            "--hz",
            str(HZ),
            "--weather",
            self.weather,
            "--time",
            self.time,
            "--traffic",
            str(TRAFFIC),
            "--wander",
            f"{self.wander:g}",
            "--lane-changes",
            f"{self.lane_changes:g}",
            "--places",
            str(max(1, self.frames // 20)),
            "--rays",
            "2000",
            "--ignore-range",
            "0",
            "--no-scenes",
            "--no-report",
            "--sync",
            "never",
        ]
        return [*chosen, "--roads", roads] if self.on_roads and roads else chosen

    def is_of(self, session: Mapping[str, Any]) -> bool:
        """Whether what session.json describes is of this plan, or has more frames."""
        return bool(session["seed"] == self.seed and session["counters"]["captured"] >= self.frames)


def _hour(number: int) -> str:
    """Hours all around the clock: consecutive sessions are seven hours apart."""
    return f"{number * 7 % 24:02}:{number * 17 % 60:02}"


def _towns(set_name: str, seeds: range, frames: int, weathers: Tuple[str, ...], **further: float) -> List[SessionPlan]:
    return [
        SessionPlan(f"{set_name}/{seed}", frames, seed, weathers[at % len(weathers)], _hour(at), **further)
        for at, seed in enumerate(seeds)
    ]


SETS: Dict[str, List[SessionPlan]] = {
    "train": _towns("train", range(101, 141), 500, TRAINING_WEATHERS),
    "validation": _towns("validation", range(151, 154), 200, TRAINING_WEATHERS),
    "towns": _towns("towns", range(201, 211), 200, TRAINING_WEATHERS),
    "weathers": _towns("weathers", range(221, 231), 200, OTHER_WEATHERS),
    "roads": [
        SessionPlan(f"roads/{seed}", 400, seed, weather, _hour(seed), on_roads=True)
        for seed, weather in zip(range(241, 246), TRAINING_WEATHERS)
    ],
    "straight": _towns("straight", range(101, 113), 500, TRAINING_WEATHERS, wander=0, lane_changes=0),
}
"""train to learn from, validation for the curves; towns, weathers and roads are seen only by the evaluation. straight has the first towns
of train, driven without wandering and lane changes."""


@dataclass(frozen=True)
class DrivePlan:
    """A drive to record: the folder's name of its session, the seed of its town, the sky, and the distance."""

    name: str
    seed: int
    weather: str
    time: str
    metres: int = 1500

    def options(self) -> List[str]:
        """The options of harvester drive, without its folders."""
        return [
            "--seed",
            str(self.seed),
            "--weather",
            self.weather,
            "--time",
            self.time,
            "--controller",
            "stanley",
            "--perturb",
            "--traffic",
            "0.5",
            "--distance",
            str(self.metres),
            "--duration",
            "240",
            "--size",
            SIZE,
        ]

    def is_of(self, session: Mapping[str, Any]) -> bool:
        """Whether what session.json describes is of this plan, or goes farther."""
        return bool(session["seed"] == self.seed and float(session["settings"]["distanceMetres"]) >= self.metres)


def _drives(set_name: str, seeds: range) -> List[DrivePlan]:
    return [
        DrivePlan(f"{set_name}/{seed}", seed, TRAINING_WEATHERS[at % len(TRAINING_WEATHERS)], _hour(at))
        for at, seed in enumerate(seeds)
    ]


DRIVES: Dict[str, List[DrivePlan]] = {
    "drives": _drives("drives", range(101, 121)),
    "unseen": _drives("unseen", range(261, 271)),
}
"""drives to imitate, in towns of the set train; unseen, in towns that no other set has, only for the evaluation."""
