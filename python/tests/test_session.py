"""Opening sessions, and labels as records, arrays, tracks and tables."""

from __future__ import annotations

import json
import pickle
from pathlib import Path
from typing import Any

import gtaharvest
import numpy as np
import pytest
import rich
from conftest import HandmadeSession, car
from gtaharvest import Selection, open_session
from gtaharvest.records import ObjectLabel


def test_frames_by_position_number_and_in_order(handmade: HandmadeSession) -> None:
    session = open_session(handmade.write())
    assert len(session) == 3
    assert [frame.number for frame in session] == [0, 1, 2]
    assert session[-1].number == session.frame(2).number == 2
    assert session.classes == ("car", "pedestrian") and session.view_names == ("camera",)
    for position in (3, -4):
        with pytest.raises(IndexError, match="3 frames"):
            session[position]
    with pytest.raises(KeyError):
        session.frame(3)


def test_a_frame_of_a_shard_is_found_by_its_number(handmade: HandmadeSession) -> None:
    for line in handmade.lines:
        line["frame"] = 1 + 8 * line["frame"]
    session = open_session(handmade.write())
    assert session.frame(17).number == session[2].number == 17
    with pytest.raises(KeyError):
        session.frame(2)


def test_labels_as_records(handmade: HandmadeSession) -> None:
    frame = open_session(handmade.write())[1]
    car, pedestrian = frame.objects
    assert (car.id, car.class_name, car.model, car.name, car.face) == (7, "car", "blista", None, None)
    # The rear of a car at 12 m is at 11 m: half of it is 30 / 11 px.
    assert car.box2d == pytest.approx((40 - 30 / 11, 30 - 30 / 11, 40 + 30 / 11, 30 + 30 / 11))
    assert car.visible_fraction == 0.75 and pedestrian.visible_fraction is None
    assert car.box3d.centre == (0, 12, 0) and car.velocity == (0, 5, 0)
    assert frame.view.ignore_regions[0].reason == "beyondRange"
    assert (frame.weather, frame.time_of_day, frame.time_seconds) == ("clear", "12:00:00", pytest.approx(0.1))
    assert frame.ego.model == "asea" and frame.ego.yaw_rate is None and frame.ego.right is None
    assert frame.lanes is None


def test_projected_corners_of_a_cuboid_have_its_box(handmade: HandmadeSession) -> None:
    view = open_session(handmade.write())[0].view
    (car,) = view.objects
    corners = car.box3d.corners
    assert sorted(set(map(tuple, corners))) == sorted((x, y, z) for x in (-1, 1) for y in (10, 12) for z in (-1, 1))
    pixels = view.camera.project(corners).pixels
    assert (*pixels.min(axis=0), *pixels.max(axis=0)) == pytest.approx(car.box2d)


def test_labels_as_arrays_with_nan_for_unknown(handmade: HandmadeSession) -> None:
    arrays = open_session(handmade.write())[1].view.arrays()
    assert len(arrays) == 2
    assert arrays.ids.tolist() == [7, 9] and arrays.class_names.tolist() == ["car", "pedestrian"]
    assert arrays.box2d.shape == (2, 4) and np.isnan(arrays.box2d_visible).all() and np.isnan(arrays.box2d_whole).all()
    np.testing.assert_array_equal(arrays.visible_fraction, [0.75, np.nan])
    np.testing.assert_array_equal(arrays.centre, [[0, 12, 0], [3, 21, 0]])
    np.testing.assert_array_equal(arrays.axes[0], np.eye(3))
    assert np.isnan(arrays.joints).all() and arrays.joints.shape == (2, 22, 3)


def test_arrays_of_no_objects_have_their_shapes(handmade: HandmadeSession) -> None:
    handmade.lines[0]["objects"] = []
    arrays = open_session(handmade.write())[0].view.arrays()
    assert (
        len(arrays) == 0
        and arrays.box2d.shape == (0, 4)
        and arrays.axes.shape == (0, 3, 3)
        and arrays.joints.shape == (0, 22, 3)
    )


