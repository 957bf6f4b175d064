"""Reads CULane's lists, points and maps, and evaluates lanes as CULane does: by the overlap of lines drawn 30 pixels wide."""

import os

import cv2
import numpy as np

from assignment import greatest

WIDTH_PIXELS = 30
MATCH = 0.5
# OpenCV draws at 1/16 of a pixel.
SHIFT = 4


def spline(points):
    """Points on natural cubic splines through the points of a lane, by its length; two points give a straight line."""
    if len(points) < 3:
        return points
    steps = np.concatenate([[0], np.cumsum(np.linalg.norm(np.diff(points, axis=0), axis=1))])
    gaps = np.diff(steps)
    matrix = np.eye(len(points))
    right = np.zeros_like(points)
    for i in range(1, len(points) - 1):
        matrix[i, i - 1 : i + 2] = gaps[i - 1], 2 * (gaps[i - 1] + gaps[i]), gaps[i]
        right[i] = 6 * ((points[i + 1] - points[i]) / gaps[i] - (points[i] - points[i - 1]) / gaps[i - 1])
    bend = np.linalg.solve(matrix, right)
    curve = []
    for i, gap in enumerate(gaps):
        for along in np.linspace(0, gap, 50):
            back = gap - along
            curve.append(
                (bend[i] * back**3 + bend[i + 1] * along**3) / (6 * gap)
                + (points[i] / gap - bend[i] * gap / 6) * back
                + (points[i + 1] / gap - bend[i + 1] * gap / 6) * along
            )
    return np.array(curve)


def drawn(points, size, width):
    canvas = np.zeros((size[1], size[0]), np.uint8)
    corners = np.round(spline(points) * (1 << SHIFT)).astype(np.int32)
    return cv2.polylines(canvas, [corners[:, None]], False, 1, width, shift=SHIFT).astype(bool)


def counts(truth, found, size):
    """Lanes that were found, that were not, and that are not there."""
    true = [drawn(points, size, WIDTH_PIXELS) for points in truth]
    seen = [drawn(points, size, WIDTH_PIXELS) for points in found]
    scores = [[(a & b).sum() / (a | b).sum() for b in seen] for a in true]
    hits = sum(scores[row][column] > MATCH for row, column in greatest(scores)) if true and seen else 0
    return hits, len(true) - hits, len(seen) - hits


def f1(frames):
    hits, missed, false = np.sum([counts(*frame) for frame in frames], axis=0)
    return 2 * hits / (2 * hits + missed + false)


def lanes_of(root, image):
    path = os.path.join(root, os.path.splitext(image.lstrip("/"))[0] + ".lines.txt")
    with open(path, encoding="utf-8") as file:
        return [np.array(line.split(), float).reshape(-1, 2) for line in file]


def distance(point, lines):
    """From a point to polylines."""
    best = np.inf
    for line in lines:
        start, end = line[:-1], line[1:]
        along = end - start
        share = np.clip(((point - start) * along).sum(1) / np.maximum((along**2).sum(1), 1e-12), 0, 1)
        best = min(best, np.linalg.norm(start + along * share[:, None] - point, axis=1).min())
    return best


def read(root, labels):
    with open(os.path.join(root, "list", "train_gt.txt"), encoding="utf-8") as file:
        rows = [line.split() for line in file]
    known = [label for label in labels if label["lanes"]["status"] == "known"]
    assert len(rows) == len(known) > 0
    frames = []
    for (image, shown, *flags), label in zip(rows, known):
        size = label["camera"]["width"], label["camera"]["height"]
        assert cv2.imread(root + image).shape[1::-1] == size
        lanes = lanes_of(root, image)
        assert len(lanes) == flags.count("1") > 0
        lines = [np.array(line["pixels"]) for line in label["lanes"].get("markings") or label["lanes"]["boundaries"]]
        for points in lanes:
            assert (np.diff(points[:, 1]) < 0).all()
            assert max(distance(point + 0.5, lines) for point in points) < 0.01
        map_of = cv2.imread(root + shown, cv2.IMREAD_UNCHANGED)
        places = [place for place, flag in enumerate(flags, 1) if flag == "1"]
        assert set(np.unique(map_of)) <= {0, *places}
        whole = np.zeros(map_of.shape, bool)
        for points in lanes:
            corners = np.round(points * (1 << SHIFT)).astype(np.int32)[:, None]
            whole |= cv2.polylines(np.zeros(map_of.shape, np.uint8), [corners], False, 1, 16, shift=SHIFT).astype(bool)
        # The rims of lines of odd and of even width differ by a pixel.
        assert (whole & (map_of > 0)).sum() / (whole | (map_of > 0)).sum() > 0.9
        frames.append((lanes, lanes, size))
    assert f1(frames) == 1.0
    assert f1([(truth, [points + [60, 0] for points in found], size) for truth, found, size in frames]) < 1
