"""Reads exported datasets with torchvision, OpenCV, Pillow and Python's own libraries and compares them with the session."""

import csv
import io
import json
import os
import sys
import tarfile

import cv2
import numpy as np
from PIL import Image
from torchvision.datasets import Cityscapes, Kitti, VOCDetection

import bdd100k
import culane
import euroc
import flow
import imagefolder
import mcap
import mcap_drive
import mcap_rig
import motchallenge
import nuscenes
import nuscenes_detection
import occ3d
import openlabel
import pairs
import panoptic
import radar
import rigs
from riders import joined

VANS = ("minivan", "speedo", "boxville")


def kitti_type(item):
    """The type of an object of the simulated game; None for what KITTI does not label."""
    if item["class"] in ("sign", "trafficLight"):
        return None
    if item["class"] == "car":
        return "Van" if item["model"] in VANS else "Car"
    if item["class"] == "bicycle":
        return "Cyclist" if item["hasRider"] else "Misc"
    return {"truck": "Truck", "pedestrian": "Pedestrian"}.get(item["class"], "Misc")


def seen_of(label):
    """The objects of a frame of which a pixel is seen, without faces and posts."""
    return [
        item for item in label["objects"] if item["parent"] is None and not item["knownParts"] and item["box2dVisible"]
    ]


def labels_of(folder):
    with open(os.path.join(folder, "session", "labels.jsonl"), encoding="utf-8") as lines:
        return [json.loads(line) for line in lines]


def json_of(*path):
    with open(os.path.join(*path), encoding="utf-8") as file:
        return json.load(file)


def lines_of(*path):
    with open(os.path.join(*path), encoding="utf-8") as file:
        return file.read().splitlines()


def pixels_of(*path):
    return np.array(Image.open(os.path.join(*path))).astype(np.int64)


def mask_of(folder, label):
    return pixels_of(folder, "session", label["mask"])


def size_of(label):
    return label["camera"]["width"], label["camera"]["height"]


def read_kitti(folder, labels):
    dataset = Kitti(folder, train=True)
    assert len(dataset) == len(labels)
    # The dataset lists the folder in the file system's order.
    by_image = {os.path.basename(path): i for i, path in enumerate(dataset.images)}
    for number, label in enumerate(labels):
        image, targets = dataset[by_image[f"{number:06d}.png"]]
        assert image.size == size_of(label)
        expected = [item for item in seen_of({"objects": list(joined(label))}) if kitti_type(item)]
        objects = [target for target in targets if target["type"] != "DontCare"]
        assert [target["type"] for target in objects] == [kitti_type(item) for item in expected]
        for target, item in zip(objects, expected):
            assert np.allclose(
                target["bbox"],
                np.clip(np.array(item["box2dVisible"]) - 0.5, 0, [image.width - 1, image.height - 1] * 2),
                atol=0.01,
            )
            assert np.allclose(
                np.array(target["dimensions"]), 2 * np.array(item["box3d"]["halfExtents"])[[2, 0, 1]], atol=0.001
            )


