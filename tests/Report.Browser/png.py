"""Reads the greyscale PNG maps of a session: an implementation beside that of the page."""

import pathlib
import struct
import zlib


def grey(path: pathlib.Path):
    """The values of a PNG of 16 bits, as rows."""
    data = path.read_bytes()
    at, parts = 8, []
    while at < len(data):
        length, kind = struct.unpack(">I4s", data[at : at + 8])
        if kind == b"IHDR":
            width, height, bits, colour = struct.unpack(">IIBB", data[at + 8 : at + 18])
        elif kind == b"IDAT":
            parts.append(data[at + 8 : at + 8 + length])
        at += 12 + length
    assert (bits, colour) == (16, 0)
    raw, stride, rows, above = zlib.decompress(b"".join(parts)), 2 * width, [], bytes(2 * width)
    for y in range(height):
        line = bytearray(raw[y * (stride + 1) + 1 : (y + 1) * (stride + 1)])
        method = raw[y * (stride + 1)]
        for i in range(stride):
            a, b, c = (line[i - 2] if i > 1 else 0), above[i], (above[i - 2] if i > 1 else 0)
            paeth = min((a, b, c), key=lambda value: abs(a + b - c - value))
            line[i] = (line[i] + (0, a, b, (a + b) // 2, paeth)[method]) & 255
        rows.append(struct.unpack(f">{width}H", line))
        above = line
    return rows
