"""Reads nuScenes from its schema, without the devkit: links of all tables, chains, geometry, points in boxes, map masks."""

import json
import math
import os
import struct

import numpy as np
from PIL import Image

from riders import joined

VERSION = "v1.0-gta"
TABLES = {
    "attribute": ["name", "description"],
    "calibrated_sensor": ["sensor_token", "translation", "rotation", "camera_intrinsic"],
    "category": ["name", "description", "index"],
    "ego_pose": ["timestamp", "translation", "rotation"],
    "instance": ["category_token", "nbr_annotations", "first_annotation_token", "last_annotation_token"],
    "log": ["logfile", "vehicle", "date_captured", "location"],
    "map": ["category", "filename", "log_tokens"],
    "sample": ["timestamp", "scene_token", "prev", "next"],
    "sample_annotation": [
        "sample_token",
        "instance_token",
        "visibility_token",
        "attribute_tokens",
        "translation",
        "size",
        "rotation",
        "prev",
        "next",
        "num_lidar_pts",
        "num_radar_pts",
        "num_lidar_hits",
    ],
    "sample_data": [
        "sample_token",
        "ego_pose_token",
        "calibrated_sensor_token",
        "timestamp",
        "fileformat",
        "is_key_frame",
        "height",
        "width",
        "filename",
        "prev",
        "next",
    ],
    "scene": ["log_token", "nbr_samples", "first_sample_token", "last_sample_token", "name", "description"],
    "sensor": ["channel", "modality"],
    "visibility": ["level", "description"],
}
# The time at which every first session begins, microseconds.
START = 1_577_836_800_000_000
# A point on a surface may lie outside the box of its model by what the box is rounded to.
MARGIN_METRES = 0.02
LEAST_SHARE_IN_BOXES = 0.95
# Masks have ten pixels per metre; a pixel is 255 or 0.
PIXELS_PER_METRE = 10
# Classes of points in a session that lie on roads, and beside them. The lanes, which the mask shows, have parking strips beside them; trees
# and bridges reach over them.
ROAD_CLASSES, OTHER_CLASSES = (1, 3), (2, 4, 5, 6)
PARKING_METRES = 3
LEAST_SHARE_ON_ROADS, LEAST_SHARE_NEAR_ROADS, MOST_OTHERS_ON_ROADS = 0.6, 0.97, 0.03
POINT = np.dtype([("place", "<f4", 3), ("other", "u1", 10), ("class", "u1"), ("flag", "u1")])
AROUND = [(math.cos(angle * math.pi / 8), math.sin(angle * math.pi / 8)) for angle in range(16)]


def matrix(quaternion):
    w, x, y, z = quaternion
    assert abs(w * w + x * x + y * y + z * z - 1) < 1e-6
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
        [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
        [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)],
    ]


def out_of(frame, point):
    """A point of a frame in the frame around it."""
    rows = matrix(frame["rotation"])
    return [sum(r * p for r, p in zip(row, point)) + t for row, t in zip(rows, frame["translation"])]


def into(frame, point):
    """A point of the frame around a frame in the frame."""
    rows = matrix(frame["rotation"])
    moved = [p - t for p, t in zip(point, frame["translation"])]
    return [sum(rows[i][j] * moved[i] for i in range(3)) for j in range(3)]


def load(root):
    tables = {}
    for name, fields in TABLES.items():
        with open(os.path.join(root, VERSION, name + ".json"), encoding="utf-8") as file:
            records = json.load(file)
        tables[name] = {record["token"]: record for record in records}
        assert len(tables[name]) == len(records), f"{name}: a token occurs twice"
        for record in records:
            assert sorted(record) == sorted(["token", *fields]), f"{name}: {sorted(record)}"
    return tables


def check_links(tables):
    for name, table in tables.items():
        for record in table.values():
            for field, value in record.items():
                target = field.removesuffix("_token").removesuffix("_tokens")
                target = {
                    "first_annotation": "sample_annotation",
                    "last_annotation": "sample_annotation",
                    "first_sample": "sample",
                    "last_sample": "sample",
                }.get(target, target)
                if field.endswith("_token") or field.endswith("_tokens"):
                    for token in value if isinstance(value, list) else [value]:
                        assert token in tables[target], f"{name}.{field}"
                elif field in ("prev", "next") and value:
                    other = {"prev": "next", "next": "prev"}[field]
                    assert table[value][other] == record["token"], f"{name}.{field}"
    logs = {token for record in tables["map"].values() for token in record["log_tokens"]}
    assert logs == set(tables["log"])


