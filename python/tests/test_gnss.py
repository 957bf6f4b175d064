"""The samples of the satellite receiver."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from conftest import HandmadeSession

import gtaharvest

SAMPLES = {
    "timesSeconds": [0.25, 0.5],
    "positions": [34.0, -118.0, 3.0, 34.1, -118.1, 6.0],
    "velocities": [7.0, 8.0, 9.0, 10.0, 11.0, 12.0],
}


def test_gnss_has_a_row_for_each_sample(tmp_path: Path) -> None:
    session = HandmadeSession(tmp_path / "located")
    session.lines[0]["gnss"] = SAMPLES
    first, second = list(gtaharvest.open_session(session.write()))[:2]

    assert first.gnss is not None
    np.testing.assert_array_equal(first.gnss, [[0.25, 34, -118, 3, 7, 8, 9], [0.5, 34.1, -118.1, 6, 10, 11, 12]])
    assert second.gnss is None


@pytest.mark.parametrize("key", SAMPLES)
def test_gnss_of_other_lengths_is_an_error(tmp_path: Path, key: str) -> None:
    session = HandmadeSession(tmp_path / "located")
    session.lines[0]["gnss"] = {**SAMPLES, key: [1.0]}

    with pytest.raises(gtaharvest.LabelError, match="three numbers"):
        gtaharvest.open_session(session.write())[0].gnss
