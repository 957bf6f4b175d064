"""The state of a frame as numbers."""

from __future__ import annotations

import math
from typing import Any, Dict, List, Tuple

import numpy as np
import numpy.typing as npt

from ..lanes import INDICATOR_NAMES

NO_JUNCTION_METRES = 100.0
"""Stands for the distance to the next junction if none is near."""

_ROUTES = ("left", "straight", "right")
_LIGHTS = ("green", "amber", "red")


def _indicator_bounds(name: str) -> Tuple[str, float, float]:
    if name == "angle":
        return name, -math.pi, math.pi
    return (name, 0.0, 100.0) if name.startswith("dist") else (name, -20.0, 20.0)


_FIELDS: List[Tuple[str, float, float]] = [
    ("speed", 0, 100),
    *(_indicator_bounds(name) for name in INDICATOR_NAMES),
    ("lanesKnown", 0, 1),
    ("fast", 0, 1),
    *((f"route:{name}", 0.0, 1.0) for name in _ROUTES),
    ("routeMetres", 0, NO_JUNCTION_METRES),
    *((f"light:{name}", 0.0, 1.0) for name in _LIGHTS),
    ("stopSign", 0, 1),
    ("steering", -1, 1),
    ("throttle", 0, 1),
    ("brake", 0, 1),
    ("builtInDriver", 0, 1),
]

STATE_NAMES: Tuple[str, ...] = tuple(name for name, _, _ in _FIELDS)
"""What the numbers of a state are, in order."""

STATE_LOW: npt.NDArray[np.float32] = np.array([low for _, low, _ in _FIELDS], np.float32)
STATE_HIGH: npt.NDArray[np.float32] = np.array([high for _, _, high in _FIELDS], np.float32)


def state_of(frame: Dict[str, Any]) -> npt.NDArray[np.float32]:
    """The state of a frame, cut to its bounds. What the game does not know is 0, and a junction that is not near 100 m away."""
    route, light, metres = frame.get("route"), frame.get("light"), frame.get("routeMetres")
    values = [
        frame["speedMetresPerSecond"],
        *frame["indicators"],
        frame["lanesKnown"],
        frame["fast"],
        *(route == name for name in _ROUTES),
        NO_JUNCTION_METRES if metres is None else metres,
        *(light == name for name in _LIGHTS),
        bool(frame.get("stopSign")),
        *(frame.get("appliedControls") or (0, 0, 0)),
        bool(frame.get("builtInDriver")),
    ]
    state: npt.NDArray[np.float32] = np.clip(np.array(values, np.float32), STATE_LOW, STATE_HIGH)
    return state