def check_chains(tables):
    for scene in tables["scene"].values():
        token, count = scene["first_sample_token"], 1
        while tables["sample"][token]["next"]:
            before, token = token, tables["sample"][token]["next"]
            assert tables["sample"][before]["timestamp"] < tables["sample"][token]["timestamp"]
            count += 1
        assert (token, count) == (scene["last_sample_token"], scene["nbr_samples"])
    for instance in tables["instance"].values():
        token, count = instance["first_annotation_token"], 1
        while tables["sample_annotation"][token]["next"]:
            token = tables["sample_annotation"][token]["next"]
            count += 1
        assert (token, count) == (instance["last_annotation_token"], instance["nbr_annotations"])


def check_geometry(root, tables):
    """Annotated boxes are before the cameras that may see them, and exactly their points are in them."""
    boxes = {}
    for annotation in tables["sample_annotation"].values():
        boxes.setdefault(annotation["sample_token"], []).append(annotation)
        assert isinstance(annotation["num_lidar_pts"], int) and len(annotation["attribute_tokens"]) <= 1
    seen, counted, within, sweeps = set(), 0, 0, 0
    for data in tables["sample_data"].values():
        assert os.path.isfile(os.path.join(root, data["filename"])), data["filename"]
        assert data["filename"].startswith("samples/" if data["is_key_frame"] else "sweeps/")
        pose, sensor = (
            tables["ego_pose"][data["ego_pose_token"]],
            tables["calibrated_sensor"][data["calibrated_sensor_token"]],
        )
        assert pose["timestamp"] == data["timestamp"]
        if not data["is_key_frame"]:
            continue
        modality = tables["sensor"][sensor["sensor_token"]]["modality"]
        if modality == "camera":
            (fx, _, cx), (_, fy, cy), _ = sensor["camera_intrinsic"]
            for box in boxes.get(data["sample_token"], []):
                x, y, z = into(sensor, into(pose, box["translation"]))
                if z > 0.5 and 0 <= fx * x / z + cx <= data["width"] and 0 <= fy * y / z + cy <= data["height"]:
                    seen.add(box["token"])
        else:
            with open(os.path.join(root, data["filename"]), "rb") as file:
                content = file.read()
            assert len(content) % 20 == 0
            sweeps += 1
            points = [out_of(pose, out_of(sensor, point[:3])) for point in struct.iter_unpack("<5f", content)]
            for box in boxes.get(data["sample_token"], []):
                width, length, height = box["size"]
                rows, radius = matrix(box["rotation"]), math.dist((0, 0, 0), box["size"]) / 2 + MARGIN_METRES
                inside = 0
                for point in points:
                    moved = [p - t for p, t in zip(point, box["translation"])]
                    if abs(moved[0]) > radius or abs(moved[1]) > radius:
                        continue
                    x, y, z = (sum(rows[i][j] * moved[i] for i in range(3)) for j in range(3))
                    inside += (
                        abs(x) <= length / 2 + MARGIN_METRES
                        and abs(y) <= width / 2 + MARGIN_METRES
                        and abs(z) <= height / 2 + MARGIN_METRES
                    )
                counted += box["num_lidar_hits"]
                within += min(inside, box["num_lidar_hits"])
                assert box["num_lidar_pts"] == points_in_box(box, points), box
    assert len(seen) > 0.5 * len(tables["sample_annotation"]), "few boxes are before the cameras"
    if sweeps:
        assert within >= LEAST_SHARE_IN_BOXES * counted > 0, f"{within} of {counted} points are in their boxes"
    return counted, within


