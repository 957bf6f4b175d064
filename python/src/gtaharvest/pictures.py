"""Reads pictures of the formats that sessions have: PNG and BMP with zlib and NumPy, JPEG with OpenCV or Pillow.

A file is recognised by its first bytes, and its size is compared with that of its label before a pixel is decoded.
"""

from __future__ import annotations

import functools
import io
from pathlib import Path
from typing import Any, Callable, Tuple

import numpy as np
import numpy.typing as npt

from . import bmp, jpeg, png
from .errors import MissingPictureError, PictureError
from .files import read_regular
from .picture_header import MAX_BYTES, MAX_SIDE, Picture, PictureHeader

Size = Tuple[int, int]
"""Width and height, pixels."""

Decoder = Callable[[bytes], Picture]

Depth = npt.NDArray[np.float32]
"""Depths, or their errors, in metres, of shape (rows, columns)."""


def read_image(path: Path, size: Size) -> Picture:
    """An image of a size as (rows, columns, 3), uint8, red first.

    Raises MissingPictureError and PictureError.
    """
    data = _read(path)
    header = _header(path, data, size)
    if header.bits != 8 or header.channels not in (1, 3):
        raise PictureError(f"{path}: an image has 8 bits per channel, in grey or in red, green and blue.")
    picture = _decoded(path, data)
    return np.stack([picture] * 3, axis=-1) if picture.ndim == 2 else picture


def read_mask(path: Path, size: Size) -> Picture:
    """An instance mask of a size as (rows, columns), uint16: the id of the object visible at each pixel, or 0.

    Raises MissingPictureError and PictureError.
    """
    return _map(path, size, (8, 16), "a mask is a greyscale PNG of 16 bits").astype(np.uint16, copy=False)


def read_class_map(path: Path, size: Size) -> Picture:
    """A class map of a size as (rows, columns), uint8: the number of the class visible at each pixel.

    Raises MissingPictureError and PictureError.
    """
    return _map(path, size, (8,), "a class map is a greyscale PNG of 8 bits")


def read_depth(path: Path, size: Size) -> Depth:
    """A depth map, or a map of errors, of a size as (rows, columns), float32: metres, or NaN where there is none.

    Raises MissingPictureError and PictureError.
    """
    picture = _map(path, size, (8, 16), "a depth map is a greyscale PNG of 16 bits")
    metres = picture.astype(np.float32) / np.float32(256)
    metres[picture == 0] = np.nan
    return metres


def read_vectors(path: Path, size: Size) -> Picture:
    """A map of flow or motion of a size as (rows, columns, 3), uint16, as it is stored.

    Raises MissingPictureError and PictureError.
    """
    data = _read(path)
    header = _header(path, data, size)
    if not data.startswith(png.SIGNATURE) or header.channels != 3 or header.bits != 16:
        raise PictureError(f"{path}: a map of flow is a PNG of 16 bits for each of red, green and blue.")
    return _decoded(path, data)


def _map(path: Path, size: Size, bits: Tuple[int, ...], kind: str) -> Picture:
    data = _read(path)
    header = _header(path, data, size)
    if not data.startswith(png.SIGNATURE) or header.channels != 1 or header.bits not in bits:
        raise PictureError(f"{path}: {kind}.")
    return _decoded(path, data)


def _read(path: Path) -> bytes:
    try:
        return read_regular(path, MAX_BYTES)
    except FileNotFoundError:
        raise MissingPictureError(
            f"{path}: the picture does not exist. Run harvester validate to list all that is missing."
        ) from None
    except OSError as problem:
        raise PictureError(f"{path}: the picture cannot be read: {problem.strerror}.") from None


def _header(path: Path, data: bytes, size: Size) -> PictureHeader:
    try:
        header = header_of(data)
    except ValueError as problem:
        raise PictureError(f"{path}: the picture cannot be decoded: {problem}.") from None
    if header[:2] != size:
        raise PictureError(
            f"{path}: the picture has {header.width}x{header.height} pixels; its label says {size[0]}x{size[1]}."
        )
    if max(size) > MAX_SIDE:
        raise PictureError(f"{path}: the picture has {size[0]}x{size[1]} pixels, more than {MAX_SIDE}x{MAX_SIDE}.")
    return header


def _decoded(path: Path, data: bytes) -> Picture:
    try:
        return decode(data)
    except ValueError as problem:
        raise PictureError(f"{path}: the picture cannot be decoded: {problem}.") from None


def header_of(data: bytes) -> PictureHeader:
    """What a picture says of itself. Raises ValueError if it is damaged or of a format that sessions do not have."""
    if data.startswith(bmp.SIGNATURE):
        return bmp.header(data)
    if data.startswith(jpeg.SIGNATURE):
        return jpeg.header(data)
    if data.startswith(png.SIGNATURE):
        return png.header(data)
    raise ValueError("it is not a PNG, JPEG or BMP")


def decode(data: bytes) -> Picture:
    """The pixels of a picture: (rows, columns) if it is grey, or (rows, columns, channels), red first.

    Raises ValueError if it is damaged, of a format that sessions do not have, or a JPEG without a package that decodes it.
    """
    header = header_of(data)
    if data.startswith(bmp.SIGNATURE):
        return bmp.decode(data)
    if not data.startswith(jpeg.SIGNATURE):
        return png.decode(data)
    picture = jpeg_decoder()(jpeg.essential(data))
    if picture.shape[:2] != (header.height, header.width):
        raise ValueError("its pixels do not have the size of its header")
    return picture


@functools.lru_cache(maxsize=None)
def jpeg_decoder() -> Decoder:
    """The decoder of JPEG in use: the first that is installed."""
    for available in (_opencv, _pillow):
        try:
            return available()
        except ImportError:
            continue
    return _without_a_decoder


def _opencv() -> Decoder:
    import cv2

    def opencv(data: bytes) -> Picture:
        try:
            picture: Any = cv2.imdecode(np.frombuffer(data, np.uint8), cv2.IMREAD_UNCHANGED)
        except cv2.error as problem:
            raise ValueError(f"OpenCV refuses it ({problem.err})") from None
        if picture is None:
            raise ValueError("OpenCV refuses it; it is damaged")
        # OpenCV has blue first.
        return np.asarray(picture if picture.ndim == 2 else cv2.cvtColor(picture, cv2.COLOR_BGR2RGB))

    return opencv


def _pillow() -> Decoder:
    from PIL import Image

    def pillow(data: bytes) -> Picture:
        try:
            with Image.open(io.BytesIO(data), formats=["JPEG"]) as picture:
                return np.asarray(picture if picture.mode == "L" else picture.convert("RGB"))
        # What Pillow raises for damaged data differs between its versions.
        except Exception as problem:
            raise ValueError(f"Pillow refuses it ({problem})") from None

    return pillow


def _without_a_decoder(data: bytes) -> Picture:
    raise ValueError("reading JPEG needs Pillow or OpenCV; install one")
