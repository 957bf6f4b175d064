"""What the inertial unit measured between frames."""

from __future__ import annotations

from typing import Any

import numpy as np

from .camera import Array
from .checks import each, number

IMU_COLUMNS = 7


def imu_rows(part: Any) -> Array:
    """The samples of a label's imu, (samples, 7): time, angular rate (3), specific force (3). Raises ValueError for other lengths."""
    times = each(number, part["timesSeconds"])
    rates = each(number, part["angularRates"])
    forces = each(number, part["specificForces"])
    if len(rates) != 3 * len(times) or len(forces) != 3 * len(times):
        raise ValueError("imu does not have three numbers of each kind for each time")
    table = np.empty((len(times), IMU_COLUMNS))
    table[:, 0] = times
    table[:, 1:4] = np.reshape(rates, (-1, 3))
    table[:, 4:] = np.reshape(forces, (-1, 3))
    return table
