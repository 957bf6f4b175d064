"""Reads BDD100K's lists of frames as Scalabel does."""

import itertools
import json
import os

import numpy as np
from PIL import Image

EVALUATED = (
    "pedestrian",
    "rider",
    "car",
    "truck",
    "bus",
    "train",
    "motorcycle",
    "bicycle",
    "traffic light",
    "traffic sign",
)
IGNORED = ("other person", "other vehicle", "trailer")
CATEGORIES = {"sign": "traffic sign", "trafficLight": "traffic light", "other": "other vehicle"}
COLOURS = {"red": "red", "amber": "yellow", "green": "green"}


def load(root, *path):
    with open(os.path.join(root, "labels", *path), encoding="utf-8") as file:
        return json.load(file)


def read(root, labels):
    frames = load(root, "det_20", "det_train.json")
    videos = [list(group) for _, group in itertools.groupby(frames, lambda frame: frame["videoName"])]
    assert len(videos) == 1
    assert [frame["frameIndex"] for frame in videos[0]] == list(range(len(labels)))
    for frame, label in zip(frames, labels):
        size = frame["size"]["width"], frame["size"]["height"]
        assert Image.open(os.path.join(root, "images", "100k", "train", frame["name"])).size == size
        assert abs(frame["timestamp"] - 1000 * label["timeSeconds"]) <= 0.5
        assert frame["attributes"]["timeofday"] in ("daytime", "night", "dawn/dusk")
        objects = {int(item["id"]): item for item in frame["labels"] if not item["attributes"]["crowd"]}
        seen = {
            item["id"]: item
            for item in label["objects"]
            if item["parent"] is None and not item["knownParts"] and item["box2dVisible"]
        }
        assert seen.keys() <= objects.keys()
        for number, item in objects.items():
            assert item["category"] in EVALUATED + IGNORED
            source = next(other for other in label["objects"] if other["id"] == number)
            assert item["category"] == CATEGORIES.get(source["class"], source["class"])
            box = item["box2d"]
            # As in COCO: the last pixel belongs to the box.
            width, height = box["x2"] - box["x1"] + 1, box["y2"] - box["y1"] + 1
            assert width > 0 and height > 0
            if number in seen:
                assert [box["x1"], box["y1"], box["x1"] + width, box["y1"] + height] == source["box2dVisible"]
            light = (source.get("space") or {}).get("light")
            assert item["attributes"]["trafficLightColor"] == COLOURS.get(light and light["state"], "none")
            assert item["attributes"]["truncated"] == (source["truncatedFraction"] > 0.05)
    read_lanes(root, labels)


def read_lanes(root, labels):
    frames = load(root, "lane", "polygons", "lane_train.json")
    known = [label for label in labels if label["lanes"]["status"] == "known"]
    assert len(frames) == len(known) > 0
    for frame, label in zip(frames, known):
        assert len(frame["labels"]) == len(label["lanes"]["markings"])
        for item, marking in zip(frame["labels"], label["lanes"]["markings"]):
            double = marking["style"] == "doubleSolid"
            assert item["category"] == f"{'double' if double else 'single'} {marking['colour']}"
            assert item["attributes"]["laneStyle"] == ("dashed" if marking["style"] == "dashed" else "solid")
            (line,) = item["poly2d"]
            assert line["types"] == "L" * len(line["vertices"]) and not line["closed"]
            assert np.allclose(line["vertices"], marking["pixels"], atol=0.001)
