"""Uncompressed BMP files of 24 bits."""

from __future__ import annotations

import struct

import numpy as np

from .picture_header import Picture, PictureHeader

SIGNATURE = b"BM"
_HEADER_BYTES = 54
_BITS = 24


def header(data: bytes) -> PictureHeader:
    """What a BMP says of itself. Raises ValueError if it is damaged or of another kind."""
    if len(data) < _HEADER_BYTES or not data.startswith(SIGNATURE):
        raise ValueError("it is cut off")
    width, height, _, bits, compression = struct.unpack_from("<iiHHI", data, 18)
    if compression != 0 or bits != _BITS or width <= 0 or height == 0:
        raise ValueError("it is not an uncompressed BMP of 24 bits")
    return PictureHeader(width, abs(height), 3, 8)


def decode(data: bytes) -> Picture:
    """A BMP as (rows, columns, 3), uint8, red first. Raises ValueError as header does, and if the data is cut off."""
    size = header(data)
    (start,), (height,) = struct.unpack_from("<I", data, 10), struct.unpack_from("<i", data, 22)
    # Rows are filled up to a multiple of four bytes.
    stride = (size.width * 3 + 3) // 4 * 4
    if len(data) < start + stride * size.height:
        raise ValueError("it is cut off")
    rows = np.frombuffer(data, np.uint8, stride * size.height, start).reshape(size.height, stride)
    picture = rows[:, : size.width * 3].reshape(size.height, size.width, 3)[..., ::-1]
    # A positive height has the lowest row first.
    return np.ascontiguousarray(picture[::-1] if height > 0 else picture)