def check_segments(root, tables):
    """Classes and instances of points, by the devkit's rules: each object has the points that its annotation counts as hits."""
    if not os.path.exists(os.path.join(root, VERSION, "lidarseg.json")):
        return 0
    names = {record["index"]: record["name"] for record in tables["category"].values()}
    labels, checked = {}, 0
    for table in ("lidarseg", "panoptic"):
        with open(os.path.join(root, VERSION, table + ".json"), encoding="utf-8") as file:
            records = json.load(file)
        assert len(records) == len(os.listdir(os.path.join(root, table, VERSION)))
        for record in records:
            data = tables["sample_data"][record["sample_data_token"]]
            assert record["token"] == record["sample_data_token"] and data["is_key_frame"]
            path = os.path.join(root, record["filename"])
            labels[table, data["token"]] = (
                np.fromfile(path, np.uint8) if table == "lidarseg" else np.load(path)["data"].astype(int)
            )
    samples = {}
    for (table, token), numbers in labels.items():
        assert len(numbers) == os.path.getsize(os.path.join(root, tables["sample_data"][token]["filename"])) // 20
        if table == "panoptic":
            classes = labels["lidarseg", token]
            assert np.array_equal(numbers // 1000, classes) and set(classes.tolist()) <= set(names)
            things = np.array(["vehicle" in names[each] or "human" in names[each] for each in classes.tolist()], bool)
            assert np.array_equal(numbers % 1000 > 0, things)
            found = samples.setdefault(tables["sample_data"][token]["sample_token"], {})
            for number, count in zip(*np.unique(numbers[things], return_counts=True)):
                found[number] = found.get(number, 0) + count
    for annotation in tables["sample_annotation"].values():
        category = tables["category"][tables["instance"][annotation["instance_token"]]["category_token"]]
        counts = [
            count
            for number, count in samples.get(annotation["sample_token"], {}).items()
            if number // 1000 == category["index"]
        ]
        assert not annotation["num_lidar_hits"] or annotation["num_lidar_hits"] in counts, annotation
        checked += 1 if annotation["num_lidar_hits"] else 0
    return checked


def points_in_box(box, points):
    """The number of points inside a box by the definition of the devkit: along each edge from one corner, between its ends."""
    width, length, height = box["size"]
    corner, *ends = [
        out_of(box, (x * length / 2, y * width / 2, z * height / 2))
        for x, y, z in ((1, 1, 1), (-1, 1, 1), (1, -1, 1), (1, 1, -1))
    ]
    edges = [[b - a for a, b in zip(corner, end)] for end in ends]
    squares = [sum(part * part for part in edge) for edge in edges]
    reach = math.dist((0, 0, 0), box["size"])
    count = 0
    for point in points:
        moved = [p - c for p, c in zip(point, corner)]
        if abs(moved[0]) <= reach and abs(moved[1]) <= reach:
            count += all(0 <= sum(e * m for e, m in zip(edge, moved)) <= square for edge, square in zip(edges, squares))
    return count


def labels_of(session):
    with open(os.path.join(session, "labels.jsonl"), encoding="utf-8") as file:
        return [json.loads(line) for line in file]


def offsets_of(root, tables):
    """What was added to x and y of the world, by scene."""
    with open(os.path.join(root, VERSION, "map_offset.json"), encoding="utf-8") as file:
        by_log = {record["log_token"]: record["offset"] for record in json.load(file)}
    assert set(by_log) == set(tables["log"])
    return {token: by_log[scene["log_token"]] for token, scene in tables["scene"].items()}


class Mask:
    """The mask of a scene, read as the devkit does: the origin is the lower left corner, and positions are rounded to pixels."""

    def __init__(self, root, tables, scene):
        log = tables["scene"][scene]["log_token"]
        (record,) = (each for each in tables["map"].values() if log in each["log_tokens"])
        Image.MAX_IMAGE_PIXELS = None
        image = Image.open(os.path.join(root, record["filename"]))
        assert image.mode == "L"
        self.pixels = np.array(image)
        assert set(np.unique(self.pixels)) <= {0, 255}

    def has(self, places):
        """Whether positions on the ground are drivable; each must be on the map."""
        columns, rows = np.round(np.array(places)[:, :2].T * PIXELS_PER_METRE).astype(int)
        rows = len(self.pixels) - rows
        assert (
            min(columns) >= 0
            and min(rows) >= 0
            and max(columns) < self.pixels.shape[1]
            and max(rows) < self.pixels.shape[0]
        )
        return self.pixels[rows, columns] == 255

    def has_near(self, places):
        """Whether there is drivable ground beside positions, as far as a parking strip is wide."""
        beside = [
            self.has(places[:, :2] + metres * np.array(side)) for side in AROUND for metres in range(PARKING_METRES + 1)
        ]
        return np.any(beside, axis=0)


def check_maps(root, tables, session):
    """Every pose of the vehicle and every annotation lies on the map, every pose on drivable ground; so do points of roads, not others."""
    offsets, masks = offsets_of(root, tables), {}
    poses, boxes, on_roads, near_roads, others = {}, {}, [], [], []
    sweeps = {}
    for label in labels_of(session) if session else []:
        for sweep in label.get("lidar", []):
            sweeps[round(label["timeSeconds"] * 1e6), sweep["sensor"]] = sweep["file"]
    for annotation in tables["sample_annotation"].values():
        boxes.setdefault(tables["sample"][annotation["sample_token"]]["scene_token"], []).append(
            annotation["translation"]
        )
    for data in tables["sample_data"].values():
        scene = tables["sample"][data["sample_token"]]["scene_token"]
        pose, sensor = (
            tables["ego_pose"][data["ego_pose_token"]],
            tables["calibrated_sensor"][data["calibrated_sensor_token"]],
        )
        poses.setdefault(scene, []).append(pose["translation"])
        if scene not in masks:
            masks[scene] = Mask(root, tables, scene)
        mask = masks[scene]
        file = sweeps.get((data["timestamp"] - START, tables["sensor"][sensor["sensor_token"]]["channel"]))
        if file:
            points = np.fromfile(os.path.join(session, file), POINT)
            places = points["place"].astype(float) @ np.array(matrix(sensor["rotation"])).T + sensor["translation"]
            places = places @ np.array(matrix(pose["rotation"])).T + pose["translation"]
            road = places[np.isin(points["class"], ROAD_CLASSES)]
            on_roads.extend(mask.has(road))
            near_roads.extend(mask.has_near(road))
            others.extend(mask.has(places[np.isin(points["class"], OTHER_CLASSES)]))
    for scene, mask in masks.items():
        assert all(isinstance(metres, int) for metres in offsets[scene])
        assert mask.has(
            poses[scene]
        ).all(), f"{tables['scene'][scene]['name']}: a pose of the vehicle is not on drivable ground"
        if scene in boxes:
            mask.has(boxes[scene])
    if not others:
        return ""
    on_road, near_road, other = (float(np.mean(found)) for found in (on_roads, near_roads, others))
    shares = f"{on_road:.1%} of the points of roads, {near_road:.1%} with parking strips, {other:.2%} of other ground and walls"
    assert (
        on_road >= LEAST_SHARE_ON_ROADS and near_road >= LEAST_SHARE_NEAR_ROADS and other <= MOST_OTHERS_ON_ROADS
    ), shares
    return ", " + shares


def check_session(root, tables, session):
    """Cuboids project into each camera as in the session, each has exactly the points of its id, and samples and sweeps are moments."""
    frames, corners = {}, [(x, y, z) for x in (-1, 1) for y in (-1, 1) for z in (-1, 1)]
    for label in labels_of(session):
        frames[round(label["timeSeconds"] * 1e6), label["view"]] = label
    boxes, projected, counted = {}, 0, 0
    offsets = offsets_of(root, tables)
    for annotation in tables["sample_annotation"].values():
        x, y = offsets[tables["sample"][annotation["sample_token"]]["scene_token"]]
        place = annotation["translation"]
        place = round(place[0] - x, 4), round(place[1] - y, 4), place[2]
        boxes.setdefault(annotation["sample_token"], {})[place] = annotation
    for data in tables["sample_data"].values():
        sensor = tables["calibrated_sensor"][data["calibrated_sensor_token"]]
        pose, channel = tables["ego_pose"][data["ego_pose_token"]], tables["sensor"][sensor["sensor_token"]]["channel"]
        if not data["is_key_frame"]:
            continue
        if tables["sensor"][sensor["sensor_token"]]["modality"] == "lidar":
            label = next(
                label for (time, _), label in frames.items() if time == data["timestamp"] - START and "lidar" in label
            )
            with open(
                os.path.join(session, next(each["file"] for each in label["lidar"] if each["sensor"] == channel)), "rb"
            ) as file:
                ids = [point[6] for point in struct.iter_unpack("<4f3H2B", file.read())]
            views = [frame for (time, _), frame in frames.items() if time == data["timestamp"] - START]
            objects = {}
            for item in (item for frame in views for item in joined(frame)):
                if item["id"] not in objects or len(item["members"]) > len(objects[item["id"]]["members"]):
                    objects[item["id"]] = item
            for place, box in boxes.get(data["sample_token"], {}).items():
                item = min(objects.values(), key=lambda item: math.dist(item["box3d"]["centre"], place))
                assert math.dist(item["box3d"]["centre"], place) < 0.001, box
                assert box["num_lidar_hits"] == sum(ids.count(number) for number in item["members"]), box
                counted += box["num_lidar_hits"]
            continue
        label = frames[data["timestamp"] - START, channel]
        (fx, _, cx), (_, fy, cy), _ = sensor["camera_intrinsic"]
        for item in label["objects"]:
            box = boxes.get(data["sample_token"], {}).get(tuple(item["box3d"]["centre"]))
            if box is None:
                continue
            width, length, height = box["size"]
            seen = [
                into(sensor, into(pose, out_of(box, (x * length / 2, y * width / 2, z * height / 2))))
                for x, y, z in corners
            ]
            if min(z for _, _, z in seen) < 0.5:
                continue
            sides = [fx * x / z + cx for x, _, z in seen], [fy * y / z + cy for _, y, z in seen]
            expected = item["box2dAmodal"]
            assert all(
                abs(a - b) < 1 for a, b in zip((min(sides[0]), min(sides[1]), max(sides[0]), max(sides[1])), expected)
            ), item["id"]
            projected += 1
    assert projected > 0 and counted > 0
    return projected


def check_can_bus(root, tables):
    """Messages are in order; poses follow each other as their velocities say, and those of samples are their ego poses."""
    poses = {
        (data["timestamp"], tuple(tables["ego_pose"][data["ego_pose_token"]]["translation"]))
        for data in tables["sample_data"].values()
    }
    times, messages, steps = {time for time, _ in poses}, 0, []
    for scene in tables["scene"].values():
        kinds = {}
        for kind in (
            "ms_imu",
            "pose",
            "steeranglefeedback",
            "vehicle_monitor",
            "zoe_veh_info",
            "zoesensors",
            "meta",
            "route",
        ):
            with open(os.path.join(root, "can_bus", f"{scene['name']}_{kind}.json"), encoding="utf-8") as file:
                kinds[kind] = json.load(file)
        meta = kinds.pop("meta")
        for place, after in zip(kinds["route"], kinds.pop("route")[1:]):
            assert math.dist(place, after) < 5
        for kind, rows in kinds.items():
            assert [row["utime"] for row in rows] == sorted({row["utime"] for row in rows}) and meta[kind][
                "message_count"
            ] == len(rows)
            messages += len(rows)
        for before, after in zip(kinds["pose"], kinds["pose"][1:]):
            seconds = (after["utime"] - before["utime"]) / 1e6
            if seconds > 0.05:
                continue
            frame = {"translation": before["pos"], "rotation": before["orientation"]}
            moved = into(frame, after["pos"])
            steps.append(math.dist(moved, [seconds * speed for speed in before["vel"]]) < 0.02)
        for row in kinds["pose"]:
            if row["utime"] in times:
                assert any(time == row["utime"] and math.dist(place, row["pos"]) < 1e-3 for time, place in poses)

    # A car that runs into another one stands at once, with the velocity of the tick before.
    assert (
        steps.count(False) <= len(steps) / 100
    ), f"{steps.count(False)} of {len(steps)} steps are not those of the velocity"
    return messages


def read(root, session=None):
    tables = load(root)
    check_links(tables)
    check_chains(tables)
    counted, within = check_geometry(root, tables)
    with open(os.path.join(root, VERSION, "splits.json"), encoding="utf-8") as file:
        named = [name for scenes in json.load(file).values() for name in scenes]
    assert sorted(named) == sorted(scene["name"] for scene in tables["scene"].values())
    shares = check_maps(root, tables, session)
    segments = check_segments(root, tables)
    return (
        f"nuscenes: {len(tables['scene'])} scenes, {len(tables['sample'])} samples, {len(tables['sample_annotation'])} annotations, "
        f"{within} of {counted} points in their boxes, {segments} objects with classes of points, "
        f"{check_can_bus(root, tables)} CAN bus messages, "
        f"on drivable ground are all {len(tables['ego_pose'])} poses{shares}"
        + (f", {check_session(root, tables, session)} projections as in the session" if session else "")
    )


if __name__ == "__main__":
    import sys

    print(read(*sys.argv[1:]))
