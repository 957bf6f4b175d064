"""The reward of a step."""

from __future__ import annotations

import dataclasses
from typing import Any, Dict


@dataclasses.dataclass(frozen=True)
class Reward:
    """Weights of the terms whose sum is the reward of a step. A term that the game knows nothing of, as in GTA V, is 0."""

    metres: float = 0.1
    """For each metre driven."""

    offset: float = -0.1
    """For each metre driven at one metre from the centre of the lane; proportional to both."""

    outside: float = -1.0
    """For each second with a part of the car outside the lanes of its direction."""

    collision: float = -10.0
    """For each collision."""

    red_light: float = -5.0
    """For each red light run."""

    stop_sign: float = -5.0
    """For each stop sign run."""

    steering: float = -0.05
    """For a change of the steering by 1, from lock to straight."""

    standing: float = -0.1
    """For each second at less than 0.5 m/s, unless a light ahead is not green, or a stop sign is there."""

    def terms(self, before: Dict[str, Any], after: Dict[str, Any]) -> Dict[str, float]:
        """The terms of the step between two frames, whose sum is its reward."""
        seconds = after["timeSeconds"] - before["timeSeconds"]
        metres = (
            after["speedMetresPerSecond"] * seconds
            if after.get("drivenMetres") is None
            else after["drivenMetres"] - before["drivenMetres"]
        )
        steered = abs((after.get("appliedControls") or (0,))[0] - (before.get("appliedControls") or (0,))[0])
        may_stand = after.get("light") in ("amber", "red") or bool(after.get("stopSign"))
        stands = after["speedMetresPerSecond"] < 0.5 and not may_stand
        return {
            "metres": self.metres * metres,
            "offset": self.offset * metres * abs(after.get("laneOffsetMetres") or 0.0),
            "outside": self.outside * seconds * bool(after.get("outsideLanes")),
            "collision": self.collision * (sum(after.get("collisions") or ()) - sum(before.get("collisions") or ())),
            "red_light": self.red_light * _more("redLightsRun", before, after),
            "stop_sign": self.stop_sign * _more("stopSignsRun", before, after),
            "steering": self.steering * steered,
            "standing": self.standing * seconds * stands,
        }


def _more(name: str, before: Dict[str, Any], after: Dict[str, Any]) -> int:
    return int((after.get(name) or 0) - (before.get(name) or 0))
