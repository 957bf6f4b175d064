"""The samples of the inertial unit."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from conftest import HandmadeSession

import gtaharvest

SAMPLES = {
    "timesSeconds": [0.25, 0.5],
    "angularRates": [1.0, 2.0, 3.0, 4.0, 5.0, 6.0],
    "specificForces": [7.0, 8.0, 9.0, 10.0, 11.0, 12.0],
}


def test_imu_has_a_row_for_each_sample(tmp_path: Path) -> None:
    session = HandmadeSession(tmp_path / "measured")
    session.lines[0]["imu"] = SAMPLES
    first, second = list(gtaharvest.open_session(session.write()))[:2]

    assert first.imu is not None
    np.testing.assert_array_equal(first.imu, [[0.25, 1, 2, 3, 7, 8, 9], [0.5, 4, 5, 6, 10, 11, 12]])
    assert second.imu is None


@pytest.mark.parametrize("key", SAMPLES)
def test_imu_of_other_lengths_is_an_error(tmp_path: Path, key: str) -> None:
    session = HandmadeSession(tmp_path / "measured")
    session.lines[0]["imu"] = {**SAMPLES, key: [1.0]}

    with pytest.raises(gtaharvest.LabelError, match="three numbers"):
        gtaharvest.open_session(session.write())[0].imu
