"""Reads the radar files of a nuScenes export by the rules of nuScenes' devkit and compares them with the labels."""

import json
import os
import struct

import numpy as np

SIZES = {"F": {4: "f"}, "I": {1: "b", 2: "h", 4: "i"}}


def points_of(path):
    """The points of a file as (fields, points): header lines in their order, then one record a point, and something after the last."""
    with open(path, "rb") as file:
        content = file.read()
    header, rest = {}, content
    assert content.startswith(b"#")
    while "DATA" not in header:
        line, rest = rest.split(b"\n", 1)
        words = line.decode("ascii").split(" ")
        header[words[0]] = words[1:]
    assert list(header) == "# VERSION FIELDS SIZE TYPE COUNT WIDTH HEIGHT VIEWPOINT POINTS DATA".split(" ")
    assert header["DATA"] == ["binary"] and header["HEIGHT"] == ["1"] and header["WIDTH"] == header["POINTS"]
    form = "<" + "".join(SIZES[kind][int(size)] for kind, size in zip(header["TYPE"], header["SIZE"]))
    count, size = int(header["POINTS"][0]), struct.calcsize(form)
    assert count * size < len(rest)
    points = [struct.unpack_from(form, rest, at * size) for at in range(count)]
    if np.isnan(points[0][0]):
        points = []
    return header["FIELDS"], np.array(points).reshape(-1, len(header["FIELDS"])).T


def read(session, folder):
    """Compares every file with the detections in the labels."""
    with open(os.path.join(session, "labels.jsonl"), encoding="utf-8") as lines:
        labels = [json.loads(line) for line in lines]
    with open(os.path.join(folder, "v1.0-gta", "sensor.json"), encoding="utf-8") as file:
        radars = [sensor for sensor in json.load(file) if sensor["modality"] == "radar"]
    scans = [scan for label in labels for scan in label.get("radar", [])]
    files = 0
    detections = 0
    for radar in radars:
        own = sorted(
            os.path.join(folder, part, radar["channel"], name)
            for part in ("samples", "sweeps")
            if os.path.isdir(os.path.join(folder, part, radar["channel"]))
            for name in os.listdir(os.path.join(folder, part, radar["channel"]))
        )
        own.sort(key=lambda path: path.rsplit("__", 1)[1])
        expected = [scan for scan in scans if scan["sensor"] == radar["channel"]]
        assert len(own) == len(expected) > 0
        for path, scan in zip(own, expected):
            fields, points = points_of(path)
            at = dict(zip(fields, points))
            angle = np.radians(scan["azimuthsDegrees"])
            ranges, radial = np.array(scan["ranges"]), np.array(scan["radialVelocities"])
            assert np.allclose(np.hypot(at["x"], at["y"]), ranges, rtol=1e-6)
            assert np.allclose(np.arctan2(at["y"], at["x"]), angle, atol=1e-6)
            assert np.allclose(at["vx"] * np.cos(angle) + at["vy"] * np.sin(angle), radial, atol=1e-5)
            compensated = at["vx_comp"] * np.cos(angle) + at["vy_comp"] * np.sin(angle)
            assert np.allclose(compensated, scan["groundVelocities"], atol=1e-5)
            assert np.allclose(at["rcs"], scan["crossSections"], atol=1e-5)

            # The devkit keeps these by default.
            assert (
                set(at["invalid_state"]) <= {0}
                and set(at["ambig_state"]) <= {3}
                and set(at["dyn_prop"]) <= set(range(7))
            )
            files += 1
            detections += len(ranges)
    assert detections > 0
    return f"radar: {detections} detections in {files} files of {len(radars)} radars as in the session"
