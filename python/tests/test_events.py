"""The events of a session."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any, Dict

import pytest
from conftest import ROOT, HandmadeSession

import gtaharvest


def event() -> Dict[str, Any]:
    """The ego touches an object."""
    ego = {
        "object": None,
        "class": None,
        "model": "asea",
        "position": [0, 0, 0],
        "right": [1, 0, 0],
        "forward": [0, 1, 0],
        "up": [0, 0, 1],
        "modelMin": [-1, -2, 0],
        "modelMax": [1, 2, 1.5],
        "velocity": [0, 5, 0],
        "yawRate": 0.1,
    }
    return {
        "id": 3,
        "kind": "collision",
        "beginSeconds": 0.1,
        "peakSeconds": 0.1,
        "endSeconds": 0.2,
        "end": "over",
        "firstFrame": 1,
        "lastFrame": 2,
        "participants": [ego, {**ego, "object": 7, "class": "car", "position": [0, 4, 0]}],
        "measures": {},
        "contact": {
            "position": [0, 2, 0.7],
            "onFirst": [0, 2],
            "onSecond": [0, -2],
            "relativeSpeed": 5,
            "firstSpeedChange": 2,
            "secondSpeedChange": 3,
            "impulse": 3600,
            "impulseMin": 2100,
            "impulseMax": 7000,
        },
    }


def written(folder: Path, text: str) -> gtaharvest.Session:
    session = HandmadeSession(folder / "session")
    session.lines[1]["events"] = [{"id": 3, "kind": "collision"}]
    session.write()
    (session.folder / "events.jsonl").write_text(text)
    return gtaharvest.open_session(session.folder)


def test_events_and_marks_are_read(tmp_path: Path) -> None:
    session = written(tmp_path, json.dumps(event()) + "\n" + '{"id": 4')
    (only,) = session.events()

    assert (only.id, only.kind, only.end, only.first_frame, only.last_frame) == (3, "collision", "over", 1, 2)
    assert [(each.object, each.class_name) for each in only.participants] == [(None, None), (7, "car")]
    assert only.contact is not None and only.contact.on_second == (0, -2)
    assert [frame.events for frame in session] == [None, (gtaharvest.EventMark(3, "collision"),), None]


def test_session_without_events_has_none(tmp_path: Path) -> None:
    session = gtaharvest.open_session(HandmadeSession(tmp_path / "session").write())

    assert list(session.events()) == []


@pytest.mark.parametrize("text", ["[]\n", '{"id": "x"}\n', "{\n", json.dumps({**event(), "participants": [1]}) + "\n"])
def test_damaged_line_is_an_error(tmp_path: Path, text: str) -> None:
    with pytest.raises(gtaharvest.LabelError, match="events.jsonl, line 1"):
        list(written(tmp_path, text).events())


def test_kinds_are_those_of_the_schema() -> None:
    schema = json.loads((ROOT / "docs/schema/event.schema.json").read_text(encoding="utf-8"))

    assert tuple(schema["properties"]["kind"]["enum"]) == gtaharvest.EVENT_KINDS


def test_schema_describes_an_event() -> None:
    jsonschema = pytest.importorskip("jsonschema")
    schema = jsonschema.Draft202012Validator(
        json.loads((ROOT / "docs/schema/event.schema.json").read_text(encoding="utf-8"))
    )

    assert schema.is_valid(event())
    assert not schema.is_valid({**event(), "extra": 1})