def read_cityscapes(folder, labels):
    dataset = Cityscapes(
        os.path.join(folder, "cityscapes"), split="train", mode="fine", target_type=["instance", "semantic"]
    )
    assert len(dataset) == len(labels)
    by_image = {os.path.basename(path): i for i, path in enumerate(dataset.images)}
    for number, label in enumerate(labels):
        _, (instances, classes) = dataset[by_image[f"session0000_000000_{number:06d}_leftImg8bit.png"]]
        mask = mask_of(folder, label)
        instances = np.array(instances).astype(np.int64)
        assert ((instances != 0) == (mask != 0)).all()
        assert (np.where(instances >= 1000, instances // 1000, instances) == np.array(classes)).all()


def read_voc(folder, labels):
    dataset = VOCDetection(os.path.join(folder, "voc"), year="2012", image_set="train")
    assert len(dataset) == len(labels)
    for (image, target), label in zip(dataset, labels):
        assert image.size == size_of(label)
        objects = {
            (item["name"], *(int(item["bndbox"][side]) for side in ("xmin", "ymin", "xmax", "ymax")))
            for item in target["annotation"].get("object", [])
        }
        # From the first pixel, which is 1, to the last, which belongs to the box.
        assert objects >= {
            (item["class"], item["box2dVisible"][0] + 1, item["box2dVisible"][1] + 1, *item["box2dVisible"][2:])
            for item in seen_of(label)
        }


def read_jpeg(folder, labels):
    """The encoder writes what libjpeg writes, and the decoder reads what libjpeg reads."""
    for number, label in enumerate(labels):
        converted = os.path.join(folder, "voc", "VOCdevkit", "VOC2012", "JPEGImages", f"{number:08d}.jpg")
        expected = io.BytesIO()
        Image.open(os.path.join(folder, "session", label["image"])).save(expected, "JPEG", quality=95, subsampling=0)
        with open(converted, "rb") as file:
            assert file.read() == expected.getvalue()
        decoded = pixels_of(folder, "from-jpeg", "images", f"{number:08d}.png")
        assert (decoded == pixels_of(converted)).all()
        assert (decoded == cv2.imread(converted)[:, :, ::-1]).all()


def read_coco(folder, labels):
    for annotation in json_of(folder, "coco", "annotations", "instances_train.json")["annotations"]:
        if annotation["iscrowd"]:
            continue
        height, width = annotation["segmentation"]["size"]
        counts = annotation["segmentation"]["counts"]
        values = np.repeat(np.arange(len(counts)) % 2, counts).reshape(width, height).T
        label = labels[annotation["image_id"]]
        mask = mask_of(folder, label)
        item = next(item for item in label["objects"] if item["id"] == annotation["track_id"])
        if item["parent"] is None:
            assert (values.astype(bool) == (mask == annotation["track_id"])).all()
        else:
            assert not (values.astype(bool) & (mask != item["parent"])).any()
        assert values.sum() == annotation["area"]
        assert list(cv2.boundingRect(values.astype(np.uint8))) == annotation["bbox"]


def filled(mask):
    """A mask with its holes filled: all that a flood of the background from outside, which also passes diagonally, does not reach."""
    flooded = np.pad(mask.astype(np.uint8), 1)
    cv2.floodFill(flooded, None, (0, 0), 2, flags=8)
    return flooded[1:-1, 1:-1] != 2


def inside(polygon, shape):
    """The pixels whose centres lie inside a polygon by the even-odd rule: an odd number of edges crosses the ray to their right."""
    height, width = shape
    columns, rows = np.meshgrid(np.arange(width) + 0.5, np.arange(height) + 0.5)
    crossings = np.zeros(shape, int)
    for (x0, y0), (x1, y1) in zip(polygon, np.roll(polygon, -1, axis=0)):
        if y0 != y1:
            crossings += ((y0 > rows) != (y1 > rows)) & (columns < x0 + (rows - y0) * (x1 - x0) / (y1 - y0))
    return crossings % 2 == 1


def read_coco_polygons(folder, labels):
    for annotation in json_of(folder, "coco-polygon", "annotations", "instances_train.json")["annotations"]:
        if annotation["image_id"] % 4 != 0 or annotation["iscrowd"] or annotation["category_id"] in (8, 9):
            continue
        mask = mask_of(folder, labels[annotation["image_id"]]) == annotation["track_id"]
        x, y, width, height = (int(side) for side in annotation["bbox"])
        seen = np.zeros((height, width), bool)
        for polygon in annotation["segmentation"]:
            seen |= inside(np.array(polygon).reshape(-1, 2) - [x, y], seen.shape)
        assert (seen == mask[y : y + height, x : x + width]).all()


def read_panoptic(folder, labels):
    for annotation in json_of(folder, "coco-panoptic", "annotations", "panoptic_train.json")["annotations"]:
        colours = pixels_of(folder, "coco-panoptic", "annotations", "panoptic_train", annotation["file_name"])
        ids = colours[..., 0] + 256 * colours[..., 1] + 65536 * colours[..., 2]
        label = labels[annotation["image_id"]]
        mask = mask_of(folder, label)
        props = [item["id"] for item in label["objects"] if item["knownParts"]]
        assert (ids[mask == 0] == 2 << 16).all()
        assert (ids == mask)[(mask != 0) & ~np.isin(mask, props)].all()
        assert {segment["id"]: segment["area"] for segment in annotation["segments_info"]} == {
            int(value): int(count) for value, count in zip(*np.unique(ids[ids != 0], return_counts=True))
        }


def read_yolo(folder, labels):
    with open(os.path.join(folder, "yolo", "data.yaml"), encoding="utf-8") as file:
        names = [line.split(": ")[1].strip() for line in file if line.startswith("  ")]
    for number, label in enumerate(labels):
        rows = [line.split() for line in lines_of(folder, "yolo", "labels", "train", f"{number:08d}.txt")]
        size = np.array(size_of(label))
        boxes = set()
        for row in rows:
            centre, extent = np.array(row[1:3], float) * size, np.array(row[3:5], float) * size
            corners = np.concatenate([centre - extent / 2, centre + extent / 2])
            assert np.allclose(corners, np.round(corners), atol=0.002)
            boxes.add((names[int(row[0])], *np.round(corners).astype(int).tolist()))
        assert boxes >= {(item["class"], *item["box2dVisible"]) for item in seen_of(label)}


def read_yolo_outlines(folder, labels):
    for number, label in enumerate(labels):
        mask = mask_of(folder, label)
        seen = [item for item in label["objects"] if item["parent"] is None and (mask == item["id"]).any()]
        rows = [line.split() for line in lines_of(folder, "yolo-segment", "labels", "train", f"{number:08d}.txt")]
        assert len(rows) == len(seen)
        for row, item in zip(rows, seen):
            corners = np.round(np.array(row[1:], float).reshape(-1, 2) * size_of(label)).astype(np.int32)
            # The library draws polygons so; their edges are the pixels right of and below the outline.
            drawn = cv2.fillPoly(np.zeros((mask.shape[0] + 1, mask.shape[1] + 1), np.uint8), [corners], 1)[
                :-1, :-1
            ].astype(bool)
            own = filled(mask == item["id"])
            assert not (own & ~drawn).any()


def read_webdataset(folder, labels):
    with tarfile.open(os.path.join(folder, "webdataset", "train-000000.tar")) as archive:
        members = archive.getmembers()
        assert len(members) == 3 * len(labels)
        for number, label in enumerate(labels):
            image, text, mask = members[3 * number : 3 * number + 3]
            assert json.load(archive.extractfile(text)) == label
            assert Image.open(io.BytesIO(archive.extractfile(image).read())).size == size_of(label)
            assert (np.array(Image.open(io.BytesIO(archive.extractfile(mask).read()))) == mask_of(folder, label)).all()


def read_openlane(folder, labels):
    points = 0
    for name in lines_of(folder, "openlane", "train.txt"):
        frame = json_of(folder, "openlane", "lane3d", os.path.splitext(name)[0] + ".json")
        for line in frame["lane_lines"]:
            forward, left, up = np.array(line["xyz"])
            # OpenCV's camera: x right, y down, z forward.
            projected, _ = cv2.projectPoints(
                np.stack([-left, -up, forward], 1), np.zeros(3), np.zeros(3), np.array(frame["intrinsic"], float), None
            )
            # Metres have four decimals: at a metre and a focal length of some hundred pixels that is some hundredths.
            assert np.allclose(projected[:, 0].T, np.array(line["uv"]), atol=0.05)
            points += len(forward)
    assert points > 0


def read_tusimple(folder, labels):
    frames = [json.loads(line) for line in lines_of(folder, "tusimple", "label_data_train.json")]
    assert len(frames) == sum(label["lanes"]["status"] == "known" for label in labels)
    for frame in frames:
        height, width, _ = cv2.imread(os.path.join(folder, "tusimple", frame["raw_file"])).shape
        lanes = np.array(frame["lanes"])
        assert lanes.shape[1] == len(frame["h_samples"]) and max(frame["h_samples"]) < height
        assert (((lanes >= 0) & (lanes < width)) | (lanes == -2)).all()


# The linear maps of DeepDriving's loss layer, value * factor + shift, in the order of its labels.
LOSS_LAYER = [
    (1 / 1.1, 0.5),
    (0.17778, 1.34445),
    (0.14545, 0.39091),
    (0.17778, -0.34445),
    (1 / 95, 0.12),
    (1 / 95, 0.12),
    (0.14545, 1.48181),
    (0.16, 0.98),
    (0.16, 0.02),
    (0.14545, -0.48181),
    (1 / 95, 0.12),
    (1 / 95, 0.12),
    (1 / 95, 0.12),
]


def read_deepdriving(folder, labels):
    names = [
        "angle",
        "toMarkingL",
        "toMarkingM",
        "toMarkingR",
        "distL",
        "distR",
        "toMarkingLL",
        "toMarkingML",
        "toMarkingMR",
        "toMarkingRR",
        "distLL",
        "distMM",
        "distRR",
    ]
    for number, label in enumerate(labels):
        name = f"{number:08d}"
        small = cv2.imread(os.path.join(folder, "deepdriving", "images", name + ".png"))
        assert small.shape == (210, 280, 3)
        # OpenCV's averaging of areas rounds once, ours may round otherwise by one.
        whole = cv2.imread(os.path.join(folder, "session", label["image"]))
        assert np.abs(cv2.resize(whole, (280, 210), interpolation=cv2.INTER_AREA).astype(int) - small).max() <= 1
        metres = np.array(lines_of(folder, "deepdriving", "indicators", name + ".txt")[0].split(), float)
        assert np.allclose(metres, [label["lanes"]["indicators"][indicator] for indicator in names], atol=1e-6)
        torcs = [label["lanes"]["torcsEquivalent"][indicator] for indicator in names]
        expected = [value * factor + shift for value, (factor, shift) in zip(torcs, LOSS_LAYER)]
        expected[0] = min(1, max(0, expected[0]))
        normalised = np.array(lines_of(folder, "deepdriving", "normalised", name + ".txt")[0].split(), float)
        assert np.allclose(normalised, expected, atol=2e-6)


def read_csv(folder, labels):
    with open(os.path.join(folder, "csv", "objects.csv"), encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    expected = [
        (str(number), str(item["id"]), item["class"], item["name"] or "", str(item["parent"] or ""))
        for number, label in enumerate(labels)
        for item in label["objects"]
    ]
    assert [(row["frame"], row["id"], row["class"], row["name"], row["parent"]) for row in rows] == expected


def rotated(quaternion, vector):
    """A vector turned by a unit quaternion: v + 2w (u x v) + 2 u x (u x v)."""
    u = np.array([quaternion.x, quaternion.y, quaternion.z])
    once = np.cross(u, vector)
    return np.array(vector) + 2 * quaternion.w * once + 2 * np.cross(u, once)


def position_of(vector):
    return np.array([vector.x, vector.y, vector.z])


def read_mcap(folder, labels):
    messages = mcap.read(os.path.join(folder, "mcap", "train", "0000.mcap"))
    for number, label in enumerate(labels):
        at = {topic: all_of[number][1] for topic, all_of in messages.items() if len(all_of) == len(labels)}
        assert all(
            all_of[number][0] == round(label["timeSeconds"] * 1e9)
            for all_of in messages.values()
            if len(all_of) == len(labels)
        )
        image = np.array(Image.open(io.BytesIO(at["/camera/image"].data)))
        assert at["/camera/image"].format == "png"
        assert np.array_equal(image, np.array(Image.open(os.path.join(folder, "session", label["image"]))))

        # A corner of a cuboid, through the transform and the calibration of the messages, is the corner of the session's camera.
        calibration, camera = at["/camera/calibration"], label["camera"]
        matrix = np.array(calibration.K).reshape(3, 3)
        assert (calibration.width, calibration.height) == size_of(label)
        pose = next(item for item in at["/tf"].transforms if item.child_frame_id == "camera")
        cubes = {int(entity.id): entity.cubes[0] for entity in at["/objects"].entities}
        whole = [item for item in label["objects"] if item["id"] in cubes]
        assert whole and len(cubes) == len(whole)
        for item in whole:
            cube, box = cubes[item["id"]], item["box3d"]
            corner = position_of(cube.pose.position) + rotated(cube.pose.orientation, position_of(cube.size) / 2)
            x, y, z = (np.array(box[axis]) for axis in ("right", "forward", "up"))
            right, forward, up = box["halfExtents"]
            assert np.allclose(corner, box["centre"] + forward * y - right * x + up * z, atol=1e-4)
            away = corner - np.array(camera["position"])
            ahead = np.dot(away, camera["forward"])
            if ahead > 1:
                turned = pose.rotation
                turned.x, turned.y, turned.z = -turned.x, -turned.y, -turned.z
                seen = matrix @ rotated(turned, corner - position_of(pose.translation))
                turned.x, turned.y, turned.z = -turned.x, -turned.y, -turned.z
                column = camera["cx"] + camera["fx"] * np.dot(away, camera["right"]) / ahead
                row = camera["cy"] - camera["fy"] * np.dot(away, camera["up"]) / ahead
                assert np.allclose(seen[:2] / seen[2], [column, row], atol=0.05)
        loops = [points for points in at["/camera/annotations"].points if points.type == 2]
        assert len(loops) == len(whole)
    known = [label for label in labels if label["lanes"]["status"] == "known"]
    assert len(messages["/indicators"]) == len(known)
    for label, (_, message) in zip(known, messages["/indicators"]):
        for name, value in label["lanes"]["indicators"].items():
            if name != "valid" and message.HasField(name):
                assert abs(getattr(message, name) - value) < 1e-6


if __name__ == "__main__":
    root = sys.argv[1]
    session = labels_of(root)
    readers = (
        read_kitti,
        read_cityscapes,
        read_voc,
        read_jpeg,
        read_coco,
        read_coco_polygons,
        read_panoptic,
        read_yolo,
        read_yolo_outlines,
        read_deepdriving,
        read_webdataset,
        read_openlane,
        read_tusimple,
        read_csv,
        read_mcap,
    )
    for reader in readers:
        reader(root, session)
        print(f"{reader.__name__}: {len(session)} frames as in the session")
    for module in (bdd100k, culane, imagefolder, motchallenge, openlabel):
        module.read(os.path.join(root, module.__name__), session)
        print(f"{module.__name__}: {len(session)} frames as in the session")
    panoptic.read(os.path.join(root, "classes"), os.path.join(root, "panoptic-stuff"))
    print(nuscenes.read(os.path.join(root, "nuscenes"), os.path.join(root, "around")))
    print(nuscenes_detection.read(os.path.join(root, "nuscenes")))
    print(
        rigs.read(os.path.join(root, "grey-and-colour"), *(os.path.join(root, f"rig-{name}") for name in rigs.FORMATS))
    )
    print(
        mcap_drive.read(
            os.path.join(root, "recorded"),
            os.path.join(root, "recorded-mcap", "train", "0000.mcap"),
            os.path.join(root, "mcap", "train", "0000.mcap"),
        )
    )
    print(mcap_rig.read(os.path.join(root, "rig"), os.path.join(root, "rig-mcap")))
    print(occ3d.read(*(os.path.join(root, name) for name in ("rig", "rig-occ3d", "rig-mcap"))))
    print(radar.read(os.path.join(root, "radar"), os.path.join(root, "radar-nuscenes")))
    print(euroc.read(os.path.join(root, "flowing"), os.path.join(root, "euroc")))
    print(flow.read(root, os.path.join(root, "KittiFlow"), os.path.join(root, "middlebury-flow")))
    print(pairs.read(*(os.path.join(root, name) for name in ("moments", "pairs-csv", "pairs-webdataset"))))
    imagefolder.read_webdataset_card(os.path.join(root, "webdataset"))
