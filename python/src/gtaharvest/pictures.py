"""Decodes images and masks with OpenCV or Pillow where one is installed, otherwise PNG and BMP with zlib and NumPy."""

from __future__ import annotations

import functools
import io
import struct
from pathlib import Path
from typing import Any, Callable

import numpy as np
import numpy.typing as npt

from . import png
from .errors import MissingPictureError, PictureError
from .png import Picture

Decoder = Callable[[bytes], Picture]

Depth = npt.NDArray[np.float32]
"""Depths, or their errors, in metres, of shape (rows, columns)."""


def read_image(path: Path) -> Picture:
    """An image as (rows, columns, 3), uint8, red first.

    Raises MissingPictureError and PictureError.
    """
    picture = _read(path)
    if picture.dtype != np.uint8:
        raise PictureError(f"{path}: an image has 8 bits per channel, not {8 * picture.dtype.itemsize}.")
    return np.stack([picture] * 3, axis=-1) if picture.ndim == 2 else picture[..., :3]


def read_mask(path: Path) -> Picture:
    """An instance mask as (rows, columns), uint16: the id of the object visible at each pixel, or 0.

    Raises MissingPictureError and PictureError.
    """
    picture = _read(path)
    if picture.ndim != 2 or picture.dtype not in (np.uint8, np.uint16):
        raise PictureError(f"{path}: a mask is a greyscale PNG of 16 bits.")
    return picture.astype(np.uint16, copy=False)


def read_class_map(path: Path) -> Picture:
    """A class map as (rows, columns), uint8: the number of the class visible at each pixel.

    Raises MissingPictureError and PictureError.
    """
    picture = _read(path)
    if picture.ndim != 2 or picture.dtype != np.uint8:
        raise PictureError(f"{path}: a class map is a greyscale PNG of 8 bits.")
    return picture


def read_depth(path: Path) -> Depth:
    """A depth map, or a map of errors, as (rows, columns), float32: metres, or NaN where there is none.

    Raises MissingPictureError and PictureError.
    """
    picture = _read(path)
    if picture.ndim != 2 or picture.dtype not in (np.uint8, np.uint16):
        raise PictureError(f"{path}: a depth map is a greyscale PNG of 16 bits.")
    metres = picture.astype(np.float32) / np.float32(256)
    metres[picture == 0] = np.nan
    return metres


def _read(path: Path) -> Picture:
    try:
        data = path.read_bytes()
    except FileNotFoundError:
        raise MissingPictureError(f"{path}: the picture does not exist. Run harvester validate to list all that is missing.") from None
    try:
        return decoder()(data)
    except ValueError as problem:
        raise PictureError(f"{path}: the picture cannot be decoded: {problem}.") from None


@functools.lru_cache(maxsize=None)
def decoder() -> Decoder:
    """The decoder in use: the first that is installed."""
    for available in (_opencv, _pillow):
        try:
            return available()
        except ImportError:
            continue
    return decode_plain


def _opencv() -> Decoder:
    import cv2

    def decode(data: bytes) -> Picture:
        picture: Any = cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_UNCHANGED) if data else None
        if picture is None:
            raise ValueError("OpenCV refuses it; it is damaged or of an unknown format")
        # OpenCV has blue first.
        return np.asarray(picture if picture.ndim == 2 else cv2.cvtColor(picture[..., :3], cv2.COLOR_BGR2RGB))

    return decode


def _pillow() -> Decoder:
    from PIL import Image

    def decode(data: bytes) -> Picture:
        try:
            with Image.open(io.BytesIO(data)) as picture:
                picture.load()
                if picture.mode.startswith("I"):
                    return np.asarray(picture).astype(np.uint16)
                return np.asarray(picture if picture.mode == "L" else picture.convert("RGB"))
        except (OSError, SyntaxError, Image.DecompressionBombError) as problem:
            raise ValueError(f"Pillow refuses it ({problem})") from problem

    return decode


def decode_plain(data: bytes) -> Picture:
    """Decodes PNG and uncompressed BMP of 24 or 32 bits without another package.

    Raises ValueError if the data is damaged or of another kind.
    """
    if data.startswith(b"BM"):
        return _decode_bmp(data)
    if data.startswith(b"\xff\xd8"):
        raise ValueError("reading JPEG needs Pillow or OpenCV; install one")
    return png.decode(data)


def _decode_bmp(data: bytes) -> Picture:
    if len(data) < 54:
        raise ValueError("it is cut off")
    start, _, width, height, _, bits, compression = struct.unpack_from("<IIiiHHI", data, 10)
    step = bits // 8
    stride = (width * step + 3) // 4 * 4
    if compression not in (0, 3) or bits not in (24, 32) or width <= 0 or height == 0:
        raise ValueError("only uncompressed BMP of 24 or 32 bits can be read without Pillow or OpenCV")
    if len(data) < start + stride * abs(height):
        raise ValueError("it is cut off")
    rows = np.frombuffer(data, np.uint8, stride * abs(height), start).reshape(abs(height), stride)
    picture = rows[:, :width * step].reshape(abs(height), width, step)[..., 2::-1]
    return np.ascontiguousarray(picture[::-1] if height > 0 else picture)
