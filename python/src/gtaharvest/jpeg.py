"""JPEG files of the kind that sessions have: baseline, of one scan. Their pixels are decoded by OpenCV or Pillow.

Only what such a file consists of reaches the decoder. Progressive files are refused: thousands of scans would take minutes.
"""

from __future__ import annotations

import re
import struct
from typing import List, Tuple

from .picture_header import PictureHeader

SIGNATURE = b"\xff\xd8"
_END = b"\xff\xd9"

_BASELINE = 0xC0
_SCAN = 0xDA
# Huffman tables, quantisation tables, restart interval, and JFIF's own segment.
_TAKEN = (0xC4, 0xDB, 0xDD, 0xE0)
# Further segments of applications, and comments.
_LEFT_OUT = (*range(0xE1, 0xF0), 0xFE)
# In a scan, 0xFF is followed by 0 or is a restart; what else follows it ends the scan.
_MARKER = re.compile(rb"\xff[^\x00\xd0-\xd7]")


def header(data: bytes) -> PictureHeader:
    """What a JPEG says of itself. Raises ValueError if it is damaged or of another kind."""
    return _parsed(data)[0]


def essential(data: bytes) -> bytes:
    """The JPEG without the segments that its pixels do not need. Raises ValueError as header does."""
    return _parsed(data)[1]


def _parsed(data: bytes) -> Tuple[PictureHeader, bytes]:
    taken: List[bytes] = [SIGNATURE]
    found: List[PictureHeader] = []
    at = len(SIGNATURE)
    while True:
        if at + 4 > len(data):
            raise ValueError("it is cut off")
        mark, kind, size = struct.unpack_from(">BBH", data, at)
        end = at + 2 + size
        if mark != 0xFF or size < 2:
            raise ValueError("its segments are damaged")
        if end > len(data):
            raise ValueError("it is cut off")
        if kind == _BASELINE:
            found.append(_frame(data[at + 4 : end]))
        elif kind not in _TAKEN and kind not in _LEFT_OUT and kind != _SCAN:
            raise ValueError("it is not a baseline JPEG")
        if kind not in _LEFT_OUT:
            taken.append(data[at:end])
        at = end
        if kind == _SCAN:
            break
    if len(found) != 1:
        raise ValueError("it has no header, or several")
    marker = _MARKER.search(data, at)
    if marker is None:
        raise ValueError("it is cut off")
    if marker.group() != _END or marker.end() != len(data):
        raise ValueError("it has more than one scan, or something after its end")
    return found[0], b"".join((*taken, data[at:]))


def _frame(body: bytes) -> PictureHeader:
    if len(body) < 6:
        raise ValueError("its header is damaged")
    bits, height, width, components = struct.unpack_from(">BHHB", body)
    if bits != 8 or components not in (1, 3) or len(body) != 6 + 3 * components or not width or not height:
        raise ValueError("it is not a JPEG of 8 bits, grey or in colours")
    return PictureHeader(width, height, components, bits)
