"""The parts of examples/learn that can be computed by hand."""
from __future__ import annotations

import argparse
import json
import math
import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from typing import Any, Dict, List, Tuple

import numpy as np
import pytest
import torch

import commands
import drive
import imitate
import train
import training
from harvest import command_of, is_done
from judge import Judge
from network import INACTIVE, INDICATORS, MOST_TURN, SCALE, WIDTH, Network, as_input, indicators_of, predict
from packed import Packed, PackedError
from progress import Progress, ProgressError
from record import is_whole
from sets import DRIVES, SETS

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
        np.zeros((count, 70, 140, 3), np.uint8),
        values,
        active,
        np.full(count, 5.4, np.float32),
        np.array([(session, frame) for frame, session in enumerate(sessions)]),
        np.full((count, 3), np.nan),
        none,
        none,
        np.zeros(count, np.bool_),
    )


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


def frame(
    metres: float, outside: bool = False, built_in: bool = False, offset: Any = 0.5, parked: int = 0
) -> Dict[str, Any]:
    return {
        "drivenMetres": metres,
        "timeSeconds": metres / 10,
        "outsideLanes": outside,
        "builtInDriver": built_in,
        "laneOffsetMetres": offset,
        "road": None if built_in else 1,
        "lane": None if built_in else 0,
        "acrossMarking": outside,
        "collisions": [0, parked, 0],
        "repositioned": 0,
        "redLightsRun": 0,
        "stopSignsRun": 0,
        "position": [0, 0, 0],
    }


def test_judge_counts_what_the_driver_did() -> None:
    judge = Judge(frame(0), 80)
    for each in (
        frame(10),
        frame(20, outside=True),
        frame(30, outside=True),
        frame(40),
        frame(50, parked=1),
        frame(60, built_in=True, parked=1),
        frame(70, outside=True, built_in=True, parked=2),
        frame(80, parked=2),
    ):
        judge.take(each)

    figures = judge.figures()

    assert [departure["seconds"] for departure in figures["departures"]] == [2]
    assert figures["collisions"] == {"vehicle": 0, "parked": 1, "pedestrian": 0}
    # Two steps ended with the built-in driver.
    assert (figures["metres"], figures["driverMetres"], figures["rmsOffsetMetres"]) == (80, 60, 0.5)


def test_progress_of_another_model_or_with_other_options_is_not_continued(tmp_path: Path) -> None:
    model, other, file = tmp_path / "a.pt", tmp_path / "b.pt", tmp_path / "a.progress"
    model.write_bytes(b"one")
    other.write_bytes(b"another")
    picture = np.arange(24, dtype=np.uint8).reshape(2, 4, 3)
    Progress(file, model, {"towns": 3}).add({"town": 301}, picture)

    ((figures, image),) = Progress(file, model, {"towns": 3}).done
    assert figures == {"town": 301}
    np.testing.assert_array_equal(image, picture)
    roads = tmp_path / "roads.zip"
    roads.write_bytes(b"roads")
    for wanted, difference in (
        ((model, {"towns": 4}), "another --towns"),
        ((other, {"towns": 3}), "another model"),
        ((model, {"towns": 3}, roads), "another road network"),
    ):
        with pytest.raises(ProgressError, match=difference):
            Progress(file, *wanted)
    for damage in ("", "{}\n", '{"sha256": 1}\n'):
        file.write_text(damage)
        with pytest.raises(ProgressError, match="damaged"):
            Progress(file, model, {"towns": 3})


def write_session(folder: Path, **further: Any) -> None:
    folder.mkdir(exist_ok=True)
    (folder / "session.json").write_text(json.dumps({"state": "complete", "seed": 101, **further}))


def test_harvest_and_drive_that_were_stopped_in_good_order_are_not_done(tmp_path: Path) -> None:
    plan = SETS["train"][0]
    write_session(tmp_path, counters={"captured": plan.frames})
    (tmp_path / "drive.json").write_text('{"isWhole": false}')
    assert is_done(tmp_path, plan) and not is_whole(tmp_path)

    (tmp_path / ".harvester-unfinished").write_text("harvester harvest")
    (tmp_path / "drive.json").write_text('{"isWhole": true}')
    assert not is_done(tmp_path, plan) and is_whole(tmp_path)


