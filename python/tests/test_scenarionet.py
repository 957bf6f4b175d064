"""ScenarioNet's pickles from a Scenario message that is encoded here, field by field."""

import pickle
import struct

import numpy as np
import pytest

from gtaharvest import scenarionet
from gtaharvest.errors import ScenarioError


def _varint(value):
    out = b""
    while value > 0x7F:
        out += bytes([value & 0x7F | 0x80])
        value >>= 7
    return out + bytes([value])


def _whole(field, value):
    return _varint(field << 3) + _varint(value)


def _double(field, value):
    return _varint(field << 3 | 1) + struct.pack("<d", value)


def _single(field, value):
    return _varint(field << 3 | 5) + struct.pack("<f", value)


def _bytes(field, value):
    return _varint(field << 3 | 2) + _varint(len(value)) + value


def _point(x, y, z):
    return _double(1, x) + _double(2, y) + _double(3, z)


def _state(x):
    return (
        _double(2, x)
        + _double(3, 2.0)
        + _double(4, 0.5)
        + _single(5, 4.5)
        + _single(6, 2.0)
        + _single(7, 1.5)
        + _single(8, 0.25)
        + _single(9, 10.0)
        + _single(10, 0.0)
        + _whole(11, 1)
    )


def _scenario():
    track = _whole(1, 7) + _whole(2, 1) + _bytes(3, _state(1.0)) + _bytes(3, _whole(11, 0)) + _bytes(3, _state(3.0))
    light = _bytes(1, _whole(1, 1) + _whole(2, 4) + _bytes(3, _point(5.0, 0.0, 0.0)))
    line = b"".join(_bytes(8, _point(float(i), 0.0, 0.0)) for i in range(3))
    first = _whole(1, 1) + _bytes(3, _whole(2, 2) + line + _bytes(10, _varint(2)))
    second = _whole(1, 2) + _bytes(3, _whole(2, 1) + line + _bytes(9, _varint(1)))
    crossing = _whole(1, 3) + _bytes(8, b"".join(_bytes(1, _point(0.0, float(i), 0.0)) for i in range(4)))
    return (
        b"".join(_double(1, 0.1 * i) for i in range(3))
        + _bytes(2, track)
        + _bytes(5, b"0000_0001")
        + _whole(6, 0)
        + b"".join(_bytes(7, state) for state in (light, b"", light))
        + b"".join(_bytes(8, feature) for feature in (first, second, crossing))
        + _whole(10, 2)
    )


def _write(folder, data):
    head = struct.pack("<Q", len(data))
    (folder / "train.tfrecord-00000-of-00001").write_bytes(head + b"\0\0\0\0" + data + b"\0\0\0\0")


def test_scenario_has_what_the_message_has():
    scenario = scenarionet.scenario_of(_scenario())

    assert (scenario["id"], scenario["length"], scenario["metadata"]["sdc_id"]) == ("0000_0001", 3, "7")
    np.testing.assert_allclose(scenario["metadata"]["ts"], [0, 0.1, 0.2], atol=1e-6)
    track = scenario["tracks"]["7"]
    assert track["type"] == "VEHICLE"
    assert track["state"]["valid"].tolist() == [True, False, True]
    np.testing.assert_allclose(track["state"]["position"], [[1, 2, 0.5], [0, 0, 0], [3, 2, 0.5]])
    np.testing.assert_allclose(track["state"]["heading"], [0.25, 0, 0.25])
    assert scenario["dynamic_map_states"]["1"]["state"]["object_state"] == [
        "LANE_STATE_STOP",
        "LANE_STATE_UNKNOWN",
        "LANE_STATE_STOP",
    ]
    lanes = scenario["map_features"]
    assert (lanes["1"]["type"], lanes["1"]["exit_lanes"], lanes["2"]["entry_lanes"]) == (
        "LANE_SURFACE_STREET",
        ["2"],
        ["1"],
    )
    assert lanes["2"]["type"] == "LANE_FREEWAY"
    assert lanes["3"]["type"] == "CROSSWALK" and lanes["3"]["polygon"].shape == (4, 3)


def test_folder_has_a_pickle_a_scenario_and_its_lists(tmp_path):
    _write(tmp_path, _scenario())
    out = tmp_path / "out"

    assert scenarionet.main([str(tmp_path), str(out)]) == 0
    names = sorted(path.name for path in out.iterdir())
    assert names == ["dataset_mapping.pkl", "dataset_summary.pkl", "sd_gta_v1_0000_0001.pkl"]
    with open(out / "dataset_summary.pkl", "rb") as file:
        assert list(pickle.load(file)) == ["sd_gta_v1_0000_0001.pkl"]


@pytest.mark.parametrize("length", range(0, len(_scenario()), 7))
def test_cut_off_messages_are_refused_or_read(length):
    try:
        scenarionet.scenario_of(_scenario()[:length])
    except ScenarioError as problem:
        assert "\n" not in str(problem)


def test_folder_without_scenarios_is_refused(tmp_path, capsys):
    assert scenarionet.main([str(tmp_path), str(tmp_path / "out")]) == 1
    assert "it has no .tfrecord file" in capsys.readouterr().err