def test_joints_as_records_and_arrays(handmade: HandmadeSession) -> None:
    person = handmade.lines[1]["objects"][1]
    person["box2dJoints"] = [1, 2, 3, 4]
    person["joints"] = [
        {
            "joint": name,
            "position": [i, 21, 0],
            "pixel": None if i == 0 else [i, 2 * i],
            "visibility": "selfOccluded" if i else "outside",
        }
        for i, name in enumerate(gtaharvest.JOINT_NAMES)
    ]
    view = open_session(handmade.write())[1].view
    joints = view.objects[1].joints
    assert joints is not None and view.objects[1].box2d_joints == (1, 2, 3, 4)
    assert (joints[3].name, joints[3].position, joints[3].pixel) == ("right_clavicle", (3, 21, 0), (3, 6))
    arrays = view.arrays(Selection(classes={"pedestrian"}))
    np.testing.assert_array_equal(arrays.joints[0, :, 0], range(22))
    np.testing.assert_array_equal(arrays.joint_pixels[0, 21], [21, 42])
    assert np.isnan(arrays.joint_pixels[0, 0]).all() and arrays.joint_visibility[0, 1] == "selfOccluded"


def test_filters(handmade: HandmadeSession) -> None:
    view = open_session(handmade.write())[1].view

    def ids(**options: Any) -> list[int]:
        return [item.id for item in view.select(Selection(**options))]

    assert ids() == [7, 9]
    assert ids(classes=("pedestrian",)) == [9]
    # The visibility of the pedestrian is unknown.
    assert ids(min_visible_fraction=0.75) == [7] and ids(min_visible_fraction=0.8) == []
    assert ids(max_distance_metres=12) == [7] and ids(min_distance_metres=12.5) == [9]
    # Sides of 60 / 11 = 5.5 px and 60 / 20 = 3 px.
    assert ids(min_side_pixels=4) == [7]
    assert ids(max_truncated_fraction=0) == [7, 9]
    with pytest.raises(TypeError, match="collection"):
        Selection(classes="car")


@pytest.mark.parametrize(
    "options, words",
    [
        ({"classes": {"carr"}}, "Unknown class 'carr'; did you mean 'car'?"),
        ({"classes": ["x7"]}, "Unknown class 'x7'; classes are car, "),
        ({"min_visible_fraction": 5}, "min_visible_fraction is from 0 to 1, not 5."),
        ({"max_truncated_fraction": float("nan")}, "not nan."),
        ({"max_distance_metres": -1}, "max_distance_metres is 0 or more, not -1."),
        ({"min_side_pixels": float("nan")}, "not nan."),
    ],
)
def test_filters_without_a_meaning_are_refused(options: Any, words: str) -> None:
    with pytest.raises(ValueError) as refused:
        Selection(**options)
    assert words in str(refused.value) and "\n" not in str(refused.value)


def test_frame_that_is_not_there_is_named(handmade: HandmadeSession) -> None:
    session = open_session(handmade.write())
    with pytest.raises(gtaharvest.NotInSessionError) as refused:
        session.frame(999)
    assert (
        str(refused.value) == f"{session.folder}: the session has no frame 999; its 3 frames have the numbers 0 to 2."
    )
    assert isinstance(refused.value, gtaharvest.SessionError) and isinstance(refused.value, KeyError)


def test_records_are_shown_in_a_line(handmade: HandmadeSession, tmp_path: Path) -> None:
    session = open_session(handmade.write())
    assert repr(session[1]) == "Frame(1, 0.1 s, clear 12:00:00, view 'camera', 2 objects)"
    assert repr(session[1].view) == "View('camera', frame 1, 80x60, 2 objects)"
    assert repr(session.track(7)) == "Track(7, 'car', 3 frames from 0 to 2)"
    assert repr(session[1].view.arrays()) == "ObjectArrays(2 objects)"
    assert repr(open_session(rich.write(tmp_path / "rich"))[0].lanes) == (
        "Lanes(known, lane 0 of 2, +0.50 m from its centre, 1 vehicles, 1 boundaries, 1 markings)"
    )
    lanes = open_session(tmp_path / "rich")[0].lanes
    assert lanes is not None and lanes.markings is not None and lanes.lane_widths_metres == (3.5, 4.5)
    assert (lanes.lane_id, lanes.lanes_ahead) == ("0:1-0:2/f0", ("0:1-0:2/f0>0:3-0:4/f0", "0:3-0:4/f0"))
    car = open_session(tmp_path / "rich")[0].objects[0]
    assert (car.lane_id, car.governed_lanes) == ("0:1-0:2/b0", ("0:1-0:2/f0",))
    assert (lanes.markings[0].source, lanes.markings[0].sigma_metres) == ("paint", 0.02)
    assert (lanes.boundaries[0].source, lanes.boundaries[0].sigma_metres) == (None, None)
    handmade.lines[0]["timeSeconds"] = "x"
    assert repr(open_session(handmade.write())[0]) == f"<damaged label: {session.folder / 'labels.jsonl'}, line 1>"


