"""Further pictures of moments, written by hand."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from conftest import HEIGHT, WIDTH, HandmadeSession

import gtaharvest
from gtaharvest import png


@pytest.fixture
def session(tmp_path: Path) -> Path:
    """The first frame has a picture in the rain without object 7, and one that was dropped."""
    made = HandmadeSession(tmp_path / "pairs")
    made.lines[0]["pairs"] = [
        {"file": "pairs/00000000/rain-06-without-7.png", "weather": "rain", "timeOfDay": "06:00:00", "without": [7]},
        {"file": None, "weather": "snow", "timeOfDay": "06:00:00", "without": [], "dropped": "unsettled"},
    ]
    folder = made.write()
    (folder / "pairs" / "00000000").mkdir(parents=True)
    (folder / "pairs" / "00000000" / "rain-06-without-7.png").write_bytes(
        png.encode(np.full((HEIGHT, WIDTH, 3), 99, np.uint8))
    )
    return folder


def test_pairs_say_what_they_show(session: Path) -> None:
    first, second = list(gtaharvest.open_session(session))[:2]
    rain, snow = first.pairs

    assert (rain.weather, rain.time_of_day, rain.without, rain.dropped) == ("rain", "06:00:00", (7,), None)
    assert (snow.file, snow.dropped) == (None, "unsettled")
    assert second.pairs == ()


def test_picture_of_a_pair_is_that_of_its_file(session: Path) -> None:
    frame = gtaharvest.open_session(session)[0]

    assert frame.pair_image(frame.pairs[0]).shape == (HEIGHT, WIDTH, 3) and np.all(
        frame.pair_image(frame.pairs[0]) == 99
    )
    with pytest.raises(gtaharvest.MissingPictureError, match="unsettled"):
        frame.pair_image(frame.pairs[1])
