"""PNG files with nothing but zlib and NumPy: used if neither OpenCV nor Pillow is installed, and to write annotated frames."""

from __future__ import annotations

import struct
import zlib
from typing import Any, List, Optional

import numpy as np
import numpy.typing as npt

_SIGNATURE = b"\x89PNG\r\n\x1a\n"
_CHANNELS = {0: 1, 2: 3, 4: 2, 6: 4}
_GREY, _COLOUR = 0, 2
_MAX_SIDE = 65_535

Picture = npt.NDArray[Any]


def decode(data: bytes) -> Picture:
    """Decodes a PNG without palette and interlacing, of 8 or 16 bits per channel: (rows, columns) or (rows, columns, channels).

    Raises ValueError if the data is damaged or of another kind. Checksums are verified.
    """
    if not data.startswith(_SIGNATURE):
        raise ValueError("it is not a PNG")
    header: Optional[bytes] = None
    packed: List[bytes] = []
    at, ended = len(_SIGNATURE), False
    while not ended:
        if at + 12 > len(data):
            raise ValueError("it is cut off")
        size, kind = struct.unpack_from(">I4s", data, at)
        body = data[at + 8:at + 8 + size]
        if len(data) < at + 12 + size:
            raise ValueError("it is cut off")
        if zlib.crc32(kind + body) != struct.unpack_from(">I", data, at + 8 + size)[0]:
            raise ValueError("a checksum is wrong")
        if kind == b"IHDR":
            header = body
        elif kind == b"IDAT":
            packed.append(body)
        ended = kind == b"IEND"
        at += 12 + size
    if header is None or len(header) != 13:
        raise ValueError("it has no header")
    width, height, bits, colour, _, _, interlace = struct.unpack(">IIBBBBB", header)
    if colour not in _CHANNELS or bits not in (8, 16) or interlace:
        raise ValueError("it has a palette, is interlaced, or has fewer than 8 bits; install Pillow or OpenCV to read it")
    if not (0 < width <= _MAX_SIDE and 0 < height <= _MAX_SIDE):
        raise ValueError("its size is out of range")
    step = _CHANNELS[colour] * bits // 8
    expected = height * (1 + width * step)
    inflater = zlib.decompressobj()
    try:
        rows = inflater.decompress(b"".join(packed), expected)
    except zlib.error as problem:
        raise ValueError(f"its data is damaged ({problem})") from problem
    if len(rows) != expected:
        raise ValueError("it has fewer pixels than its header says")
    flat = _unfiltered(np.frombuffer(rows, np.uint8).reshape(height, 1 + width * step), step)
    picture = flat if bits == 8 else flat.reshape(height, -1).view(">u2").astype(np.uint16)
    return picture.reshape((height, width) if _CHANNELS[colour] == 1 else (height, width, _CHANNELS[colour]))


def _unfiltered(rows: Picture, step: int) -> Picture:
    kinds = rows[:, 0]
    result = rows[:, 1:].copy()
    # Sub needs only its own row, so all its rows are done at once; the other filters go on from the row above.
    sub = kinds == 1
    result[sub] = np.cumsum(result[sub].reshape(-1, rows.shape[1] // step, step), axis=1, dtype=np.uint8).reshape(-1, result.shape[1])
    none = np.zeros(result.shape[1], np.uint8)
    for number in np.flatnonzero(kinds > 1):
        above = result[number - 1] if number else none
        if kinds[number] == 2:
            result[number] += above
        elif kinds[number] in (3, 4):
            result[number] = _predicted(bytes(result[number]), bytes(above), step, int(kinds[number]))
        else:
            raise ValueError("its data is damaged (unknown filter)")
    return result


def _predicted(line: bytes, above: bytes, step: int, kind: int) -> Picture:
    """Rows filtered with Average (3) or Paeth (4), where every byte depends on the one before."""
    done = bytearray(len(line))
    for i, value in enumerate(line):
        left, corner = (done[i - step], above[i - step]) if i >= step else (0, 0)
        if kind == 3:
            guess = (left + above[i]) // 2
        else:
            to_left, to_above, to_corner = abs(above[i] - corner), abs(left - corner), abs(left + above[i] - 2 * corner)
            guess = left if to_left <= to_above and to_left <= to_corner else above[i] if to_above <= to_corner else corner
        done[i] = (value + guess) & 0xFF
    return np.frombuffer(bytes(done), np.uint8)


def encode(picture: Picture) -> bytes:
    """Encodes an image as PNG: (rows, columns, 3) of uint8, or (rows, columns) of uint8 or uint16."""
    height, width = picture.shape[:2]
    bits = 16 if picture.dtype == np.uint16 else 8
    colour = _COLOUR if picture.ndim == 3 else _GREY
    lines = picture.astype(">u2" if bits == 16 else np.uint8).reshape(height, -1).view(np.uint8)
    filtered = np.empty((height, 1 + lines.shape[1]), np.uint8)
    filtered[:, 0] = 2
    filtered[0, 1:] = lines[0]
    filtered[1:, 1:] = lines[1:] - lines[:-1]
    header = struct.pack(">IIBBBBB", width, height, bits, colour, 0, 0, 0)
    return _SIGNATURE + b"".join(
        struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
        for kind, body in ((b"IHDR", header), (b"IDAT", zlib.compress(filtered.tobytes(), 6)), (b"IEND", b"")))
