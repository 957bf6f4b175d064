"""Sessions for the tests: small ones written here by hand, and with --harvests real ones of the simulated game."""

from __future__ import annotations

import copy
import json
from pathlib import Path
from typing import Any, Dict, List

import numpy as np
import pytest

from gtaharvest import png

ROOT = Path(__file__).resolve().parents[2]
WIDTH, HEIGHT = 80, 60


def pytest_addoption(parser: pytest.Parser) -> None:
    parser.addoption("--harvests", type=Path, help="folder with harvested sessions, as tests/Python/run makes them")


@pytest.fixture(scope="session")
def harvests(request: pytest.FixtureRequest) -> Path:
    folder = request.config.getoption("--harvests")
    if folder is None:
        pytest.skip("needs harvested sessions; run tests/Python/run")
    return Path(folder)


def camera() -> Dict[str, Any]:
    """At the origin, looking north. With a vertical field of view of 90 degrees, fx = fy = 30: a metre at 10 m is 3 pixels."""
    return {
        "position": [0, 0, 0],
        "right": [1, 0, 0],
        "forward": [0, 1, 0],
        "up": [0, 0, 1],
        "verticalFovDegrees": 90,
        "width": WIDTH,
        "height": HEIGHT,
        "windowAspect": WIDTH / HEIGHT,
        "nearClip": 0.15,
        "fx": 30,
        "fy": 30,
        "cx": 40,
        "cy": 30,
        "distortion": {"focalScale": 1, "k1": 0, "k2": 0},
    }


def car(id: int, x: float, y: float) -> Dict[str, Any]:
    """A cube of 2 m around (x, y, 0), seen from behind: its rear side is nearest."""
    left, right = (40 + 30 * (x + side) / (y - 1) for side in (-1, 1))
    half = 30 / (y - 1)
    box = [left, 30 - half, right, 30 + half]
    return {
        "id": id,
        "class": "car",
        "model": "blista",
        "name": None,
        "parent": None,
        "knownParts": None,
        "hasRider": None,
        "box2d": box,
        "box2dAmodal": box,
        "box2dVisible": None,
        "boxes": ["cuboid", "amodal"],
        "truncatedFraction": 0,
        "occludedFraction": 0.25,
        "occlusionMethod": "rays",
        "visibleFraction": 0.75,
        "box3d": {
            "centre": [x, y, 0],
            "halfExtents": [1, 1, 1],
            "right": [1, 0, 0],
            "forward": [0, 1, 0],
            "up": [0, 0, 1],
        },
        "distanceMetres": float(np.hypot(x, y)),
        "velocity": [0, 5, 0],
        "space": None,
    }


def label(number: int) -> Dict[str, Any]:
    """A car that drives away, and from frame 1 on a pedestrian whose visibility is unknown."""
    objects = [car(7, 0, 11 + number)]
    if number > 0:
        objects.append(
            {
                **car(9, 3, 21),
                "class": "pedestrian",
                "occludedFraction": None,
                "occlusionMethod": "none",
                "visibleFraction": None,
            }
        )
    return {
        "frame": number,
        "gameFrame": 100 + number,
        "timeSeconds": 0.1 * number,
        "lagFrames": 0,
        "lagSeconds": 0,
        "image": f"frames/{number:08d}.png",
        "mask": f"masks/{number:08d}.png",
        "pixelMap": None,
        "rays": None,
        "camera": camera(),
        "ego": {
            "position": [0, -1, -1],
            "headingDegrees": 0,
            "heightAboveGroundMetres": None,
            "velocity": [0, 5, 0],
            "model": "asea",
        },
        "environment": {"weather": "clear", "timeOfDay": "12:00:00"},
        "objects": objects,
        "ignoreRegions": [{"reason": "beyondRange", "class": "car", "box2d": [1, 2, 3, 5], "distanceMetres": 120}],
    }


class HandmadeSession:
    """A session of three frames, for tests to change before they write it."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.info: Dict[str, Any] = {
            "formatVersion": 1,
            "game": "simulation",
            "seed": 1,
            "settings": {},
            "image": {"width": WIDTH, "height": HEIGHT, "format": "png", "quality": None},
            "classes": ["car", "pedestrian"],
            "camera": camera(),
            "state": "complete",
            "fault": None,
        }
        self.lines: List[Dict[str, Any]] = [copy.deepcopy(label(number)) for number in range(3)]

    def write(self) -> Path:
        (self.folder / "frames").mkdir(parents=True, exist_ok=True)
        (self.folder / "masks").mkdir(exist_ok=True)
        for line in self.lines:
            number = line["frame"]
            (self.folder / f"frames/{number:08d}.png").write_bytes(png.encode(image(number)))
            (self.folder / f"masks/{number:08d}.png").write_bytes(png.encode(mask()))
        (self.folder / "session.json").write_text(json.dumps(self.info))
        text = "".join(json.dumps(line, separators=(",", ":")) + "\n" for line in self.lines)
        (self.folder / "labels.jsonl").write_text(text)
        return self.folder


def image(number: int) -> Any:
    """Red grows to the right, green downward; blue is the number of the frame."""
    rows, columns = np.mgrid[0:HEIGHT, 0:WIDTH]
    return np.stack([columns * 3, rows * 4, np.full_like(rows, number)], axis=-1).astype(np.uint8)


def mask() -> Any:
    """The car's pixels, from its box in frame 0: columns 37 to 42, rows 27 to 32; and an id that needs 16 bits."""
    ids = np.zeros((HEIGHT, WIDTH), np.uint16)
    ids[27:33, 37:43] = 7
    ids[0, 0] = 40_000
    return ids


@pytest.fixture
def handmade(tmp_path: Path) -> HandmadeSession:
    return HandmadeSession(tmp_path / "session")
