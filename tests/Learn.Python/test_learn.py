"""The parts of examples/learn that can be computed by hand."""
from __future__ import annotations

import math
from pathlib import Path
from typing import Any, Dict, Tuple

import numpy as np
import torch

import train
import training
from harvest import is_whole
from judge import Judge
from network import INACTIVE, INDICATORS, MOST_TURN, SCALE, WIDTH, Network, as_input, indicators_of
from packed import Packed
from progress import Progress
from record import is_driven

METRES = 0.01
"""Turning the view is computed for small angles; the cosine of the largest, 0.11 rad, changes 2 m by this much."""


def markings_seen(heading: float, across: float, width: float) -> Tuple[float, float, float]:
    """Angle and ego-lane markings in TORCS's scale; the camera is `across` metres to the right of the lane centre.

    The road points along y. The middle of the car is 2 m behind the camera. A heading is positive to the left.
    """
    middle = across - 2.0 * -math.sin(heading)
    return -heading, (-width / 2 - middle) * 4 / width, (width / 2 - middle) * 4 / width


def test_turned_view_has_the_indicators_of_a_turned_car() -> None:
    for heading, across, turn in ((0.0, 0.3, 0.1), (0.02, -0.5, -0.08), (-0.03, 0.0, 0.05)):
        values = np.zeros((1, INDICATORS), np.float32)
        values[0, [0, 7, 8]] = markings_seen(heading, across, 5.4)

        seen = train.turned(values, np.array([5.4]), np.array([turn]), 1)[0, [0, 7, 8]]

        np.testing.assert_allclose(seen, markings_seen(heading - turn, across, 5.4), atol=METRES)


def test_turn_to_the_right_moves_the_image_to_the_left() -> None:
    image = np.zeros((1, 70, 140, 3), np.uint8)
    image[0, :, 70] = 255

    columns = [int(as_input(image, np.array([turn]))[0, 0, 0].argmax()) for turn in (-MOST_TURN, 0, MOST_TURN)]

    assert columns == [70, 58, 46] and as_input(image).shape == (1, 3, 70, WIDTH)


def packed(values: np.ndarray, active: np.ndarray, sessions: Tuple[int, ...]) -> Packed:
    count = len(values)
    none = np.full(count, np.nan, np.float32)
    return Packed(
        np.zeros((count, 70, 140, 3), np.uint8), values, active, np.full(count, 5.4, np.float32),
        np.array([(session, frame) for frame, session in enumerate(sessions)]), np.full((count, 3), np.nan), none, none,
        np.zeros(count, np.bool_))


def test_shifted_labels_are_those_of_the_frame_before() -> None:
    values = np.arange(4 * INDICATORS, dtype=np.float32).reshape(4, INDICATORS)

    shifted, _ = train.labels_of(packed(values, np.ones((4, INDICATORS), np.bool_), (0, 0, 1, 1)), "shifted")

    assert (shifted == values[[0, 0, 2, 2]]).all()


def test_mirrored_labels_are_those_of_a_mirrored_road() -> None:
    # In the left lane of two, 0.4 m to the right of its middle and turned to the left; a vehicle ahead in the right lane.
    values = np.array([[-0.1, *INACTIVE[1:4], 75, 75, -9.5, -2.4, 1.6, 5.6, 75, 75, 20]], np.float32)
    active = np.zeros((1, INDICATORS), np.bool_)
    active[0, [0, 7, 8, 9, 11, 12]] = True

    mirrored, mirrored_active = train.labels_of(packed(values, active, (0,)), "mirrored")

    np.testing.assert_array_equal(np.flatnonzero(mirrored_active[0]), [0, 6, 7, 8, 10, 11])
    np.testing.assert_allclose(mirrored[0, mirrored_active[0]], [0.1, -5.6, -1.6, 2.4, 20, 75], rtol=1e-6)


def test_outputs_are_indicators_where_they_are_active() -> None:
    outputs = np.full((1, 2 * INDICATORS), -1, np.float32)
    outputs[0, 0], outputs[0, INDICATORS] = 0.5, 3

    values, active = indicators_of(outputs)

    assert active.sum() == 1 and values[0, 0] == np.float32(0.5) * SCALE[0]
    assert (values[0, 1:] == INACTIVE[1:]).all()


def test_variations_keep_the_range_and_the_seed() -> None:
    images = torch.rand(4, 3, 70, WIDTH, generator=torch.Generator().manual_seed(1))

    first, second = (training.varied(images, torch.Generator().manual_seed(2)) for _ in range(2))

    assert torch.equal(first, second) and not torch.equal(first, images)
    assert first.min() >= 0 and first.max() <= 1


def test_network_takes_further_inputs() -> None:
    network = Network(2, 4).eval()
    image = torch.zeros(1, 3, 70, WIDTH)

    first, second = (network(image, torch.full((1, 4), value)) for value in (0.0, 1.0))

    assert first.shape == (1, 2) and not torch.equal(first, second)


def frame(metres: float, outside: bool = False, built_in: bool = False, offset: Any = 0.5, parked: int = 0) -> Dict[str, Any]:
    return {
        "drivenMetres": metres, "timeSeconds": metres / 10, "outsideLanes": outside, "builtInDriver": built_in, "laneOffsetMetres": offset,
        "collisions": [0, parked, 0], "repositioned": 0, "redLightsRun": 0, "stopSignsRun": 0, "position": [0, 0, 0]}


def test_judge_counts_what_the_driver_did() -> None:
    judge = Judge(frame(0), 80)
    for each in (
            frame(10), frame(20, outside=True), frame(30, outside=True), frame(40), frame(50, parked=1), frame(60, built_in=True, parked=1),
            frame(70, outside=True, built_in=True, parked=2), frame(80, parked=2)):
        judge.take(each)

    figures = judge.figures()

    assert [departure["seconds"] for departure in figures["departures"]] == [2]
    assert figures["collisions"] == {"vehicle": 0, "parked": 1, "pedestrian": 0}
    # The last two steps began with the built-in driver.
    assert (figures["metres"], figures["driverMetres"], figures["rmsOffsetMetres"]) == (80, 60, 0.5)


def test_progress_of_another_model_or_with_other_options_is_not_continued(tmp_path: Path) -> None:
    model, other = tmp_path / "a.pt", tmp_path / "b.pt"
    model.write_bytes(b"one")
    other.write_bytes(b"another")
    picture = np.arange(24, dtype=np.uint8).reshape(2, 4, 3)
    Progress(tmp_path / "a.jsonl", model, {"towns": 3}).add({"town": 301}, picture)

    (figures, image), = Progress(tmp_path / "a.jsonl", model, {"towns": 3}).done
    assert figures == {"town": 301}
    np.testing.assert_array_equal(image, picture)
    assert Progress(tmp_path / "a.jsonl", model, {"towns": 4}).done == []
    assert Progress(tmp_path / "a.jsonl", other, {"towns": 3}).done == []


def test_harvest_and_drive_that_were_stopped_in_good_order_are_not_done(tmp_path: Path) -> None:
    (tmp_path / "session.json").write_text('{"state": "complete"}')
    (tmp_path / "drive.json").write_text('{"isWhole": false}')
    assert is_whole(tmp_path) and not is_driven(tmp_path)

    (tmp_path / ".harvester-unfinished").write_text("harvester harvest")
    (tmp_path / "drive.json").write_text('{"isWhole": true}')
    assert not is_whole(tmp_path) and is_driven(tmp_path)