def test_sessions_of_a_trial_are_not_done(tmp_path: Path) -> None:
    plan, drive = SETS["train"][0], DRIVES["drives"][0]
    for frames, is_enough in ((20, False), (plan.frames - 1, False), (plan.frames, True), (plan.frames + 1, True)):
        write_session(tmp_path, counters={"captured": frames})
        assert is_done(tmp_path, plan) == is_enough
    assert not is_done(tmp_path, SETS["train"][1])

    for metres, is_enough in (("30", False), ("1500", True)):
        write_session(tmp_path, settings={"distanceMetres": metres})
        assert is_done(tmp_path, drive) == is_enough
    assert not is_done(tmp_path, DRIVES["drives"][1])


def test_only_a_session_of_the_same_plan_is_resumed(tmp_path: Path) -> None:
    plan, unfinished = SETS["roads"][0], tmp_path / ".harvester-unfinished"

    def command() -> List[str]:
        return command_of(["harvester"], tmp_path, plan, "a b.zip")

    assert "--overwrite" in command() and "--resume" not in command()
    unfinished.write_text(" ".join(["harvester harvest", *plan.options(None), "--roads 'a b.zip'"]))
    assert "--resume" in command() and "--overwrite" not in command()
    unfinished.write_text("harvester harvest --frames 20 --seed 241")
    assert "--overwrite" in command() and "--resume" not in command()


def test_no_set_but_straight_and_drives_has_towns_of_another() -> None:
    plans = {**SETS, **DRIVES}
    towns = [plan.seed for name in plans if name not in ("straight", "drives") for plan in plans[name]]

    assert len(towns) == len(set(towns))


@pytest.mark.parametrize("number", (signal.SIGINT, signal.SIGTERM))
@pytest.mark.parametrize("script", ("harvest", "record"))
def test_stopping_ends_what_runs_and_starts_nothing_more(tmp_path: Path, script: str, number: signal.Signals) -> None:
    fake, data = tmp_path / "fake.py", tmp_path / "data"
    fake.write_text(
        "import os, sys, time\n"
        "out = sys.argv[sys.argv.index('--out') + 1]\n"
        "open(f'{os.path.dirname(out)}/{os.getpid()}.pid', 'w').close()\n"
        "time.sleep(60)\n"
    )
    (data / "driven").mkdir(parents=True)
    with subprocess.Popen(
        [sys.executable, f"examples/learn/{script}.py", data, "--jobs", "2", "--harvester", f"{sys.executable} {fake}"],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.PIPE,
        text=True,
        # A shell that runs this in the background has it ignored.
        preexec_fn=lambda: signal.signal(signal.SIGINT, signal.default_int_handler),
    ) as process:
        begun = time.monotonic()
        while len(list(data.glob("*/*.pid"))) < 2 and time.monotonic() < begun + 30:
            time.sleep(0.05)
        process.send_signal(number)
        _, errors = process.communicate(timeout=30)

    children = [int(file.stem) for file in data.glob("*/*.pid")]
    assert process.returncode == 130
    assert errors == f"{script}.py: stopped; run the same command again to continue.\n"
    assert len(children) == 2 and not any(os.path.exists(f"/proc/{child}") for child in children)


