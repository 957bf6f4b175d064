"""Occ3D exports against the maps, depth maps, points and boxes of their session, read with NumPy."""

import glob
import json
import os

import cv2
import numpy as np

import mcap

CELLS, LAYERS, METRES, LOWEST = 200, 16, 0.4, -1.0
FREE = 17

# Class of a class map to that of Occ3D; riders (21) are compared separately.
CLASSES = {
    0: FREE, 255: FREE, 1: 11, 3: 11, 8: 12, 2: 13, 6: 14, 4: 15, 9: 15, 10: 15, 18: 15, 19: 15, 5: 16,
    11: 4, 12: 10, 13: 3, 14: 6, 15: 2, 16: 9, 17: 7, 7: 0, 20: 0,
}  # fmt: skip
RIDER = 21

# A file of points has 24 bytes a point; the first three numbers are right, forward and up.
POINT = np.dtype("<f4,<f4,<f4,<f4,<u2,<u2,<u2,u1,u1")

# A point this close to the side of a voxel, metres, may lie in the next one: points have float32 coordinates, and poses six decimals.
SIDE = 1e-4

# Depth maps count 1/256 m, and round.
DEPTH_STEP = 1 / 256

# Completed depth maps are estimated between the rays, and the voxels are judged by the surface at the middle of a pixel; where an edge or a
# slanted surface crosses the pixel, both differ.
MIN_BY_DEPTH = 0.97

# Beams are sampled this far apart, metres; voxels that a beam crosses on a shorter way are missed.
STEP = 0.02


def matrix(pose):
    """The rotation of a quaternion, w first."""
    w, x, y, z = pose["rotation"]
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def voxels_of(session, name):
    """A map of voxels as an array along x ahead, y to the left and z up: its rows go backwards and its columns to the right."""
    layers = cv2.imread(os.path.join(session, name), cv2.IMREAD_UNCHANGED).reshape(LAYERS, CELLS, CELLS)
    return layers[:, ::-1, ::-1].transpose(1, 2, 0)


def middles():
    along = (np.arange(CELLS) + 0.5) * METRES - CELLS * METRES / 2
    return np.stack(np.meshgrid(along, along, (np.arange(LAYERS) + 0.5) * METRES + LOWEST, indexing="ij"), -1)


def places(points):
    """Points of the ego's frame as places among the voxels."""
    return (points - [-CELLS * METRES / 2, -CELLS * METRES / 2, LOWEST]) / METRES


def inside(cells):
    return (cells >= 0).all(1) & (cells < [CELLS, CELLS, LAYERS]).all(1)


def check_classes(session, label, arrays):
    known = voxels_of(session, label["occupancy"]["file"])
    expected = np.vectorize(lambda value: CLASSES.get(value, 0), otypes=[np.uint8])(known)
    riders = known == RIDER
    assert np.array_equal(arrays["semantics"][~riders], expected[~riders])
    assert np.isin(arrays["semantics"][riders], [0, 2, 6]).all()
    assert not arrays["mask_camera"][known == 255].any()


