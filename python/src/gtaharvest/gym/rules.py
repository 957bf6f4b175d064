"""When an episode ends."""

from __future__ import annotations

import dataclasses
from typing import Any, Dict, Optional, Tuple


@dataclasses.dataclass(frozen=True)
class Ending:
    """What ends an episode. None switches a limit off. What the game knows nothing of, as in GTA V, ends none."""

    collision: bool = True
    """Terminated by a collision."""

    outside_seconds: Optional[float] = 1.0
    """Terminated when a part of the car has been outside the lanes of its direction for longer, seconds."""

    red_light: bool = False
    """Terminated by running a red light."""

    stop_sign: bool = False
    """Terminated by running a stop sign."""

    seconds: Optional[float] = 120.0
    """Truncated after this time, seconds of the game."""

    metres: Optional[float] = None
    """Truncated after this distance."""

    standing_seconds: Optional[float] = 60.0
    """Truncated when the car has stood for longer, seconds."""


class Rules:
    """Follows an episode and decides whether it has ended."""

    def __init__(self, ending: Ending, first: Dict[str, Any]) -> None:
        self._ending = ending
        self._first = first
        self._last = first
        self._outside = 0.0
        self._standing = 0.0
        self._metres = 0.0

    def judge(self, frame: Dict[str, Any]) -> Tuple[Optional[str], Optional[str]]:
        """Takes the next frame: the reasons why the episode is terminated and truncated; None if it is not."""
        ending, last = self._ending, self._last
        seconds = frame["timeSeconds"] - last["timeSeconds"]
        self._outside = self._outside + seconds if frame.get("outsideLanes") else 0.0
        self._standing = self._standing + seconds if frame["speedMetresPerSecond"] < 0.1 else 0.0
        self._metres += frame["speedMetresPerSecond"] * seconds
        self._last = frame
        metres = (
            self._metres if frame.get("drivenMetres") is None else frame["drivenMetres"] - self._first["drivenMetres"]
        )
        terminated = next(
            (
                reason
                for reason, is_so in (
                    ("collision", ending.collision and _total(frame) > _total(last)),
                    ("outside", _exceeds(self._outside, ending.outside_seconds)),
                    (
                        "red_light",
                        ending.red_light and (frame.get("redLightsRun") or 0) > (last.get("redLightsRun") or 0),
                    ),
                    (
                        "stop_sign",
                        ending.stop_sign and (frame.get("stopSignsRun") or 0) > (last.get("stopSignsRun") or 0),
                    ),
                )
                if is_so
            ),
            None,
        )
        truncated = next(
            (
                reason
                for reason, is_so in (
                    ("seconds", _reaches(frame["timeSeconds"] - self._first["timeSeconds"], ending.seconds)),
                    ("metres", _reaches(metres, ending.metres)),
                    ("standing", _exceeds(self._standing, ending.standing_seconds)),
                    ("repositioned", (frame.get("repositioned") or 0) > (last.get("repositioned") or 0)),
                )
                if is_so
            ),
            None,
        )
        return terminated, truncated


def _total(frame: Dict[str, Any]) -> int:
    return sum(frame.get("collisions") or ())


_ROUNDING = 1e-6


def _exceeds(value: float, limit: Optional[float]) -> bool:
    return limit is not None and value > limit + _ROUNDING


def _reaches(value: float, limit: Optional[float]) -> bool:
    return limit is not None and value >= limit - _ROUNDING