def test_command_that_hangs_is_ended_even_if_it_ignores_that(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    pid = tmp_path / "pid"
    deaf = f"import os, signal, time; signal.signal(15, 1); open({str(pid)!r}, 'w').write(str(os.getpid())); time.sleep(60)"
    monkeypatch.setattr(commands, "LIMIT_SECONDS", 1)
    monkeypatch.setattr(commands, "STOP_SECONDS", 0.2)

    with pytest.raises(RuntimeError, match="^train/101: the command has not ended within"):
        commands.run_all({"train/101": [sys.executable, "-c", deaf]}, 1, lambda _: None)

    assert not os.path.exists(f"/proc/{pid.read_text()}")


def town_of(metres: float, in_lane: float, offset: float, departures: int) -> Dict[str, Any]:
    return {
        "driverMetres": metres,
        "inLaneMetres": in_lane,
        "rmsOffsetMetres": offset,
        "departures": [{}] * departures,
        "score": 50.0,
        "collisions": {"vehicle": 1},
    }


def test_total_weighs_the_offset_by_the_distance_in_a_lane() -> None:
    total = drive.total_of([town_of(1000, 100, 3.0, 2), town_of(1000, 300, 1.0, 2)])

    # The root of (9 * 100 + 1 * 300) / 400.
    assert total["rmsOffsetMetres"] == 1.732
    assert total["departuresPerKilometre"] == 2 and total["collisions"] == {"vehicle": 2}
    nowhere = drive.total_of([town_of(0, 0, 0.0, 0)])
    assert (nowhere["departuresPerKilometre"], nowhere["interval"], nowhere["rmsOffsetMetres"]) == (None, None, None)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("train", "data", "full.state"), "'full.state' is not the name of a file that ends with .pt"),
        (("train", "data", "full.pt", "--epochs", "0"), "'0' is not a whole number of at least 1"),
        (("harvest", "data", "--frames", "0"), "'0' is not a whole number of at least 1"),
        (("drive", "full.pt", "--kilometres", "nan"), "'nan' is not a number greater than 0"),
        (("drive", "full.pt", "--out", "none/x.json"), "'none/x.json' is no file that can be written"),
        (("drive", "full.pt", "--strip", "strip"), "'strip' does not end with .png or .jpg"),
        (("pack", "data", "none"), "unknown set 'none'; sets are train, validation"),
        (("pack", "none"), "none has no set; run harvest.py first."),
        (("pack", "none", "train"), "none/train has no session; run harvest.py first."),
        (("evaluate", "data", "damaged.pt"), "damaged.pt is not a network of train.py or imitate.py, or is damaged."),
        (("drive", "damaged.pt"), "damaged.pt is not a network of train.py or imitate.py, or is damaged."),
        (("plot", "curves.png", "damaged.pt"), "damaged.jsonl is not the log of a training."),
        (("train", "data", "new.pt"), "train.npz is damaged, or of another version"),
    ],
)
def test_bad_input_is_one_clear_line(tmp_path: Path, arguments: Tuple[str, ...], words: str) -> None:
    (tmp_path / "damaged.pt").write_bytes(b"PK")
    (tmp_path / "damaged.jsonl").write_text("")
    (tmp_path / "data" / "packed").mkdir(parents=True)
    (tmp_path / "data" / "packed" / "train.npz").write_bytes(b"PK")
    script, *rest = arguments

    run = subprocess.run(
        [sys.executable, Path("examples/learn").resolve() / f"{script}.py", *rest],
        cwd=tmp_path,
        text=True,
        capture_output=True,
        env={**os.environ, "PYTHONPATH": str(Path("python/src").resolve())},
        timeout=60,
    )

    assert run.returncode != 0
    assert words in run.stderr.splitlines()[-1] and "Traceback" not in run.stderr


