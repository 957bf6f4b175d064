"""The motion of the ego between frames."""

from __future__ import annotations

from typing import Any

import numpy as np

from .camera import Array
from .checks import each, number, optional

MOTION_COLUMNS = 18
_LENGTHS = (13, 15, MOTION_COLUMNS)


def motion_rows(rows: Any) -> Array:
    """The rows of a label's motion, (ticks, 18), with NaN for what is unknown. Raises ValueError for a row of another length."""
    ticks = each(_row, rows)
    table = np.full((len(ticks), MOTION_COLUMNS), np.nan)
    for row, values in zip(table, ticks):
        row[: len(values)] = values
    return table


def _row(values: Any) -> Any:
    row = each(lambda value: optional(number, value), values)
    if len(row) not in _LENGTHS:
        raise ValueError(f"a row of motion has {len(row)} numbers")
    return row
