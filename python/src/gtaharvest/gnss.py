"""What the satellite receiver reported between frames."""

from __future__ import annotations

from typing import Any

import numpy as np

from .camera import Array
from .checks import each, number

GNSS_COLUMNS = 7


def gnss_rows(part: Any) -> Array:
    """The samples of a label's gnss, (samples, 7): time, latitude, longitude, altitude, velocity (3).

    Raises ValueError for other lengths.
    """
    times = each(number, part["timesSeconds"])
    positions = each(number, part["positions"])
    velocities = each(number, part["velocities"])
    if len(positions) != 3 * len(times) or len(velocities) != 3 * len(times):
        raise ValueError("gnss does not have three numbers of each kind for each time")
    table = np.empty((len(times), GNSS_COLUMNS))
    table[:, 0] = times
    table[:, 1:4] = np.reshape(positions, (-1, 3))
    table[:, 4:] = np.reshape(velocities, (-1, 3))
    return table
