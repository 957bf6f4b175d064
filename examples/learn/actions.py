"""The recorded actions of a drive, as a policy learns them."""
from __future__ import annotations

from typing import Any, Mapping, Optional, Tuple

import numpy as np

ROUTES = ("left", "straight", "right")


def controls_of(drive: Mapping[str, Any]) -> Tuple[float, float, float]:
    """Steering, throttle and brake; NaN where none are recorded."""
    controls = drive.get("controls")
    return (np.nan,) * 3 if controls is None else (controls["steering"], controls["throttle"], controls["brake"])


def route_of(drive: Mapping[str, Any]) -> float:
    """Index of the route command in ROUTES, or NaN without a route command."""
    route = drive.get("route")
    return ROUTES.index(route) if route in ROUTES else np.nan


POLICY_OUTPUTS = 2
"""A policy gives steering, in units of STEERING_SCALE, and pedal: throttle, or less than 0 for the brake."""

STEERING_SCALE = 0.1

EXTRAS = 1 + len(ROUTES)
"""A policy also takes the speed and the route command."""

_SPEED = 10.0


def extras_of(speed: float, route: Optional[str]) -> np.ndarray:
    """The further inputs of a policy."""
    return np.array([speed / _SPEED, *(route == name for name in ROUTES)], np.float32)
