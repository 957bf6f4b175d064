"""The points of a LiDAR."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
import numpy.typing as npt

from .errors import MissingPictureError, PictureError
from .files import read_regular

Points = npt.NDArray[Any]

POINT_TYPE = np.dtype(
    [
        ("position", "<f4", (3,)),
        ("intensity", "<f4"),
        ("column", "<u2"),
        ("beam", "<u2"),
        ("object_id", "<u2"),
        ("class", "u1"),
        ("flags", "u1"),
    ]
)
"""A point: position to the right, ahead and above of the sensor in metres, and what docs/rigs.md says of the other fields."""


MAX_POINTS = 2_000_000
"""The most points of a LiDAR at a moment."""


def read_points(path: Path) -> Points:
    """Reads a file of points. Raises MissingPictureError if it does not exist, and PictureError if it cannot be read or is cut off."""
    try:
        content = read_regular(path, MAX_POINTS * POINT_TYPE.itemsize)
    except FileNotFoundError:
        raise MissingPictureError(f"{path}: the file does not exist.") from None
    except OSError as problem:
        raise PictureError(f"{path}: the points cannot be read: {problem.strerror}.") from None
    if len(content) % POINT_TYPE.itemsize:
        raise PictureError(
            f"{path}: it has {len(content)} bytes, which is no multiple of the {POINT_TYPE.itemsize} of a point."
        )
    return np.frombuffer(content, dtype=POINT_TYPE)
