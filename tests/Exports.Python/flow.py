"""Reads exports of optical flow with torchvision's and OpenCV's readers, and judges the flow by the images alone."""

import os

import cv2
import numpy as np
from torchvision.datasets import KittiFlow

# Bilinear sampling, shading that changes with the view and traffic lights leave some difference; a flow of another frame leaves more.
MAX_SHARE_OF_UNMOVED = 0.6


def grey_of(image):
    return np.asarray(image.convert("L"), dtype=np.float32)


def difference(first, second, flow, seen):
    """The mean difference of grey between the first image and the second one where the flow leads, over the seen pixels."""
    height, width = first.shape
    columns, rows = np.meshgrid(np.arange(width, dtype=np.float32), np.arange(height, dtype=np.float32))
    led = cv2.remap(second, columns + flow[0], rows + flow[1], cv2.INTER_LINEAR)
    return float(np.abs(led - first)[seen].mean())


def read(kitti_root, kitti, middlebury):
    """Reads both exports of one session. The parent folder of the KITTI one is where torchvision looks for KittiFlow."""
    pairs = KittiFlow(kitti_root, split="train")
    names = sorted(name[: -len("_10.png")] for name in os.listdir(os.path.join(kitti, "training", "flow_occ")))
    assert len(pairs) == len(names) > 0
    moved, unmoved = [], []
    for name, (first, second, flow, valid) in zip(names, pairs):
        bgr = cv2.imread(os.path.join(kitti, "training", "flow_noc", name + "_10.png"), cv2.IMREAD_UNCHANGED)
        seen = bgr[..., 0] == 1
        assert seen.any() and not (seen & ~valid).any()
        floats = cv2.readOpticalFlow(os.path.join(middlebury, "other-gt-flow", name, "flow10.flo"))
        known = (np.abs(floats) < 1e9).all(axis=2)
        assert np.array_equal(known, valid)
        assert np.array_equal(floats.transpose(2, 0, 1)[:, valid], flow[:, valid])
        for frame, image in (("frame10", first), ("frame11", second)):
            other = cv2.imread(os.path.join(middlebury, "other-data", name, frame + ".png"))
            assert np.array_equal(other[..., ::-1], np.asarray(image))
        moved.append(difference(grey_of(first), grey_of(second), flow, seen))
        unmoved.append(difference(grey_of(first), grey_of(second), np.zeros_like(flow), seen))
    assert np.mean(moved) < MAX_SHARE_OF_UNMOVED * np.mean(unmoved), (np.mean(moved), np.mean(unmoved))
    return (
        f"flow: {len(names)} pairs; images differ by {np.mean(unmoved):.2f} grey levels in place, "
        f"{np.mean(moved):.2f} where the flow leads"
    )
