"""The actions of a recorded drive."""

from __future__ import annotations

from pathlib import Path
from typing import Any, Dict

import numpy as np
import pytest
from conftest import HandmadeSession

import gtaharvest

ACTION: Dict[str, Any] = {
    "driver": "controller",
    "controls": {"steering": 0.25, "throttle": 0.5, "brake": 0},
    "answerSeconds": 0,
    "applied": {"steering": 0.3, "throttle": 0.5, "brake": 0},
    "disturbed": True,
    "indicators": list(range(13)),
    "target": {"speed": 9.5, "rightMetres": -0.25},
    "route": "left",
    "routeMetres": 12.5,
    "speed": 8,
    "acceleration": [0.5, 1, 0],
    "angularRate": None,
    "bridgeFrame": None,
    "truth": {
        "drivenMetres": 3,
        "collision": None,
        "outsideLanes": False,
        "laneOffsetMetres": 0.1,
        "laneAngleRadians": None,
        "light": "red",
        "stopSign": False,
        "redLightsRun": 0,
        "stopSignsRun": 0,
        "repositioned": 1,
    },
    "ticks": [
        {
            "timeSeconds": 0.05,
            "driver": "builtIn",
            "speed": 8.1,
            "acceleration": None,
            "angularRate": [0, 0, 0.2],
            "applied": None,
        }
    ],
}


def test_action_is_read_as_written(tmp_path: Path) -> None:
    session = HandmadeSession(tmp_path / "driven")
    session.lines[0]["drive"] = ACTION
    first, second = list(gtaharvest.open_session(session.write()))[:2]

    drive = first.drive
    assert drive is not None and second.drive is None
    assert (drive.driver, drive.route, drive.route_metres, drive.speed, drive.disturbed) == (
        "controller",
        "left",
        12.5,
        8,
        True,
    )
    assert drive.controls == gtaharvest.Controls(0.25, 0.5, 0) and drive.applied == gtaharvest.Controls(0.3, 0.5, 0)
    assert drive.indicators == tuple(range(13)) and drive.bridge_frame is None and drive.angular_rate is None
    assert drive.target == gtaharvest.DriveTarget(9.5, -0.25)
    np.testing.assert_array_equal(drive.acceleration, [0.5, 1, 0])
    assert drive.truth is not None and drive.truth.light == "red" and drive.truth.repositioned == 1
    (tick,) = drive.ticks
    assert (tick.time_seconds, tick.driver, tick.applied) == (0.05, "builtIn", None)


@pytest.mark.parametrize(
    "field, value, problem",
    [
        ("driver", "nobody", "'nobody'"),
        ("indicators", [1, 2], "2 indicators"),
        ("controls", {"steering": 0}, "'throttle' is missing"),
    ],
)
def test_invalid_action_is_a_label_error(tmp_path: Path, field: str, value: object, problem: str) -> None:
    session = HandmadeSession(tmp_path / "driven")
    session.lines[0]["drive"] = {**ACTION, field: value}

    with pytest.raises(gtaharvest.LabelError, match=problem):
        gtaharvest.open_session(session.write())[0].drive
