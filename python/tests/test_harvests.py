"""Sessions of the simulated game, read with all that the package has."""

from __future__ import annotations

import json
from pathlib import Path

import numpy as np
import pytest
from gtaharvest import open_session
from gtaharvest.draw import annotate

# Labels round pixels to 0.001, positions to 0.0001 m and axes to 1e-9.
ROUNDED_PIXELS = 0.02


def test_joints_project_to_the_pixels_of_the_library(harvests: Path) -> None:
    """With the lens of the session, whose labels the C# library computed."""
    checked = 0
    for frame in open_session(harvests / "masks"):
        assert frame.camera.lens.k1 == -0.08 and frame.camera.cx == pytest.approx(160 * 0.51)
        for item in frame.objects:
            for joint in item.joints or ():
                if joint.pixel is not None and item.distance_metres > 5:
                    assert frame.camera.project(joint.position).pixels == pytest.approx(joint.pixel, abs=ROUNDED_PIXELS)
                    checked += 1
    assert checked > 200


def test_lane_points_project_to_the_pixels_of_the_library(harvests: Path) -> None:
    checked = 0
    for frame in open_session(harvests / "masks"):
        assert frame.lanes is not None
        for line in (*frame.lanes.boundaries, *(frame.lanes.markings or ())):
            far = line.in_camera[:, 1] > 5
            np.testing.assert_allclose(frame.camera.to_camera(line.points), line.in_camera, atol=1e-3)
            np.testing.assert_allclose(
                frame.camera.project(line.points[far]).pixels, line.pixels[far], atol=ROUNDED_PIXELS
            )
            checked += int(far.sum())
    assert checked > 500


def test_boxes_of_the_labels_enclose_projected_cuboids_and_masks(harvests: Path) -> None:
    checked = 0
    for frame in open_session(harvests / "masks"):
        mask = frame.mask()
        for item in frame.objects:
            if item.box2d_visible is not None:
                rows, columns = np.nonzero(mask == item.id)
                box = (columns.min(), rows.min(), columns.max() + 1, rows.max() + 1)
                assert box == item.box2d_visible
            pixels = frame.camera.project(item.box3d.corners).pixels
            if np.isfinite(pixels).all() and item.distance_metres > 10:
                # With a lens edges bend, so that the box of the corners may be a little smaller than that of the silhouette.
                assert (*pixels.min(axis=0), *pixels.max(axis=0)) == pytest.approx(item.box2d_amodal, abs=0.5)
                checked += 1
    assert checked > 100


def test_true_occlusion_is_read(harvests: Path) -> None:
    fractions = [item.true_occluded_fraction for frame in open_session(harvests / "masks") for item in frame.objects]
    known = [fraction for fraction in fractions if fraction is not None]
    assert len(known) > 50 and any(fraction > 0 for fraction in known) and max(known) <= 1
    assert all(
        item.true_occluded_fraction is None for frame in open_session(harvests / "shard") for item in frame.objects
    )


@pytest.mark.parametrize("name", ["masks", "jpeg", "shard", "relabelled", "repaired"])
def test_every_session_is_read_whole(harvests: Path, name: str) -> None:
    session = open_session(harvests / name)
    lines = (session.folder / "labels.jsonl").read_text(encoding="utf-8").splitlines()
    assert len(session) == len(lines) > 1
    for frame, line in zip(session, lines):
        raw = json.loads(line)
        assert dict(frame.raw) == raw and session.frame(raw["frame"]).number == raw["frame"]
        assert [item.id for item in frame.objects] == [item["id"] for item in raw["objects"]]
        assert len(frame.view.arrays()) == len(raw["objects"]) and len(frame.view.ignore_regions) == len(
            raw["ignoreRegions"]
        )
        assert frame.image().shape == (120, 160, 3) and frame.ego.model == raw["ego"]["model"]
        assert frame.lanes is not None and frame.lanes.status == raw["lanes"]["status"]
        assert annotate(frame.view, "3d").shape == (120, 160, 3)
    tracks = session.tracks()
    assert sum(len(track.labels) for track in tracks.values()) == sum(
        len(json.loads(line)["objects"]) for line in lines
    )
    longest = max(tracks.values(), key=lambda track: len(track.frames))
    assert session.track(longest.id) == longest
