"""Where the lines of labels.jsonl begin, so that a frame is read without the frames before it."""

from __future__ import annotations

import re
from array import array
from pathlib import Path
from typing import Any, Iterator, Optional

import numpy as np
import numpy.typing as npt

from .files import open_regular

Offsets = npt.NDArray[np.int64]

MAX_LINES = 10_000_000
"""The most frames of a session."""

MAX_LINE_BYTES = 8 * 1024 * 1024
"""The longest label line."""

_MANIFEST_LINE = re.compile(rb'^\{"frame":\d+,"label":\{"bytes":(\d{1,12}),')
_MAX_MANIFEST_LINE_BYTES = 1024 * 1024
_LINE_FEED = b"\n"
_BLOCK = 1024 * 1024
# Line ends that are compared with the file before sizes from the manifest are used.
_PROBES = 256


class LineIndex:
    """The lines of a file, without an unfinished last one.

    The file is opened for each line, so that several processes and threads can read it, and is as it was when the index was made: what a
    harvest appends meanwhile is not seen.

    Raises OSError if the file cannot be read, and ValueError if it has too many lines.
    """

    def __init__(self, path: Path, manifest: Path) -> None:
        self._path = path
        try:
            with open_regular(path) as stream:
                self._size = stream.seek(0, 2)
        except FileNotFoundError:
            self._size = 0
        listed = self._from_manifest(manifest) if self._size else None
        self._offsets: Offsets = self._by_scan() if listed is None else listed

    def __len__(self) -> int:
        return len(self._offsets) - 1

    def line(self, number: int) -> bytes:
        """The bytes of a line, from 0, without its line feed. Raises OSError, and ValueError if it is too long or the file was changed."""
        start, end = int(self._offsets[number]), int(self._offsets[number + 1])
        if end - start > MAX_LINE_BYTES:
            raise ValueError(f"it has {end - start} bytes, more than {MAX_LINE_BYTES}")
        with open_regular(self._path) as stream:
            stream.seek(start)
            text = stream.read(end - start)
        if text[-1:] != _LINE_FEED or len(text) != end - start:
            raise ValueError("the file was changed after it was opened")
        return text[:-1]

    def _from_manifest(self, manifest: Path) -> Optional[Offsets]:
        """From the sizes in the manifest of a closed session, which are in the order of the lines; None if they do not fit the file."""
        offsets = array("q", [0])
        try:
            with open_regular(manifest) as unbuffered:
                for line in _lines(unbuffered):
                    found = _MANIFEST_LINE.match(line)
                    if found:
                        offsets.append(offsets[-1] + int(found[1]) + 1)
                    if offsets[-1] > self._size or len(offsets) > MAX_LINES:
                        return None
        except OSError:
            return None
        return np.array(offsets, dtype=np.int64) if offsets[-1] == self._size and self._ends_at(offsets) else None

    def _ends_at(self, offsets: Any) -> bool:
        with open_regular(self._path) as stream:
            for number in np.linspace(1, len(offsets) - 1, min(_PROBES, len(offsets) - 1)).astype(np.int64):
                stream.seek(offsets[int(number)] - 1)
                if stream.read(1) != _LINE_FEED:
                    return False
        return True

    def _by_scan(self) -> Offsets:
        offsets = array("q", [0])
        if self._size:
            with open_regular(self._path) as stream:
                start = 0
                while start < self._size and (block := stream.read(min(_BLOCK, self._size - start))):
                    end = -1
                    # Searching for one byte is the fastest way through a file.
                    while (end := block.find(_LINE_FEED, end + 1)) >= 0:
                        offsets.append(start + end + 1)
                    start += len(block)
                    if len(offsets) > MAX_LINES:
                        raise ValueError(f"it has more than {MAX_LINES} lines")
        return np.array(offsets, dtype=np.int64)


def _lines(stream: Any) -> Iterator[bytes]:
    """The lines of a file, without those that are too long to be of a manifest."""
    rest = b""
    while block := stream.read(_BLOCK):
        *whole, rest = (rest + block).split(_LINE_FEED)
        yield from whole
        if len(rest) > _MAX_MANIFEST_LINE_BYTES:
            rest = b""
