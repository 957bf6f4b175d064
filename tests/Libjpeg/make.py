"""Writes the pictures of this folder with libjpeg, through Debian's python3-pil and python3-opencv: what the encoder must write, and what the decoder must read."""

import os

import cv2
import numpy as np
from PIL import Image

HERE = os.path.dirname(os.path.abspath(__file__))
Y, X = np.mgrid[0:29, 0:45]
# The same picture as LibjpegPictures.Pattern.
PATTERN = np.stack([X * 11 + Y * 7, X * X * 3 + Y, X ^ (Y * 5)], axis=2).astype(np.uint8)
# Four flat colours that meet at the borders of 16 x 16 pixels, brighter and darker from row to row.
FLAT = np.clip(
    np.array([[[200, 60, 60], [60, 180, 90]], [[70, 80, 190], [190, 180, 60]]]).repeat(16, 0).repeat(16, 1)
    + 4 * (np.arange(32) % 8)[:, None, None],
    0,
    255,
).astype(np.uint8)


def path(name):
    return os.path.join(HERE, name)


def decoded(name):
    """Beside a JPEG picture, the pixels that libjpeg reads in it."""
    Image.open(path(name)).convert("RGB").save(path(name.replace(".jpg", ".png")))


for quality in (50, 95, 100):
    Image.fromarray(PATTERN).save(path(f"quality-{quality}.jpg"), quality=quality, subsampling=0)
    decoded(f"quality-{quality}.jpg")
Image.fromarray(PATTERN[:, :, 1]).save(path("grey.jpg"), quality=90)
decoded("grey.jpg")
Image.fromarray(FLAT).save(path("subsampled.jpg"), quality=95, subsampling=2)
decoded("subsampled.jpg")
Image.fromarray(PATTERN).save(path("optimised.jpg"), quality=80, subsampling=0, optimize=True)
decoded("optimised.jpg")
cv2.imwrite(path("restarts.jpg"), PATTERN[:, :, 1], [cv2.IMWRITE_JPEG_QUALITY, 90, cv2.IMWRITE_JPEG_RST_INTERVAL, 2])
decoded("restarts.jpg")
Image.fromarray(PATTERN).save(path("progressive.jpg"), quality=80, progressive=True)
Image.fromarray(PATTERN).convert("CMYK").save(path("cmyk.jpg"), quality=80)
