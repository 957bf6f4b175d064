"""The motion of the ego between frames."""

from __future__ import annotations

from typing import Sequence

import numpy as np

from .camera import Array

MOTION_COLUMNS = 18
_LENGTHS = (13, 15, MOTION_COLUMNS)


def motion_rows(rows: Sequence[Sequence[float]]) -> Array:
    """The rows of a label's motion, (ticks, 18), with NaN for what is unknown. Raises ValueError for a row of another length."""
    table = np.full((len(rows), MOTION_COLUMNS), np.nan)
    for row, values in zip(table, rows):
        if len(values) not in _LENGTHS:
            raise ValueError(f"a row of motion has {len(values)} numbers")
        row[: len(values)] = values
    return table