def test_parts_can_be_left_out(handmade: HandmadeSession) -> None:
    handmade.lines[1]["objects"][1].update(
        {
            "parent": 7,
            "space": {
                "face": 0,
                "mutcd": "R1-1",
                "facesCamera": True,
                "facingAngleDegrees": 3,
                "provenance": "measured",
                "light": {"state": "red", "method": "set", "litFraction": None},
            },
        }
    )
    view = open_session(handmade.write())[1].view
    assert [item.id for item in view.select(Selection(with_parts=False))] == [7]
    face = view.objects[1].face
    assert face is not None and face.light is not None and (face.mutcd, face.light.state) == ("R1-1", "red")


def test_a_track_follows_an_object(handmade: HandmadeSession) -> None:
    session = open_session(handmade.write())
    car, pedestrian = session.track(7), session.track(9)
    assert car.frames == (0, 1, 2) and pedestrian.frames == (1, 2)
    assert car.class_name == "car" and car.centres[:, 1].tolist() == [11, 12, 13] and car.boxes.shape == (3, 4)
    assert session.tracks() == {7: car, 9: pedestrian}
    with pytest.raises(KeyError):
        session.track(70)


def test_a_table_of_all_objects(handmade: HandmadeSession) -> None:
    pytest.importorskip("pandas")
    session = open_session(handmade.write())
    table = session.to_pandas()
    assert table["id"].tolist() == [7, 7, 9, 7, 9] and table["frame"].tolist() == [0, 1, 1, 2, 2]
    assert table.groupby("class_name")["centre_y"].max().to_dict() == {"car": 13, "pedestrian": 21}
    assert table["visible_fraction"].isna().sum() == 2
    assert len(session.to_pandas(Selection(classes={"car"}))) == 3 and len(session[1].to_pandas()) == 2


def test_lanes_are_parsed_only_when_asked_for(handmade: HandmadeSession) -> None:
    numbers = {name: float(i) for i, name in enumerate(gtaharvest.INDICATOR_NAMES)}
    flags = {name: i % 2 == 0 for i, name in enumerate(gtaharvest.INDICATOR_NAMES)}
    line = {
        "index": 0,
        "side": "left",
        "points": [[0, 1, 2]],
        "inCamera": [[3, 4, 5]],
        "pixels": [[6, 7]],
        "hidden": [None],
    }
    handmade.lines[0]["lanes"] = {
        "status": "known",
        "source": "simulation",
        "confidence": 1,
        "inJunction": False,
        "laneCount": 2,
        "lane": 0,
        "laneWidthMetres": 4,
        "laneWidthSource": "constant",
        "offsetFromLaneCentreMetres": 0.5,
        "lookAheadMetres": 10,
        "curvaturePerMetre": 0,
        "fast": False,
        "indicators": numbers,
        "valid": flags,
        "torcsEquivalent": numbers,
        "atCar": {"indicators": numbers, "valid": flags},
        "vehicles": [{"id": 7, "lane": 1, "oncoming": False, "distanceMetres": 9, "bumperDistanceMetres": 5}],
        "boundaries": [line],
        "markings": None,
    }
    handmade.lines[0]["later"] = 1
    folder = handmade.write()
    frame = open_session(folder)[0]
    assert frame.raw["later"] == 1 and "lanes" in frame.raw and set(frame.raw) == set(handmade.lines[0])
    lanes = frame.lanes
    assert lanes is not None and lanes.lane_count == 2 and lanes.markings is None
    np.testing.assert_array_equal(lanes.indicators.values, range(13))
    assert lanes.indicators.valid[:2].tolist() == [True, False]
    assert lanes.vehicles[0].id == 7 and lanes.boundaries[0].pixels.tolist() == [[6, 7]]
    # The id in vehicles is no object of this frame.
    handmade.lines[0]["objects"] = []
    assert open_session(handmade.write()).track(7).frames == (1, 2)

    # Half a line of damage is noticed when its part is asked for.
    labels = folder / "labels.jsonl"
    labels.write_text(labels.read_text().replace('"laneCount":2', '"laneCount":?'))
    frame = open_session(folder)[0]
    assert frame.objects == ()
    with pytest.raises(gtaharvest.LabelError, match="line 1"):
        frame.lanes


