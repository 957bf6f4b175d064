"""Where the lines of labels.jsonl begin, so that a frame is read without the frames before it."""

from __future__ import annotations

import mmap
import re
from pathlib import Path
from typing import Any, Iterator, Optional, Union

import numpy as np
import numpy.typing as npt

Offsets = npt.NDArray[np.int64]

_MANIFEST_LINE = re.compile(rb'^\{"frame":\d+,"label":\{"bytes":(\d{1,12}),', re.MULTILINE)
_LINE_FEED = 10
# Line ends that are compared with the file before sizes from the manifest are used.
_PROBES = 256


class LineIndex:
    """The lines of a file, without an unfinished last one. Opened again in each process that uses it."""

    def __init__(self, path: Path, manifest: Path) -> None:
        self._path = path
        self._mapped: Union[mmap.mmap, bytes, None] = None
        listed = self._from_manifest(manifest)
        self._offsets: Offsets = self._by_scan() if listed is None else listed

    def __len__(self) -> int:
        return len(self._offsets) - 1

    def line(self, number: int) -> bytes:
        """The bytes of a line, from 0, without its line feed."""
        return bytes(self._bytes[self._offsets[number]:self._offsets[number + 1] - 1])

    def with_match(self, pattern: re.Pattern[bytes]) -> Iterator[int]:
        """The numbers of the lines in which a pattern is found, ascending."""
        at = 0
        while match := pattern.search(self._bytes, at):
            last = int(np.searchsorted(self._offsets, match.start(), side="right")) - 1
            if last >= len(self):
                return
            yield last
            at = int(self._offsets[last + 1])

    def __getstate__(self) -> Any:
        return {"_path": self._path, "_offsets": self._offsets, "_mapped": None}

    @property
    def _bytes(self) -> Union[mmap.mmap, bytes]:
        if self._mapped is None:
            # A file that grows while a harvest runs is read as it was when it was opened; an empty file cannot be mapped.
            empty = not self._path.exists() or self._path.stat().st_size == 0
            if empty:
                self._mapped = b""
            else:
                with open(self._path, "rb") as stream:
                    self._mapped = mmap.mmap(stream.fileno(), 0, access=mmap.ACCESS_READ)
        return self._mapped

    def _from_manifest(self, manifest: Path) -> Optional[Offsets]:
        """From the sizes in the manifest of a closed session, which are in the order of the lines; None if they do not fit the file."""
        try:
            sizes = _MANIFEST_LINE.findall(manifest.read_bytes())
        except OSError:
            return None
        lengths = np.array(sizes, dtype=np.int64) if sizes else np.empty(0, np.int64)
        offsets = np.concatenate([np.zeros(1, np.int64), np.cumsum(lengths + 1)])
        if not sizes or offsets[-1] != len(self._bytes):
            return None
        probed = offsets[np.linspace(1, len(offsets) - 1, min(_PROBES, len(sizes))).astype(np.int64)]
        return offsets if all(self._bytes[int(end) - 1] == _LINE_FEED for end in probed) else None

    def _by_scan(self) -> Offsets:
        data, offsets, end = self._bytes, [0], -1
        # Searching for one byte is the fastest way through a file, faster than an array of all bytes.
        while (end := data.find(b"\n", end + 1)) >= 0:
            offsets.append(end + 1)
        return np.array(offsets, dtype=np.int64)
