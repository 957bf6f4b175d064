"""What the header of a picture says, known before a pixel is decoded."""

from __future__ import annotations

from typing import Any, NamedTuple

import numpy.typing as npt

Picture = npt.NDArray[Any]

MAX_SIDE = 8192
"""The largest width and height of a picture, pixels."""

MAX_BYTES = 256 * 1024 * 1024
"""The largest file of a picture."""


class PictureHeader(NamedTuple):
    """Width and height in pixels, number of channels, and bits of each."""

    width: int
    height: int
    channels: int
    bits: int
