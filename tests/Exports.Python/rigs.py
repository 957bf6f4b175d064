"""Reads KITTI object detection and odometry, SemanticKITTI, PCD and PLY exports of a rig by their definitions, and compares them with the
session."""

import csv
import json
import os
import re

import numpy as np

FORMATS = ("kitti", "kitti-odometry", "pcd", "ply")
POINT = np.dtype(
    [
        ("position", "<f4", 3),
        ("intensity", "<f4"),
        ("column", "<u2"),
        ("beam", "<u2"),
        ("id", "<u2"),
        ("class", "u1"),
        ("flags", "u1"),
    ]
)
# From the class of a point, by its number in the session, to SemanticKITTI's.
SEMANTIC_KITTI = [0, 40, 48, 60, 50, 70, 72, 0, 49, 80, 51, 10, 18, 13, 15, 11, 20, 30, 81, 99, 99, 30]
# And of those that move: a car, a truck, a bus, a trailer, a person, a motorcyclist, a bicyclist.
MOVING = {10: 252, 18: 258, 13: 257, 20: 259, 30: 254, 32: 255, 31: 253}
# A motorcycle or bicycle together with its rider.
RIDDEN = {15: 32, 11: 31}
RIDER = 21
SEMANTIC_CLASSES = {"motorcycle": 14, "bicycle": 15}
MOVING_SPEED = 0.2
PCD_TYPES = {("F", 4): "<f4", ("U", 1): "u1", ("U", 2): "<u2", ("U", 4): "<u4"}
PLY_TYPES = {"float": "<f4", "ushort": "<u2", "uchar": "u1"}
# Velocities and positions have four decimals.
METRES = 2e-4
PIXELS = 0.1
EARTH_RADIUS = 6378137.0


def matrices(path):
    found = {}
    with open(path, encoding="utf-8") as file:
        for line in file:
            name, *values = line.split()
            values = np.array([float(value) for value in values])
            found[name.rstrip(":")] = values.reshape(3, -1)
    return found


def homogeneous(matrix):
    return np.vstack([matrix if matrix.shape[1] == 4 else np.hstack([matrix, np.zeros((3, 1))]), [0, 0, 0, 1]])


def body(ego):
    """From forward, left, up of the vehicle to the world."""
    return np.column_stack([ego["forward"], -np.array(ego["right"]), ego["up"]])


def sensor_pose(rig, mount, ego):
    """From x right, y forward, z up of a sensor that is mounted without rotation to the world."""
    place = np.array(rig["origin"]) + mount["position"]
    axes = np.column_stack([ego["right"], ego["forward"], ego["up"]])
    return axes, np.array(ego["position"]) + axes @ place


def velodyne(path):
    return np.fromfile(path, "<f4").reshape(-1, 4)


def check_scan(path, points):
    scan = velodyne(path)
    assert len(scan) == len(points) > 0
    right, forward, up = points["position"].T
    assert np.array_equal(scan[:, :3], np.column_stack([forward, -right, up])) and np.array_equal(
        scan[:, 3], points["intensity"]
    )
    return scan


def check_oxts(path, label):
    """The pose that pykitti's formulas give is that of the ego, for the equator as the first latitude."""
    with open(path, encoding="utf-8") as file:
        (line,) = file.read().splitlines()
    words = line.split()
    assert len(words) == 30 and all(re.fullmatch(r"-?\d+", word) for word in words[25:])
    lat, lon, alt, roll, pitch, yaw, north, east, ahead, left, up = (float(word) for word in words[:11])
    place = [lon * np.pi * EARTH_RADIUS / 180, EARTH_RADIUS * np.log(np.tan((90 + lat) * np.pi / 360)), alt]
    assert np.allclose(place, label["ego"]["position"], atol=METRES)
    (sr, sp, sy), (cr, cp, cy) = (np.sin([roll, pitch, yaw]), np.cos([roll, pitch, yaw]))
    turn = (
        np.array([[cy, -sy, 0], [sy, cy, 0], [0, 0, 1]])
        @ np.array([[cp, 0, sp], [0, 1, 0], [-sp, 0, cp]])
        @ np.array([[1, 0, 0], [0, cr, -sr], [0, sr, cr]])
    )
    assert np.allclose(turn, body(label["ego"]), atol=1e-6)
    assert np.allclose([east, north], label["ego"]["velocity"][:2], atol=METRES)
    assert (
        abs(np.hypot(ahead, left) - np.hypot(east, north)) < METRES and abs(up - label["ego"]["velocity"][2]) < METRES
    )
    felt = np.array([float(word) for word in words[11:14]])
    assert abs(felt[2] - 9.81) < 5
    assert abs(float(words[19]) - label["ego"]["yawRate"]) < 0.1


