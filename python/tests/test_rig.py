"""Sessions that were harvested with a rig, written by hand."""

from __future__ import annotations

import struct
from pathlib import Path

import numpy as np
import pytest
from conftest import HandmadeSession

import gtaharvest


@pytest.fixture
def rig(tmp_path: Path) -> Path:
    """Two views of a moment; the first has a LiDAR with two points."""
    session = HandmadeSession(tmp_path / "rig")
    del session.lines[2]
    for line, view in zip(session.lines, ("left", "right")):
        line.update(moment=0, view=view)
    session.lines[0]["lidar"] = [{"sensor": "top", "file": "lidar/top/00000000.bin", "points": 2, "raysCast": 2}]
    session.info["rig"] = {"name": "pair", "cameras": [{"name": "left"}, {"name": "right"}]}
    folder = session.write()
    (folder / "lidar" / "top").mkdir(parents=True)
    (folder / "lidar" / "top" / "00000000.bin").write_bytes(
        struct.pack("<4f3H2B", 1, 2, 3, 0.5, 7, 4, 12, 11, 0) + struct.pack("<4f3H2B", -1, 0, 1, 0.25, 8, 5, 0, 1, 1)
    )
    return folder


def test_moments_have_their_views_by_name(rig: Path) -> None:
    session = gtaharvest.open_session(rig)
    (moment,) = session.moments()

    assert session.view_names == ("left", "right") == tuple(moment)
    assert [frame.moment for frame in moment.values()] == [0, 0]
    assert moment["right"].view.name == "right"


def test_points_are_those_of_the_file(rig: Path) -> None:
    left, right = gtaharvest.open_session(rig)
    points = left.points("top")

    np.testing.assert_array_equal(points["position"], [[1, 2, 3], [-1, 0, 1]])
    assert (
        points["object_id"].tolist() == [12, 0]
        and points["class"].tolist() == [11, 1]
        and points["beam"].tolist() == [4, 5]
    )
    with pytest.raises(KeyError):
        right.points("top")


def test_cut_off_points_are_refused(rig: Path) -> None:
    path = rig / "lidar" / "top" / "00000000.bin"
    path.write_bytes(path.read_bytes()[:-1])

    with pytest.raises(gtaharvest.PictureError, match="47 bytes"):
        gtaharvest.open_session(rig)[0].points("top")
