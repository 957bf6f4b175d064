"""PNG files, read and written with zlib and NumPy alone."""

from __future__ import annotations

import struct
import zlib
from typing import Iterator

import numpy as np

from .picture_header import MAX_SIDE, Picture, PictureHeader
from .png_filters import unfiltered

SIGNATURE = b"\x89PNG\r\n\x1a\n"
_CHANNELS = {0: 1, 2: 3, 4: 2, 6: 4}
_GREY, _COLOUR = 0, 2
_HEADER_BYTES = 13
_FIRST_CHUNK_END = len(SIGNATURE) + 12 + _HEADER_BYTES


def header(data: bytes) -> PictureHeader:
    """What a PNG says of itself. Raises ValueError if it is damaged or of another kind than decode reads."""
    if not data.startswith(SIGNATURE):
        raise ValueError("it is not a PNG")
    if len(data) < _FIRST_CHUNK_END:
        raise ValueError("it is cut off")
    size, kind, width, height, bits, colour, packing, filters, interlace = struct.unpack_from(
        ">I4sIIBBBBB", data, len(SIGNATURE)
    )
    if (size, kind) != (_HEADER_BYTES, b"IHDR"):
        raise ValueError("it has no header")
    if colour not in _CHANNELS or bits not in (8, 16) or packing or filters or interlace:
        raise ValueError("it has a palette, is interlaced, or has fewer than 8 bits")
    if not width or not height:
        raise ValueError("its size is out of range")
    return PictureHeader(width, height, _CHANNELS[colour], bits)


def decode(data: bytes) -> Picture:
    """Decodes a PNG without palette and interlacing, of 8 or 16 bits per channel: (rows, columns) or (rows, columns, channels).

    Raises ValueError if the data is damaged or of another kind, or has a side of more than MAX_SIDE. Checksums are verified.
    """
    form = header(data)
    if max(form.width, form.height) > MAX_SIDE:
        raise ValueError("its size is out of range")
    step = form.channels * form.bits // 8
    expected = form.height * (1 + form.width * step)
    rows = bytearray()
    inflater = zlib.decompressobj()
    try:
        for body in _packed(data):
            # No more is unpacked than the header promises, whatever the data holds.
            while body and len(rows) < expected:
                rows += inflater.decompress(body, expected - len(rows))
                body = memoryview(inflater.unconsumed_tail)
    except zlib.error as problem:
        raise ValueError(f"its data is damaged ({problem})") from problem
    if len(rows) != expected:
        raise ValueError("it has fewer pixels than its header says")
    flat = unfiltered(np.frombuffer(rows, np.uint8).reshape(form.height, 1 + form.width * step), step)
    picture = flat if form.bits == 8 else flat.reshape(form.height, -1).view(">u2").astype(np.uint16)
    return picture.reshape(
        (form.height, form.width) if form.channels == 1 else (form.height, form.width, form.channels)
    )


def _packed(data: bytes) -> Iterator[memoryview]:
    """The bodies of the chunks with pixels."""
    view = memoryview(data)
    at = len(SIGNATURE)
    while True:
        if at + 12 > len(data):
            raise ValueError("it is cut off")
        size, kind = struct.unpack_from(">I4s", data, at)
        end = at + 12 + size
        if end > len(data):
            raise ValueError("it is cut off")
        if zlib.crc32(view[at + 4 : end - 4]) != struct.unpack_from(">I", data, end - 4)[0]:
            raise ValueError("a checksum is wrong")
        if kind == b"IEND":
            return
        if kind == b"IDAT":
            yield view[at + 8 : end - 4]
        at = end


def encode(picture: Picture) -> bytes:
    """Encodes an image as PNG: (rows, columns, 3) or (rows, columns), of uint8 or uint16."""
    height, width = picture.shape[:2]
    bits = 16 if picture.dtype == np.uint16 else 8
    colour = _COLOUR if picture.ndim == 3 else _GREY
    lines = picture.astype(">u2" if bits == 16 else np.uint8).reshape(height, -1).view(np.uint8)
    filtered = np.empty((height, 1 + lines.shape[1]), np.uint8)
    filtered[:, 0] = 2
    filtered[0, 1:] = lines[0]
    filtered[1:, 1:] = lines[1:] - lines[:-1]
    form = struct.pack(">IIBBBBB", width, height, bits, colour, 0, 0, 0)
    return SIGNATURE + b"".join(
        struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
        for kind, body in ((b"IHDR", form), (b"IDAT", zlib.compress(filtered.tobytes(), 6)), (b"IEND", b""))
    )
