"""The detections of radars."""

from __future__ import annotations

from typing import Any, Dict

import numpy as np

from .camera import Array
from .checks import each, number, text

RADAR_COLUMNS = (
    "ranges",
    "azimuthsDegrees",
    "elevationsDegrees",
    "radialVelocities",
    "groundVelocities",
    "crossSections",
    "objects",
    "origins",
)


def radar_tables(scans: Any) -> Dict[str, Array]:
    """The detections in a label's radar by sensor, (detections, 8). Raises ValueError for lists of other lengths."""
    return dict(each(lambda scan: (text(scan["sensor"]), _table(scan)), scans))


def _table(scan: Any) -> Array:
    columns = [each(number, scan[name]) for name in RADAR_COLUMNS]
    if len({len(column) for column in columns}) != 1:
        raise ValueError("radar has lists of different lengths")
    return np.array(columns, dtype=np.float64).T
