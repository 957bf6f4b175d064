"""The export of pairs, read with csv, tarfile and OpenCV, beside the session."""

import csv
import json
import os
import tarfile

import cv2
import numpy as np


def rows_of(folder, name):
    with open(os.path.join(folder, name), newline="", encoding="utf-8") as table:
        return list(csv.DictReader(table))


def read(session, tables, archives):
    with open(os.path.join(session, "labels.jsonl"), encoding="utf-8") as lines:
        labels = {f"{label['frame']:08d}": label for label in map(json.loads, lines)}
    samples = {}
    for name in sorted(os.listdir(archives)):
        if name.endswith(".tar"):
            with tarfile.open(os.path.join(archives, name)) as archive:
                for entry in archive:
                    key, part = entry.name.split(".", 1)
                    samples.setdefault(key, {})[part] = archive.extractfile(entry).read()
    assert list(samples) == list(labels)
    index = rows_of(tables, "index.csv")
    in_archives = rows_of(archives, "index.csv")
    assert len(in_archives) == len(index)
    pictures = 0
    for key, label in labels.items():
        assert json.loads(samples[key]["json"]) == label
        pairs = [pair for pair in label["pairs"] if pair["file"] is not None]
        rows = [row for row in index if row["group"] == key]
        archived = [row for row in in_archives if row["group"] == key]
        assert len(rows) == len(archived) == 1 + len(pairs) and len(samples[key]) == 2 + len(pairs)
        objects = {item["id"]: item for item in label["objects"]}
        expected = [{"file": label["image"], "without": [], **label["environment"]}, *pairs]
        shown = {}
        for row, packed, pair in zip(rows, archived, expected):
            with open(os.path.join(session, pair["file"]), "rb") as file:
                original = file.read()
            with open(os.path.join(tables, row["image"]), "rb") as file:
                assert file.read() == original
            assert samples[key][packed["image"].split("/")[1].split(".", 1)[1]] == original
            picture = cv2.imdecode(np.frombuffer(original, np.uint8), cv2.IMREAD_COLOR)
            assert picture.shape == (label["camera"]["height"], label["camera"]["width"], 3)
            assert (row["weather"], row["time_of_day"]) == (pair["weather"], pair["timeOfDay"])
            without = [int(number) for number in row["without"].split()]
            assert without == pair["without"]
            sky = pair["weather"], pair["timeOfDay"]
            if not without:
                assert row["x_min"] == ""
                shown[sky] = picture
                continue
            boxes = np.array([objects[number]["box2d"] for number in without])
            box = [float(row[name]) for name in ("x_min", "y_min", "x_max", "y_max")]
            assert np.allclose(box, [*boxes[:, :2].min(axis=0), *boxes[:, 2:].max(axis=0)], atol=1e-3)
            # Without detail there are no shadows and reflections: the pictures differ in the box, up to the smoothing of its border.
            changed = np.argwhere((picture != shown[sky]).any(axis=2))
            assert len(changed) and (changed.min(axis=0) >= np.floor(box[1::-1]) - 1).all()
            assert (changed.max(axis=0) <= np.ceil(box[:1:-1]) + 1).all()
        pictures += len(rows)
    assert len(rows_of(tables, "objects.csv")) == sum(len(label["objects"]) for label in labels.values())
    return f"pairs: {len(labels)} groups, {pictures} pictures as in the session"