def test_a_session_can_be_pickled_for_another_process(handmade: HandmadeSession) -> None:
    session = open_session(handmade.write())
    assert session[1].number == 1
    assert pickle.loads(pickle.dumps(session))[2].objects == session[2].objects


@pytest.mark.parametrize("manifest", ["right", "wrong sizes", "absent"])
def test_lines_are_found_with_and_without_a_manifest(handmade: HandmadeSession, manifest: str) -> None:
    folder = handmade.write()
    sizes = [len(line) - 1 for line in (folder / "labels.jsonl").read_bytes().splitlines(keepends=True)]
    if manifest == "wrong sizes":
        sizes = [sizes[1], sizes[0], sizes[2]]
    if manifest != "absent":
        lines = [
            f'{{"frame":{i},"label":{{"bytes":{size},"sha256":"0"}},"files":[],"check":"0"}}\n'
            for i, size in enumerate(sizes)
        ]
        (folder / "manifest.jsonl").write_text(
            "".join(lines) + '{"path":"session.json","bytes":1,"sha256":"0","check":"0"}\n'
        )
    session = open_session(folder)
    assert [len(frame.objects) for frame in session] == [1, 2, 2]


def test_a_session_without_frames_is_empty(handmade: HandmadeSession) -> None:
    handmade.lines = []
    folder = handmade.write()
    assert len(open_session(folder)) == 0 and open_session(folder).tracks() == {}
    (folder / "labels.jsonl").unlink()
    assert list(open_session(folder)) == []


def test_what_is_no_session_is_refused(tmp_path: Path, handmade: HandmadeSession) -> None:
    with pytest.raises(gtaharvest.NotASessionError, match="does not exist"):
        open_session(tmp_path / "nowhere")
    with pytest.raises(gtaharvest.NotASessionError, match="no session.json"):
        open_session(tmp_path)
    for text, message in (("{", "JSON object"), ("[]", "JSON object"), ('{"formatVersion":"1"}', "formatVersion")):
        (tmp_path / "session.json").write_text(text)
        with pytest.raises(gtaharvest.NotASessionError, match=message):
            open_session(tmp_path)


def test_a_newer_version_of_the_format_is_refused_by_name(handmade: HandmadeSession) -> None:
    handmade.info["formatVersion"] = 2
    with pytest.raises(gtaharvest.NewerFormatError, match="format version 2; this gtaharvest reads up to 1") as refused:
        open_session(handmade.write())
    assert "\n" not in str(refused.value)


@pytest.mark.parametrize("sign", ["state", "mark", "line"])
def test_a_partial_session_is_refused_unless_allowed(handmade: HandmadeSession, sign: str) -> None:
    if sign == "state":
        handmade.info["state"] = "recording"
    folder = handmade.write()
    if sign == "mark":
        (folder / ".harvester-unfinished").write_text("")
    if sign == "line":
        with open(folder / "labels.jsonl", "ab") as labels:
            labels.write(b'{"frame":3,')
    with pytest.raises(gtaharvest.PartialSessionError, match="allow_partial"):
        open_session(folder)
    assert len(open_session(folder, allow_partial=True)) == 3


def test_damaged_labels_are_named_by_line_and_field(handmade: HandmadeSession) -> None:
    del handmade.lines[1]["objects"][0]["box2dAmodal"]
    handmade.lines[2]["objects"][0]["box2d"] = 7
    session = open_session(handmade.write())
    with pytest.raises(gtaharvest.LabelError, match=r"labels.jsonl, line 2: the field 'box2dAmodal' is missing"):
        session[1].objects
    with pytest.raises(gtaharvest.LabelError, match="line 3"):
        session[2].objects
    labels = session.folder / "labels.jsonl"
    labels.write_text("[]\n{\n" + json.dumps({"frame": "x"}) + "\n")
    session = open_session(session.folder)
    for position in range(2):
        with pytest.raises(gtaharvest.LabelError, match=f"line {position + 1}: it is not a JSON object"):
            session[position]
    with pytest.raises(gtaharvest.LabelError, match="line 3"):
        session[2].number


def test_rider_names_its_vehicle():
    rider = ObjectLabel.from_json({**car(9, 0, 20), "class": "rider", "vehicle": 7})
    assert (rider.class_name, rider.vehicle) == ("rider", 7)
    assert ObjectLabel.from_json(car(9, 0, 20)).vehicle is None
