"""The motion between frames."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from conftest import HandmadeSession

import gtaharvest


def test_rows_are_filled_up_with_nan(tmp_path: Path) -> None:
    session = HandmadeSession(tmp_path / "moving")
    session.lines[0]["motion"] = [[float(number) for number in range(13)], [float(number) for number in range(18)]]
    first, second = list(gtaharvest.open_session(session.write()))[:2]

    assert first.motion is not None and first.motion.shape == (2, 18)
    np.testing.assert_array_equal(first.motion[1], range(18))
    assert np.isnan(first.motion[0, 13:]).all() and first.motion[0, 12] == 12
    assert second.motion is None


def test_row_of_another_length_is_an_error(tmp_path: Path) -> None:
    session = HandmadeSession(tmp_path / "moving")
    session.lines[0]["motion"] = [[1.0, 2.0]]

    with pytest.raises(gtaharvest.LabelError, match="2 numbers"):
        gtaharvest.open_session(session.write())[0].motion