def test_policy_needs_drives_to_learn_from(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    recorded = packed(np.zeros((2, INDICATORS), np.float32), np.ones((2, INDICATORS), np.bool_), (0, 1))
    recorded.by_controller[:] = True
    recorded.controls[:] = 0
    monkeypatch.setattr(imitate, "load", lambda *_: recorded)

    with pytest.raises(PackedError, match="The set drives has 2 drives, too few to hold out 2"):
        imitate.train(options_of(tmp_path / "policy.pt", validation=2))


def test_errors_of_a_policy_are_those_of_steering_and_pedal() -> None:
    recorded = packed(np.zeros((2, INDICATORS), np.float32), np.ones((2, INDICATORS), np.bool_), (0, 0))
    recorded.by_controller[:] = (True, True)
    recorded.controls[:] = ((0.1, 0.5, 0), (-0.1, 0, 0.5))

    errors = imitate.errors_of(np.array([0.5, 0.25]), imitate.controlled(recorded))

    # Steering 0.05 and pedal 0.25 for both frames.
    assert errors == {"steering": pytest.approx(0.1), "pedal": pytest.approx(0.5)}


class Stop(Exception):
    """Stops a training."""


def options_of(model: Path, **changed: Any) -> argparse.Namespace:
    return argparse.Namespace(
        **{
            "data": model.parent,
            "model": model,
            "epochs": 3,
            "seed": 1,
            "threads": 1,
            "labels": "true",
            "sessions": None,
            **changed,
        }
    )


def fit(options: argparse.Namespace, frames: int = 8, stop_after: int = 99) -> None:
    """A small training with everything that is random; raises Stop after a number of epochs."""
    torch.manual_seed(options.seed)
    network = Network(2 * INDICATORS)
    random = np.random.default_rng(1)
    data = packed(np.zeros((frames, INDICATORS), np.float32), np.ones((frames, INDICATORS), np.bool_), (0,) * frames)
    data.images[:] = random.integers(0, 256, data.images.shape)
    epochs: List[int] = []

    def loss_of(batch: torch.Tensor, generator: torch.Generator) -> torch.Tensor:
        images = training.varied(as_input(data.images[batch.numpy()]), generator)
        return train.loss_of(network(images), torch.zeros(len(batch), INDICATORS), torch.ones(len(batch), INDICATORS))

    def errors_on(trained: Network, validation: Packed) -> Dict[str, float]:
        epochs.append(1)
        if len(epochs) > stop_after:
            raise Stop
        return {"mean": float(predict(trained, validation.images).mean())}

    training.fit(network, data, data, loss_of, errors_on, options)


def figures_of(log: Path) -> List[Dict[str, float]]:
    return [
        {key: value for key, value in json.loads(line).items() if key != "seconds"}
        for line in log.read_text().splitlines()
    ]


def test_stopped_training_ends_as_one_that_was_not_stopped(tmp_path: Path) -> None:
    whole, stopped = tmp_path / "whole.pt", tmp_path / "stopped.pt"
    fit(options_of(whole))
    with pytest.raises(Stop):
        fit(options_of(stopped), stop_after=1)
    assert len(figures_of(stopped.with_suffix(".jsonl"))) == 1 and not stopped.exists()

    fit(options_of(stopped))

    expected, weights = (torch.load(file)["network"] for file in (whole, stopped))
    assert all(torch.equal(expected[name], weights[name]) for name in expected)
    assert figures_of(stopped.with_suffix(".jsonl")) == figures_of(whole.with_suffix(".jsonl"))


def test_training_with_other_options_or_data_is_refused(tmp_path: Path) -> None:
    model = tmp_path / "full.pt"
    fit(options_of(model, epochs=1))
    before = model.read_bytes()

    for frames, changed, told in (
        (8, {"epochs": 2}, "--epochs 1"),
        (8, {"epochs": 1, "labels": "mirrored"}, "--labels true"),
        (8, {"epochs": 1, "sessions": 1}, "no --sessions"),
        (9, {"epochs": 1}, "other data"),
    ):
        with pytest.raises(training.TrainingError) as refusal:
            fit(options_of(model, **changed), frames)
        remedy = f"Choose another name for the model, or delete {tmp_path / 'full.state'} to start over."
        assert str(refusal.value) == f"{tmp_path / 'full.state'} belongs to a training run with {told}. {remedy}"
    fit(options_of(model, epochs=1, threads=2))
    assert model.read_bytes() == before


@pytest.mark.parametrize("damage", ("empty", "cut", "changed", "foreign"))
def test_damaged_state_is_refused(tmp_path: Path, damage: str) -> None:
    model, state = tmp_path / "full.pt", tmp_path / "full.state"
    fit(options_of(model, epochs=1))
    whole = state.read_bytes()
    middle = len(whole) // 2
    state.write_bytes(
        {
            "empty": b"",
            "cut": whole[:middle],
            "changed": whole[:middle] + bytes(64) + whole[middle + 64 :],
            "foreign": model.read_bytes(),
        }[damage]
    )

    with pytest.raises(training.TrainingError, match="is damaged, or of another version"):
        fit(options_of(model, epochs=1))
