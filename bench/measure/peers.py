"""OpenCV, NumPy and Pillow on the pictures, the mask and as many points as the project's own figures are of."""

import io
import os
import time

import cv2
import numpy
import PIL.Image

POINTS = 100_000
WARMING_RUNS = 2
MIN_RUNS = 8
MEASURING_SECONDS = 0.7


def best_seconds(work):
    times = []
    for _ in range(WARMING_RUNS):
        work()
    begin = time.perf_counter()
    while len(times) < MIN_RUNS or time.perf_counter() - begin < MEASURING_SECONDS:
        start = time.perf_counter()
        work()
        times.append(time.perf_counter() - start)
    return min(times)


def figures(folder):
    cv2.setNumThreads(1)
    random = numpy.random.default_rng(1)
    points = random.uniform([-10, -5, 5], [10, 5, 100], (POINTS, 3))
    matrix = numpy.array([[640.0, 0, 400], [0, 640, 300], [0, 0, 1]])
    turn = cv2.Rodrigues(numpy.zeros(3))[0]

    def by_numpy():
        local = points @ turn.T
        return local[:, :2] / local[:, 2:] * [640, 640] + [400, 300]

    frame = cv2.imread(os.path.join(folder, "frame.png"), cv2.IMREAD_UNCHANGED)
    mask = cv2.imread(os.path.join(folder, "mask.png"), cv2.IMREAD_UNCHANGED)
    level1 = [cv2.IMWRITE_PNG_COMPRESSION, 1]
    quality = [cv2.IMWRITE_JPEG_QUALITY, 95]
    found = {
        "opencv.points": POINTS
        / best_seconds(lambda: cv2.projectPoints(points, numpy.zeros(3), numpy.zeros(3), matrix, None)),
        "numpy.points": POINTS / best_seconds(by_numpy),
    }
    for name, picture, extension, options in [
        ("png", frame, ".png", level1),
        ("mask", mask, ".png", level1),
        ("jpeg", frame, ".jpg", quality),
    ]:
        found[f"opencv.{name}"] = 1000 * best_seconds(lambda: cv2.imencode(extension, picture, options))
        found[f"opencv.{name}.bytes"] = len(cv2.imencode(extension, picture, options)[1])
    # OpenCV 4.6 stores colours at half the resolution and cannot do otherwise; the project's JPEG does not, and Pillow can do both.
    picture = PIL.Image.open(os.path.join(folder, "frame.png")).convert("RGB")
    found["pillow.jpeg"] = 1000 * best_seconds(lambda: pillow_jpeg(picture))
    found["pillow.jpeg.bytes"] = len(pillow_jpeg(picture))
    return found


def pillow_jpeg(picture):
    file = io.BytesIO()
    picture.save(file, "JPEG", quality=95, subsampling=0)
    return file.getvalue()
