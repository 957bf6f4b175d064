"""The camera against the vectors that the C# tests read too, and against OpenCV."""

from __future__ import annotations

import csv
import math
from pathlib import Path
from typing import Any, Dict, List

import numpy as np
import pytest
from gtaharvest import Camera, Lens

VECTORS = Path(__file__).resolve().parents[2] / "tests/Geometry.Tests/Cameras"

# The demand.
PIXELS = 1e-9
# Coordinates are up to 4 km, whose last binary digit is 5e-13 m, and a lens multiplies it by up to 10.
METRES = 1e-9


def rows(name: str) -> List[Dict[str, str]]:
    with open(VECTORS / name, newline="", encoding="utf-8") as stream:
        return list(csv.DictReader(stream, restkey="rest"))


def camera_of(row: Dict[str, str], near: float, posed: bool) -> Camera:
    number = {
        key: float(value) for key, value in row.items() if key not in ("case", "outcome", "source", "tolerance", "rest")
    }
    axes = (
        [tuple(number[f"{name}{axis}"] for axis in "XYZ") for name in ("position", "right", "forward", "up")]
        if posed
        else [(0.0, 0.0, 0.0), (1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)]
    )
    width, height = int(number["width"]), int(number["height"])
    return Camera(
        *axes,
        vertical_fov_degrees=number["fovDegrees"],
        width=width,
        height=height,
        window_aspect=number["windowAspect"],
        near_clip=near,
        focal_scale=number["focalScale"],
        cx=width * (0.5 + number["centreX"]),
        cy=height * (0.5 + number["centreY"]),
        lens=Lens(number["k1"], number["k2"]),
    )


@pytest.mark.parametrize("row", rows("projection.csv"), ids=lambda row: row["case"])
def test_projects_as_the_library_at_the_origin(row: Dict[str, str]) -> None:
    check(camera_of(row, 0.1, posed=False), [float(row[axis]) for axis in "xyz"], row)


@pytest.mark.parametrize("row", rows("posed-projection.csv"), ids=lambda row: row["case"])
def test_projects_and_unprojects_as_the_library(row: Dict[str, str]) -> None:
    camera, point = camera_of(row, 0.15, posed=True), [float(row[f"point{axis}"]) for axis in "XYZ"]
    check(camera, point, row)
    if row["outcome"] != "BehindNearPlane":
        pixel, depth = [float(row["u"]), float(row["v"])], float(row["depth"])
        assert camera.unproject(pixel, depth) == pytest.approx(point, abs=METRES, rel=0)
        along = np.array(point) - camera.position
        assert camera.directions(pixel) == pytest.approx(along / np.linalg.norm(along), abs=1e-12)


def check(camera: Camera, point: Any, row: Dict[str, str]) -> None:
    seen = camera.project(point)
    assert float(seen.depths) == pytest.approx(float(row["depth"]), abs=PIXELS, rel=0)
    assert bool(seen.in_image) == (row["outcome"] == "InImage")
    if row["outcome"] == "BehindNearPlane":
        assert np.isnan(seen.pixels).all()
    else:
        assert seen.pixels == pytest.approx([float(row["u"]), float(row["v"])], abs=PIXELS, rel=0)


def test_projects_many_points_as_one_by_one() -> None:
    camera = camera_of(rows("posed-projection.csv")[8], 0.15, posed=True)
    points = np.random.default_rng(1).normal(size=(4, 5, 3)) * 50 + camera.position
    together = camera.project(points)
    assert together.pixels.shape == (4, 5, 2) and together.depths.shape == together.in_image.shape == (4, 5)
    for index in np.ndindex(4, 5):
        alone = camera.project(points[index])
        np.testing.assert_allclose(together.pixels[index], alone.pixels, rtol=1e-14)
        assert together.in_image[index] == alone.in_image


@pytest.mark.parametrize("lens", [Lens(), Lens(-0.35), Lens(0.15, 0.02), Lens(0.05, -0.02), Lens(-0.2, 0.05)])
def test_undistort_is_the_inverse_of_distort_also_beyond_the_fold(lens: Lens) -> None:
    # Up to 89 degrees from the axis.
    radius = np.concatenate([[0], np.geomspace(1e-6, math.tan(math.radians(89)), 400)])
    ideal = np.stack([radius * 0.6, radius * -0.8], axis=-1)
    shown = lens.distort(ideal)
    assert np.all(np.diff(np.hypot(shown[:, 0], shown[:, 1])) > 0)
    np.testing.assert_allclose(lens.undistort(shown), ideal, rtol=1e-12)


def test_unproject_refuses_a_depth_that_is_not_positive() -> None:
    camera = camera_of(rows("posed-projection.csv")[0], 0.15, posed=True)
    for depth in (0.0, -1.0, math.nan):
        with pytest.raises(ValueError, match="positive"):
            camera.unproject([1, 1], depth)


def test_agrees_with_opencv_within_the_fold() -> None:
    cv2 = pytest.importorskip("cv2")
    for row in rows("posed-projection.csv"):
        if row["outcome"] != "InImage" or row["case"].startswith(("folding", "late fold")):
            continue
        camera, point = camera_of(row, 0.15, posed=True), [float(row[f"point{axis}"]) for axis in "XYZ"]
        right, forward, up = camera.axes
        # OpenCV: x right, y down, z forward, and the centre of the first pixel is 0.
        rotation = np.array([right, -up, forward])
        moved = rotation @ (np.array(point) - camera.position)
        seen, _ = cv2.projectPoints(
            moved.reshape(1, 1, 3),
            np.zeros(3),
            np.zeros(3),
            camera.matrix,
            np.array([camera.lens.k1, camera.lens.k2, 0, 0]),
        )
        assert camera.project(point).pixels - 0.5 == pytest.approx(seen.ravel(), abs=1e-8)