def check_points(session, rig, label, arrays):
    """Every point lies in an occupied voxel, and the voxels on the way of the beams are those of the mask."""
    wrong = total = 0
    passed = np.zeros((CELLS, CELLS, LAYERS), bool)
    for lidar, sweep in zip(rig["lidars"], label["lidar"]):
        packed = np.fromfile(os.path.join(session, sweep["file"]), POINT)
        local = np.stack([packed["f1"], -packed["f0"], packed["f2"]], 1).astype(float)
        right, ahead, up = lidar["position"]

        # The LiDARs of these rigs are level, and measured from the rig's origin, which is that of the ego.
        assert np.allclose(label["occupancy"]["origin"], rig["origin"])
        sensor = np.array([ahead, -right, up])
        ends = places(local + sensor)
        cells = np.floor(ends).astype(int)
        cast = (packed["f8"] & 1) == 0
        clear = (np.abs(ends - np.round(ends)) > SIDE / METRES).all(1)
        of = inside(cells) & cast & clear
        total += of.sum()
        wrong += (arrays["semantics"][tuple(cells[of].T)] == FREE).sum()
        near = inside(cells) & clear
        assert arrays["mask_lidar"][tuple(cells[near].T)].all()
        for part in np.array_split(local, max(1, len(local) // 500)):
            lengths = np.linalg.norm(part, axis=1)
            counts = np.minimum(np.ceil(lengths / STEP), 70 / STEP).astype(int)
            which = np.repeat(np.arange(len(part)), counts)
            along = (np.arange(len(which)) - np.repeat(np.cumsum(counts) - counts, counts)) * STEP
            at = places(sensor + part[which] / lengths[which, None] * along[:, None])
            on = np.floor(at).astype(int)
            keep = inside(on) & (np.abs(at - np.round(at)) > SIDE / METRES).all(1)
            passed[tuple(on[keep].T)] = True
    assert wrong == 0 and total > 0, (wrong, total)
    mask = arrays["mask_lidar"].astype(bool)
    assert mask[passed].all()
    return total, passed.sum(), (mask & ~passed).sum()


def check_cameras(session, labels, moment, arrays):
    """Each voxel of the mask is in an image, and each free one before what the depth map of one has; returns how many agree."""
    centres = middles()
    seen = arrays["mask_camera"].astype(bool)
    free = arrays["semantics"] == FREE
    shown = np.zeros(seen.shape, bool)
    for label, camera in zip(labels, moment["camera_sensor"].values()):
        assert camera["ego_pose"] == moment["ego_pose"]
        local = (centres - camera["extrinsic"]["translation"]) @ matrix(camera["extrinsic"])
        lens = np.array(camera["intrinsic"])
        with np.errstate(divide="ignore", invalid="ignore"):
            pixel = (local @ lens.T)[..., :2] / local[..., 2:]
        size = [label["camera"]["width"], label["camera"]["height"]]
        ahead = (local[..., 2] > 0.2) & (pixel >= 0).all(-1) & (pixel < size).all(-1)
        depth = cv2.imread(os.path.join(session, label["depth"]["completed"]), cv2.IMREAD_UNCHANGED) * DEPTH_STEP
        depth[depth == 0] = np.inf
        column, row = np.floor(pixel[ahead]).astype(int).T
        shown[ahead] |= local[ahead][:, 2] <= depth[row, column] + DEPTH_STEP
    agree = (shown == seen)[free & (seen | shown)]
    assert agree.mean() > MIN_BY_DEPTH, agree.mean()
    return agree.sum(), len(agree)


def check_message(label, arrays, session, message):
    """The message of Foxglove has the same voxels: along z, then y, then x."""
    cell = np.dtype({
        "names": ["red", "green", "blue", "alpha", "class", "visible", "object"],
        "formats": ["u1"] * 6 + ["<u2"], "offsets": [0, 1, 2, 3, 4, 5, 6], "itemsize": 8,
    })  # fmt: skip
    assert [(field.name, field.offset, field.type) for field in message.fields] == [
        (name, cell.fields[name][1], 3 if name == "object" else 1) for name in cell.names
    ]
    strides = (message.slice_stride, message.row_stride, message.cell_stride)
    assert strides == (CELLS * CELLS * 8, CELLS * 8, 8) and (message.row_count, message.column_count) == (CELLS, CELLS)
    grid = np.frombuffer(message.data, cell).reshape(LAYERS, CELLS, CELLS).transpose(2, 1, 0)
    right, ahead, up = label["occupancy"]["origin"]
    corner = [getattr(message.pose.position, axis) for axis in "xyz"]
    assert np.allclose(corner, [ahead - 40, -right - 40, up - 1]) and message.pose.orientation.w == 1
    assert message.frame_id == "ego" and np.isclose(message.cell_size.x, METRES)
    assert np.array_equal(grid["class"], voxels_of(session, label["occupancy"]["file"]))
    assert np.array_equal(grid["object"], voxels_of(session, label["occupancy"]["instances"]))
    assert np.array_equal(grid["visible"] // 255, arrays["mask_camera"])
    assert np.array_equal(grid["alpha"] > 0, (grid["class"] > 0) & (grid["class"] < 255))
    # The colour of roads, as of class maps.
    assert (np.stack([grid[name][grid["class"] == 1] for name in ("red", "green", "blue")], 1) == [128, 64, 128]).all()


def read(session, folder, recordings):
    with open(os.path.join(session, "labels.jsonl"), encoding="utf-8") as lines:
        labels = [json.loads(line) for line in lines]
    with open(os.path.join(session, "session.json"), encoding="utf-8") as file:
        rig = json.load(file)["rig"]
    with open(os.path.join(folder, "annotations.json"), encoding="utf-8") as file:
        annotations = json.load(file)
    scenes = annotations["scene_infos"]
    assert annotations["train_split"] == list(scenes)
    grids = [
        item
        for path in sorted(glob.glob(os.path.join(recordings, "train", "*.mcap")))
        for _, item in mcap.read(path)["/occupancy"]
    ]
    moments = {}
    for label in labels:
        moments.setdefault((label["place"], label["moment"]), []).append(label)
    written = [(name, token, moment) for name, scene in scenes.items() for token, moment in scene.items()]
    assert len(written) == len(moments) == len(grids)
    points = passed = missed = agree = looked = 0
    for (name, token, moment), views, grid in zip(written, moments.values(), grids):
        assert moment["gt_path"] == f"gts/{name}/{token}/labels.npz"
        arrays = np.load(os.path.join(folder, moment["gt_path"]))
        assert sorted(arrays) == ["mask_camera", "mask_lidar", "semantics"]
        assert all(arrays[name].shape == (CELLS, CELLS, LAYERS) and arrays[name].dtype == np.uint8 for name in arrays)
        arrays = {name: arrays[name] for name in arrays}
        for label, camera in zip(views, moment["camera_sensor"].values()):
            with open(os.path.join(session, label["image"]), "rb") as one:
                with open(os.path.join(folder, camera["img_path"]), "rb") as other:
                    assert one.read() == other.read()
        check_classes(session, views[0], arrays)
        masks = [voxels_of(session, label["occupancy"]["visible"]) for label in views]
        assert np.array_equal(arrays["mask_camera"], np.any(masks, axis=0))
        counts = check_points(session, rig, views[0], arrays)
        points, passed, missed = points + counts[0], passed + counts[1], missed + counts[2]
        same, of = check_cameras(session, views, moment, arrays)
        agree, looked = agree + same, looked + of
        check_message(views[0], arrays, session, grid)
    # Beams that cross a voxel near an edge or corner are not sampled there.
    assert missed < 0.05 * passed, (missed, passed)
    return (
        f"occ3d: {len(written)} moments as in the session; {points} points, none in a free voxel; {passed} voxels on the way of beams, and "
        f"{missed} that sampling misses; {agree} of {looked} free voxels are seen as the depth maps say"
    )
