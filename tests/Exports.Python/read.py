"""Reads exported datasets with torchvision and Python's own libraries and compares them with the session."""

import io
import json
import os
import sys
import tarfile

import numpy as np
from PIL import Image
from torchvision.datasets import Cityscapes, Kitti

KITTI_TYPES = {
    "car": "Car", "truck": "Truck", "pedestrian": "Pedestrian", "bicycle": "Cyclist",
    "bus": "Misc", "motorcycle": "Misc", "trailer": "Misc", "other": "Misc",
}


def labels_of(folder):
    with open(os.path.join(folder, "session", "labels.jsonl"), encoding="utf-8") as lines:
        return [json.loads(line) for line in lines]


def mask_of(folder, label):
    return np.array(Image.open(os.path.join(folder, "session", label["mask"]))).astype(np.int64)


def read_kitti(folder, labels):
    dataset = Kitti(folder, train=True)
    assert len(dataset) == len(labels)
    # The dataset lists the folder in the file system's order.
    by_image = {os.path.basename(path): i for i, path in enumerate(dataset.images)}
    for number, label in enumerate(labels):
        image, targets = dataset[by_image[f"{number:06d}.png"]]
        assert image.size == (label["camera"]["width"], label["camera"]["height"])
        expected = [item for item in label["objects"] if item["class"] in KITTI_TYPES]
        assert [target["type"] for target in targets] == [KITTI_TYPES[item["class"]] for item in expected]
        for target, item in zip(targets, expected):
            assert np.allclose(target["bbox"], np.clip(np.array(item["box2d"]) - 0.5, 0, [image.width - 1, image.height - 1] * 2), atol=0.01)
            assert np.allclose(np.array(target["dimensions"]), 2 * np.array(item["box3d"]["halfExtents"])[[2, 0, 1]], atol=0.001)


def read_cityscapes(folder, labels):
    dataset = Cityscapes(os.path.join(folder, "cityscapes"), split="train", mode="fine", target_type=["instance", "semantic"])
    assert len(dataset) == len(labels)
    by_image = {os.path.basename(path): i for i, path in enumerate(dataset.images)}
    for number, label in enumerate(labels):
        _, (instances, classes) = dataset[by_image[f"session0000_000000_{number:06d}_leftImg8bit.png"]]
        mask = mask_of(folder, label)
        instances = np.array(instances).astype(np.int64)
        assert ((instances != 0) == (mask != 0)).all()
        assert (np.where(instances >= 1000, instances // 1000, instances) == np.array(classes)).all()


def read_coco(folder, labels):
    with open(os.path.join(folder, "coco", "annotations", "instances_train.json"), encoding="utf-8") as file:
        coco = json.load(file)
    for annotation in coco["annotations"]:
        height, width = annotation["segmentation"]["size"]
        counts = annotation["segmentation"]["counts"]
        values = np.repeat(np.arange(len(counts)) % 2, counts).reshape(width, height).T
        mask = mask_of(folder, labels[annotation["image_id"]])
        assert (values.astype(bool) == (mask == annotation["track_id"])).all()
        assert values.sum() == annotation["area"]


def read_webdataset(folder, labels):
    with tarfile.open(os.path.join(folder, "webdataset", "train-000000.tar")) as archive:
        members = archive.getmembers()
        assert len(members) == 3 * len(labels)
        for number, label in enumerate(labels):
            image, text, mask = members[3 * number : 3 * number + 3]
            assert json.load(archive.extractfile(text)) == label
            assert Image.open(io.BytesIO(archive.extractfile(image).read())).size == (label["camera"]["width"], label["camera"]["height"])
            assert (np.array(Image.open(io.BytesIO(archive.extractfile(mask).read()))) == mask_of(folder, label)).all()


if __name__ == "__main__":
    root = sys.argv[1]
    session = labels_of(root)
    for reader in (read_kitti, read_cityscapes, read_coco, read_webdataset):
        reader(root, session)
        print(f"{reader.__name__}: {len(session)} frames as in the session")
