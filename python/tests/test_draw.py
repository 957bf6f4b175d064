"""Drawing, and the command gtaharvest show."""

from __future__ import annotations

import os
import subprocess
import sys
from pathlib import Path

import numpy as np
import pytest
from conftest import HandmadeSession
from gtaharvest import open_session, png
from gtaharvest.cli import main
from gtaharvest.draw import CLASS_COLOURS, annotate, draw_box


def test_a_box_is_drawn_over_the_outermost_pixels_it_touches() -> None:
    picture = np.zeros((6, 8, 3), np.uint8)
    # Columns 2 to 4 and rows 1 to 3.
    draw_box(picture, (2.2, 1, 5, 3.5), (9, 9, 9))
    drawn = {(int(x), int(y)) for y, x in np.argwhere(picture[..., 0])}
    assert drawn == {(x, y) for x in (2, 3, 4) for y in (1, 2, 3)} - {(3, 2)}


def test_sides_of_a_box_outside_the_image_are_not_drawn() -> None:
    picture = np.zeros((6, 8, 3), np.uint8)
    draw_box(picture, (-1e9, -3, 4, 2e9), (9, 9, 9))
    assert {(int(x), int(y)) for y, x in np.argwhere(picture[..., 0])} == {(3, y) for y in range(6)}


@pytest.mark.parametrize("boxes", ["cuboid", "3d"])
def test_annotate_draws_the_near_side_of_a_car_in_its_colour(handmade: HandmadeSession, boxes: str) -> None:
    view = open_session(handmade.write())[0].view
    picture = annotate(view, boxes)
    # The rear of the car is 10 m ahead: columns 37 to 42, rows 27 to 32.
    assert tuple(picture[30, 37]) == CLASS_COLOURS["car"]
    assert tuple(picture[27, 40]) == CLASS_COLOURS["car"]
    assert tuple(picture[30, 40]) == tuple(view.image()[30, 40])
    np.testing.assert_array_equal(annotate(view, "none"), view.image())


def test_annotate_draws_behind_the_camera_without_harm(handmade: HandmadeSession) -> None:
    handmade.lines[0]["objects"][0]["box3d"]["centre"] = [1, 0.2, 0]
    assert annotate(open_session(handmade.write())[0].view, "3d").shape == (60, 80, 3)
    with pytest.raises(ValueError, match="kinds are"):
        annotate(open_session(handmade.folder)[0].view, "round")


def test_show_writes_a_picture(handmade: HandmadeSession, capsys: pytest.CaptureFixture[str]) -> None:
    out = handmade.folder.parent / "shown.png"
    assert main(["show", str(handmade.write()), "--frame", "1", "--out", str(out), "--class", "car"]) == 0
    assert "frame 1, 1 objects" in capsys.readouterr().out
    picture = png.decode(out.read_bytes())
    assert picture.shape == (60, 80, 3) and (picture == CLASS_COLOURS["car"]).all(axis=-1).any()


def test_show_names_its_file_by_the_frame(
    handmade: HandmadeSession, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    assert main(["show", str(handmade.write())]) == 0
    assert (tmp_path / "frame-00000000.png").exists()


@pytest.mark.parametrize(
    "arguments, code, words",
    [
        (["nowhere"], 1, "does not exist"),
        (["session", "--frame", "9"], 1, "no frame 9"),
        (["session", "--out", "no/folder/x.png"], 3, "No such file"),
    ],
)
def test_show_ends_with_one_line_and_a_code(
    handmade: HandmadeSession,
    capsys: pytest.CaptureFixture[str],
    monkeypatch: pytest.MonkeyPatch,
    arguments: list[str],
    code: int,
    words: str,
) -> None:
    monkeypatch.chdir(handmade.write().parent)
    assert main(["show", *arguments]) == code
    error = capsys.readouterr().err
    assert words in error and error.count("\n") == 1


def test_the_command_has_help() -> None:
    source = Path(__file__).resolve().parents[1] / "src"
    run = subprocess.run(
        [sys.executable, "-m", "gtaharvest", "show", "--help"],
        env={**os.environ, "PYTHONPATH": str(source)},
        capture_output=True,
        text=True,
        check=True,
    )
    assert "--boxes" in run.stdout and "Exit codes" in run.stdout
