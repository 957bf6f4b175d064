"""Reads image folders as Hugging Face's datasets do, and the header of the dataset card."""

import glob
import json
import os

import yaml
from PIL import Image

SIZES = ("n<1K", "1K<n<10K", "10K<n<100K", "100K<n<1M", "1M<n<10M", "10M<n<100M")


def card_of(root):
    """The header of README.md, whose lines stand between lines of three hyphens."""
    with open(os.path.join(root, "README.md"), encoding="utf-8") as file:
        text = file.read()
    assert text.startswith("---\n") and "is not a license" in text
    card = yaml.safe_load(text.split("\n---\n")[0])
    assert card["license"] and card["pretty_name"] and card["task_categories"] == ["object-detection"]
    assert all(size in SIZES for size in card["size_categories"])
    return card


def files_of(root, split):
    """The files of a split, by the patterns of the card."""
    (files,) = [item["path"] for item in card_of(root)["configs"][0]["data_files"] if item["split"] == split]
    return [path for path in glob.glob(os.path.join(root, files), recursive=True) if os.path.isfile(path)]


def read(root, labels):
    files = files_of(root, "train")
    (metadata,) = [path for path in files if os.path.basename(path) == "metadata.jsonl"]
    with open(metadata, encoding="utf-8") as file:
        rows = [json.loads(line) for line in file]
    assert len(rows) == len(labels) == len(files) - 1
    assert len({tuple(row) for row in rows}) == 1
    for row, label in zip(rows, labels):
        image = os.path.join(os.path.dirname(metadata), row["file_name"])
        assert image in files and Image.open(image).size == (label["camera"]["width"], label["camera"]["height"])
        objects = row["objects"]
        assert len(objects["bbox"]) == len(objects["categories"]) == len(objects["track_ids"])
        boxes = dict(zip(objects["track_ids"], objects["bbox"]))
        for item in label["objects"]:
            if item["parent"] is None and not item["knownParts"] and item["box2dVisible"]:
                x, y, width, height = boxes[item["id"]]
                assert [x, y, x + width, y + height] == item["box2dVisible"]


def read_webdataset_card(root):
    assert [os.path.basename(path) for path in files_of(root, "train")] == ["train-000000.tar"]
