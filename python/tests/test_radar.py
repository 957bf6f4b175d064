"""The detections of radars."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from conftest import HandmadeSession

import gtaharvest
from gtaharvest.radar import RADAR_COLUMNS


def test_radar_has_a_row_for_each_detection(tmp_path: Path) -> None:
    session = HandmadeSession(tmp_path / "detected")
    scan = {name: [float(place), float(place + 10)] for place, name in enumerate(RADAR_COLUMNS)}
    session.lines[0]["radar"] = [{"sensor": "ahead", **scan}]
    first, second = list(gtaharvest.open_session(session.write()))[:2]

    assert list(first.radars) == ["ahead"]
    np.testing.assert_array_equal(first.radars["ahead"], [range(8), range(10, 18)])
    assert second.radars == {}


def test_lists_of_different_lengths_are_an_error(tmp_path: Path) -> None:
    session = HandmadeSession(tmp_path / "detected")
    session.lines[0]["radar"] = [{"sensor": "ahead", **{name: [1.0] for name in RADAR_COLUMNS}, "ranges": []}]

    with pytest.raises(gtaharvest.LabelError, match="different lengths"):
        gtaharvest.open_session(session.write())[0].radars