def check_kitti(root, session, moments):
    """Scans, cuboids and both cameras of a pair agree: a point of the world has the pixels in each image that its camera gives."""
    info = json.load(open(os.path.join(session, "session.json"), encoding="utf-8"))
    compared = 0
    for number, views in enumerate(moments):
        name = f"{views['image_02']['frame']:06d}"
        calibration = matrices(os.path.join(root, "training", "calib", name + ".txt"))
        for slot in range(4):
            assert os.path.getsize(os.path.join(root, "training", f"image_{slot}", name + ".png")) > 0
        points = np.fromfile(os.path.join(session, views["image_00"]["lidar"][0]["file"]), POINT)
        scan = check_scan(os.path.join(root, "training", "velodyne", name + ".bin"), points)
        check_oxts(os.path.join(root, "training", "oxts", name + ".txt"), views["image_00"])
        axes, place = sensor_pose(info["rig"], info["rig"]["lidars"][0], views["image_00"]["ego"])
        world = points["position"].astype(float) @ axes.T + place

        # Camera 0 is KITTI's reference: readers take the scanner's place for that in its frame.
        assert not calibration["P0"][:, 3].any()
        reference = (
            homogeneous(calibration["R0_rect"])
            @ homogeneous(calibration["Tr_velo_to_cam"])
            @ np.column_stack([scan[:, :3], np.ones(len(scan))]).T
        )
        for slot in range(4):
            camera = views[f"image_0{slot}"]["camera"]
            seen = calibration[f"P{slot}"] @ reference
            away = world - camera["position"]
            depth = away @ camera["forward"]
            ahead = depth > 2
            ahead[ahead] = np.abs((away @ camera["right"])[ahead] / depth[ahead]) < camera["width"] / camera["fx"]
            assert ahead.any()
            columns = camera["cx"] + camera["fx"] * (away @ camera["right"])[ahead] / depth[ahead]
            rows = camera["cy"] - camera["fy"] * (away @ camera["up"])[ahead] / depth[ahead]

            # KITTI counts pixels from the centre of the first one.
            assert np.abs(seen[0][ahead] / seen[2][ahead] + 0.5 - columns).max() < PIXELS
            assert np.abs(seen[1][ahead] / seen[2][ahead] + 0.5 - rows).max() < PIXELS
            compared += ahead.sum()

        # The inertial unit is at the origin of the vehicle's model.
        inertial = homogeneous(calibration["Tr_imu_to_velo"])
        ego = views["image_00"]["ego"]
        at = np.column_stack([(world[:50] - ego["position"]) @ body(ego), np.ones(50)])
        assert np.allclose((inertial @ at.T)[:3].T, scan[:50, :3], atol=1e-3)
    return compared


def check_point(value, instance, kind, number, objects):
    """Class and id of a point. Objects that no image shows may be among the points: what they ride and their speed is in the scene only."""
    item = objects.get(number)
    vehicle = objects.get(item["vehicle"]) if item is not None and kind == RIDER else None
    if kind != RIDER:
        assert instance == number
    elif item is not None:
        assert instance == item["vehicle"]
    still = {SEMANTIC_KITTI[kind]}
    if kind == RIDER:
        still = (
            {RIDDEN[SEMANTIC_KITTI[SEMANTIC_CLASSES[vehicle["class"]]]]}
            if vehicle is not None
            else {30, *RIDDEN.values()}
        )
    elif SEMANTIC_KITTI[kind] in RIDDEN and item is None:
        still |= {RIDDEN[SEMANTIC_KITTI[kind]]}
    elif SEMANTIC_KITTI[kind] in RIDDEN and item["hasRider"]:
        still = {RIDDEN[SEMANTIC_KITTI[kind]]}
    moving = {MOVING.get(was, was) for was in still}
    expected = (
        still
        if number == 0
        else still | moving
        if item is None
        else moving
        if np.linalg.norm(item["velocity"]) > MOVING_SPEED
        else still
    )
    assert value in expected, (number, kind, value, expected)


