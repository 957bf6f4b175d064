"""The MCAP files of a rig against the label lines, images, depth maps and points of its session."""

import glob
import io
import json
import os

import cv2
import numpy as np
from PIL import Image

import mcap

# Quaternions of messages follow from the label's axes, which have nine decimals.
ROUNDING = 1e-6

# A file of points has 24 bytes a point: position, intensity, column, beam, object, class, and whether it is interpolated.
POINT = np.dtype("<f4,<f4,<f4,<f4,<u2,<u2,<u2,u1,u1")

# Fields of the same in a message.
CLOUD = [
    ("x", 0, 7),
    ("y", 4, 7),
    ("z", 8, 7),
    ("intensity", 12, 7),
    ("beam", 16, 3),
    ("object", 18, 3),
    ("class", 20, 1),
    ("interpolated", 21, 1),
]
CLOUD_TYPES = {7: "<f4", 3: "<u2", 1: "u1"}


def matrix(quaternion):
    w, x, y, z = (getattr(quaternion, name) for name in "wxyz")
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def check_frame(transform, position, columns):
    vector = transform.translation
    assert transform.parent_frame_id == "world"
    assert np.allclose([vector.x, vector.y, vector.z], position, atol=ROUNDING)
    assert np.allclose(matrix(transform.rotation), np.array(columns).T, atol=ROUNDING)


def check_points(session, sweep, message):
    packed = np.fromfile(os.path.join(session, sweep["file"]), POINT)
    assert [(field.name, field.offset, field.type) for field in message.fields] == CLOUD
    assert message.point_stride == 22 and message.frame_id == "lidar/" + sweep["sensor"]
    assert message.pose.orientation.w == 1 and len(packed) == sweep["points"]
    names, formats, offsets = ([item[i] for item in CLOUD] for i in (0, 2, 1))
    kind = np.dtype(
        {"names": names, "formats": [CLOUD_TYPES[code] for code in formats], "offsets": offsets, "itemsize": 22}
    )
    cloud = np.frombuffer(message.data, kind)
    expected = (
        packed["f1"],
        -packed["f0"],
        packed["f2"],
        packed["f3"],
        packed["f5"],
        packed["f6"],
        packed["f7"],
        packed["f8"] & 1,
    )
    assert all(np.array_equal(cloud[name], values) for name, values in zip(names, expected))
    return len(cloud)


def check_depth(session, label, message):
    file = label["depth"].get("completed") or label["depth"]["sparse"]
    stored = cv2.imread(os.path.join(session, file), cv2.IMREAD_UNCHANGED)
    assert message.encoding == "32FC1" and message.step == 4 * message.width
    metres = np.frombuffer(message.data, "<f4").reshape(message.height, message.width)
    assert np.array_equal(np.isnan(metres), stored == 0)
    assert np.array_equal(np.nan_to_num(metres), stored / np.float32(256)) and (stored > 0).any()


def check_moment(session, rig, labels, at):
    """Compares the messages of a moment with its label lines, one for each view."""
    transforms = {item.child_frame_id: item for message in at["/tf"] for item in message.transforms}
    names = [f"camera/{camera['name']}" for camera in rig["cameras"]] + [
        f"lidar/{item['name']}" for item in rig["lidars"]
    ]
    assert sorted(transforms) == sorted([*names, "ego"])
    first, ego = labels[0], labels[0]["ego"]
    right, forward, up = (np.array(ego[axis]) for axis in ("right", "forward", "up"))
    check_frame(transforms["ego"], ego["position"], [forward, -right, up])

    # A LiDAR of these rigs is level: its mount is the rig's origin and its position, along the axes of the vehicle.
    for lidar, sweep in zip(rig["lidars"], first["lidar"]):
        mount = np.array(rig["origin"]) + lidar["position"]
        place = np.array(ego["position"]) + mount @ [right, forward, up]
        check_frame(transforms[f"lidar/{lidar['name']}"], place, [forward, -right, up])
        (cloud,) = at[f"/lidar/{lidar['name']}"]
        assert check_points(session, sweep, cloud) > 0

    scene = {}
    for number, (label, update) in enumerate(zip(labels, at["/objects"])):
        assert len(update.deletions) == (1 if number == 0 else 0)
        known = {str(item["id"]) for item in label["objects"]}
        assert all(entity.id in known for entity in update.entities)
        scene.update({entity.id: entity for entity in update.entities})
        camera, topic = label["camera"], "/camera/" + label["view"]
        x, y, z = (np.array(camera[axis]) for axis in ("right", "forward", "up"))
        check_frame(transforms[topic[1:]], camera["position"], [x, -z, y])
        (image,), (calibration,), (drawn,), (depth,) = (
            at[f"{topic}/{name}"] for name in ("image", "calibration", "annotations", "depth")
        )
        assert image.frame_id == calibration.frame_id == depth.frame_id == topic[1:]
        with open(os.path.join(session, label["image"]), "rb") as file:
            assert image.data == file.read()
        assert Image.open(io.BytesIO(image.data)).size == (calibration.width, calibration.height)
        assert np.allclose(np.array(calibration.K)[[0, 4, 2, 5]], [camera[name] for name in ("fx", "fy", "cx", "cy")])
        assert len(drawn.texts) == len(update.entities)
        check_depth(session, label, depth)
    boxes = {str(item["id"]): item["box3d"] for label in labels for item in label["objects"]}
    for name, entity in scene.items():
        centre, size = entity.cubes[0].pose.position, entity.cubes[0].size
        assert np.allclose([centre.x, centre.y, centre.z], boxes[name]["centre"], atol=ROUNDING)
        assert np.allclose(np.array([size.y, size.x, size.z]) / 2, boxes[name]["halfExtents"], atol=ROUNDING)
    return len(scene)


def read(session, folder):
    """Checks the files of a rig: everything of each moment of the session is in one of them, once, and by rising time."""
    with open(os.path.join(session, "labels.jsonl"), encoding="utf-8") as lines:
        labels = [json.loads(line) for line in lines]
    with open(os.path.join(session, "session.json"), encoding="utf-8") as file:
        rig = json.load(file)["rig"]
    places = {}
    for label in labels:
        places.setdefault(label["place"], {}).setdefault(label["moment"], []).append(label)
    files = sorted(glob.glob(os.path.join(folder, "train", "*.mcap")))
    assert len(files) == len(places)
    objects = 0
    for path, moments in zip(files, places.values()):
        messages = mcap.read(path)
        times = [time for time, _ in messages["/tf"]]
        assert times == sorted(times)
        for views in moments.values():
            assert [view["view"] for view in views] == [camera["name"] for camera in rig["cameras"]]
            moment = round(views[0]["timeSeconds"] * 1e9)
            at = {topic: [item for time, item in all_of if time == moment] for topic, all_of in messages.items()}
            objects += check_moment(session, rig, views, at)
        for camera in rig["cameras"]:
            assert len(messages[f"/camera/{camera['name']}/image"]) == len(moments)
        assert "/camera/image" not in messages
    assert objects > 0
    return f"mcap_rig: {len(labels)} views of {len(files)} places, and {objects} objects, as in the session"