def check_odometry(root, session, moments):
    """Scans that are moved by the poses stay where they are in the world, and labels are the classes and ids of the session."""
    sequences = sorted(os.listdir(os.path.join(root, "sequences")))
    assert len(sequences) == len({views["image_00"]["place"] for views in moments})
    labelled = moving = 0
    for place, sequence in enumerate(sequences):
        folder = os.path.join(root, "sequences", sequence)
        mine = [views for views in moments if views["image_00"]["place"] == place]
        times = np.loadtxt(os.path.join(folder, "times.txt"))
        poses = np.loadtxt(os.path.join(root, "poses", sequence + ".txt")).reshape(-1, 3, 4)
        assert len(times) == len(poses) == len(mine) and np.allclose(poses[0], np.eye(3, 4), atol=1e-9)
        assert np.allclose(np.diff(times), np.diff([views["image_00"]["timeSeconds"] for views in mine]), atol=2e-6)
        to_camera = homogeneous(matrices(os.path.join(folder, "calib.txt"))["Tr"])
        first = mine[0]["image_00"]["camera"]
        first_axes = np.column_stack([first["right"], -np.array(first["up"]), first["forward"]])
        for number, views in enumerate(mine):
            points = np.fromfile(os.path.join(session, views["image_00"]["lidar"][0]["file"]), POINT)
            scan = check_scan(os.path.join(folder, "velodyne", f"{number:06d}.bin"), points)
            labels = np.fromfile(os.path.join(folder, "labels", f"{number:06d}.label"), "<u4")
            objects = {item["id"]: item for view in views.values() for item in view["objects"]}
            for label, kind, number_of in zip(labels, points["class"], points["id"]):
                check_point(label & 0xFFFF, label >> 16, kind, number_of, objects)
            moving += int(np.isin(labels & 0xFFFF, list(MOVING.values())).sum())
            labelled += len(labels)
            check_oxts(os.path.join(folder, "oxts", "data", f"{number:010d}.txt"), views["image_00"])
            info = json.load(open(os.path.join(session, "session.json"), encoding="utf-8"))
            axes, origin = sensor_pose(info["rig"], info["rig"]["lidars"][0], views["image_00"]["ego"])
            world = points["position"].astype(float) @ axes.T + origin
            moved = homogeneous(poses[number]) @ to_camera @ np.column_stack([scan[:, :3], np.ones(len(scan))]).T
            assert np.abs(moved[:3].T @ first_axes.T + first["position"] - world).max() < 0.01
    assert moving > 0
    return labelled


def read_pcd(path):
    """A binary PCD file by the definition of version 0.7."""
    with open(path, "rb") as file:
        content = file.read()
    header, fields = {}, []
    while "DATA" not in header:
        line, content = content.split(b"\n", 1)
        if not line.startswith(b"#"):
            name, *values = line.decode("ascii").split()
            header[name] = values
            fields.append(name)
    assert fields == ["VERSION", "FIELDS", "SIZE", "TYPE", "COUNT", "WIDTH", "HEIGHT", "VIEWPOINT", "POINTS", "DATA"]
    assert header["DATA"] == ["binary"] and set(header["COUNT"]) == {"1"}
    points = int(header["POINTS"][0])
    assert points == int(header["WIDTH"][0]) * int(header["HEIGHT"][0])
    kind = np.dtype(
        [(name, PCD_TYPES[of, int(size)]) for name, of, size in zip(header["FIELDS"], header["TYPE"], header["SIZE"])]
    )
    assert len(content) == points * kind.itemsize
    return np.frombuffer(content, kind)


def read_ply(path):
    """A little-endian PLY file with one element, by its definition."""
    with open(path, "rb") as file:
        content = file.read()
    head, content = content.split(b"end_header\n", 1)
    lines = head.decode("ascii").splitlines()
    assert lines[:2] == ["ply", "format binary_little_endian 1.0"]
    name, points = lines[2].split()[1:]
    assert name == "vertex"
    kind = np.dtype([(line.split()[2], PLY_TYPES[line.split()[1]]) for line in lines[3:]])
    assert len(content) == int(points) * kind.itemsize
    return np.frombuffer(content, kind)


def check_clouds(root, session, moments, reader):
    with open(os.path.join(root, "clouds.csv"), encoding="utf-8", newline="") as file:
        rows = list(csv.DictReader(file))
    assert len(rows) == len(moments)
    total = 0
    for row, views in zip(rows, moments):
        label = views["image_00"]
        assert (
            int(row["session_frame"]) == label["frame"]
            and abs(float(row["time_seconds"]) - label["timeSeconds"]) < 1e-6
        )
        points = np.fromfile(os.path.join(session, label["lidar"][0]["file"]), POINT)
        cloud = reader(os.path.join(root, row["file"]))
        assert len(cloud) == len(points) == int(row["points"])
        right, forward, up = points["position"].T
        assert (
            np.array_equal(cloud["x"], forward)
            and np.array_equal(cloud["y"], -right)
            and np.array_equal(cloud["z"], up)
        )
        for name, field in (
            ("intensity", "intensity"),
            ("ring", "beam"),
            ("object", "id"),
            ("label", "class"),
            ("interpolated", "flags"),
        ):
            assert np.array_equal(cloud[name], points[field]), name
        total += len(cloud)
    return total


def read(session, kitti, odometry, pcd, ply):
    moments = {}
    with open(os.path.join(session, "labels.jsonl"), encoding="utf-8") as file:
        for label in map(json.loads, file):
            moments.setdefault(label["moment"], {})[label["view"]] = label
    moments = [moments[moment] for moment in sorted(moments)]
    return (
        f"rigs: {check_kitti(kitti, session, moments)} pixels of points in four cameras, "
        f"{check_odometry(odometry, session, moments)} labelled points of sequences, "
        f"{check_clouds(pcd, session, moments, read_pcd)} points in PCD and {check_clouds(ply, session, moments, read_ply)} in PLY files"
    )


if __name__ == "__main__":
    import sys

    print(read(*sys.argv[1:]))
