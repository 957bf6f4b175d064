"""Opens the folder of a session."""

from __future__ import annotations

import functools
import itertools
import json
import os
import re
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Dict, Iterator, List, Mapping, Optional, Tuple, Union

import numpy as np

from .camera import Array, Camera
from .errors import LabelError, NewerFormatError, NotASessionError, PartialSessionError
from .frame import ONLY_VIEW, Frame
from .index import LineIndex
from .label_line import LabelLine
from .records import ObjectLabel
from .selection import Selection

if TYPE_CHECKING:
    import pandas

FORMAT_VERSION = 1
"""The newest version of the format that this package reads."""

_UNFINISHED_MARK = ".harvester-unfinished"


@dataclass(frozen=True)
class Track:
    """One object through the frames of a session. frames and times_seconds belong to the labels at the same index."""

    id: int
    frames: Tuple[int, ...]
    times_seconds: Tuple[float, ...]
    labels: Tuple[ObjectLabel, ...]

    @property
    def class_name(self) -> str:
        """The class of the object."""
        return self.labels[0].class_name

    @property
    def centres(self) -> Array:
        """The centres of its cuboid, (n, 3), metres, world."""
        return np.array([label.box3d.centre for label in self.labels], dtype=np.float64).reshape(-1, 3)

    @property
    def boxes(self) -> Array:
        """Its box2d, (n, 4), pixels."""
        return np.array([label.box2d for label in self.labels], dtype=np.float64).reshape(-1, 4)


class Session:
    """A session on disk. Frames are read when they are asked for; session[i] is the i-th frame of the file.

    folder: the folder. info: session.json as parsed JSON.
    """

    def __init__(self, folder: Path, info: Mapping[str, Any]) -> None:
        self.folder = folder
        self.info = info

    @property
    def classes(self) -> Tuple[str, ...]:
        """The classes that were labelled, in the order of their numbers."""
        return tuple(self.info.get("classes", ()))

    @property
    def camera(self) -> Optional[Camera]:
        """The camera at the start; each frame has its own. None in a repaired session that has lost it."""
        return Camera.from_json(self.info["camera"]) if "camera" in self.info else None

    @property
    def state(self) -> str:
        """recording, complete or faulted."""
        return str(self.info["state"])

    @property
    def view_names(self) -> Tuple[str, ...]:
        """The cameras of the rig, in the order of their frames; ONLY_VIEW in a session with a single camera."""
        return tuple(str(camera["name"]) for camera in self.info["rig"]["cameras"]) if "rig" in self.info else (ONLY_VIEW,)

    def moments(self) -> Iterator[Dict[str, Frame]]:
        """The frames of each moment by the names of their views. A repaired session may lack some."""
        for _, frames in itertools.groupby(self, lambda frame: frame.number if frame.moment is None else frame.moment):
            yield {frame.view_name: frame for frame in frames}

    @functools.cached_property
    def _index(self) -> LineIndex:
        return LineIndex(self.folder / "labels.jsonl", self.folder / "manifest.jsonl")

    def __len__(self) -> int:
        return len(self._index)

    def __getitem__(self, position: int) -> Frame:
        if not -len(self) <= position < len(self):
            raise IndexError(f"{self.folder} has {len(self)} frames; there is none at {position}.")
        return self._read(position % len(self))

    def __iter__(self) -> Iterator[Frame]:
        return map(self._read, range(len(self)))

    def __repr__(self) -> str:
        return f"Session({str(self.folder)!r})"

    def frame(self, number: int) -> Frame:
        """The frame with a number, which in a shard or a repaired session differs from its position.

        Raises KeyError if the session does not have it.
        """
        if 0 <= number < len(self) and self[number].number == number:
            return self[number]
        return self[self._positions[number]]

    @functools.cached_property
    def _positions(self) -> Dict[int, int]:
        return {frame.number: position for position, frame in enumerate(self)}

    def track(self, id: int) -> Track:
        """The object with an id, in all frames that show it. Reads the whole label file.

        Raises KeyError if no frame shows it.
        """
        # Vehicles in lanes have the same key, so some of these frames may not have the object.
        lines = self._index.with_match(re.compile(rb'"id"\s*:\s*%d\b' % id))
        found = self._tracks(map(self._read, lines), only=id)
        if not found:
            raise KeyError(id)
        return found[id]

    def tracks(self) -> Dict[int, Track]:
        """All objects by id, each in all frames that show it. Reads the whole label file."""
        return self._tracks(self)

    @staticmethod
    def _tracks(frames: Any, only: Optional[int] = None) -> Dict[int, Track]:
        seen: Dict[int, List[Tuple[int, float, ObjectLabel]]] = {}
        for frame in frames:
            for label in frame.objects:
                if only is None or label.id == only:
                    seen.setdefault(label.id, []).append((frame.number, frame.time_seconds, label))
        return {id: Track(id, *(tuple(column) for column in zip(*rows))) for id, rows in sorted(seen.items())}

    def to_pandas(self, selection: Optional[Selection] = None) -> pandas.DataFrame:
        """A table with one row per object, all or those that pass a filter. Needs pandas; reads the whole label file."""
        from .tables import table_of

        return table_of(self, selection)

    def _read(self, position: int) -> Frame:
        source = f"{self.folder / 'labels.jsonl'}, line {position + 1}"
        try:
            return Frame(LabelLine(self._index.line(position)), self.folder, source)
        except ValueError as problem:
            raise LabelError(f"{source}: it is not a JSON object ({problem}). Run harvester validate, or harvester repair.") from None


def open_session(folder: Union[str, os.PathLike[str]], allow_partial: bool = False) -> Session:
    """Opens the folder of a session.

    allow_partial: also open a session whose recording or last line was cut off, or that is still recorded; the frames whose lines are
    complete are read.

    Raises NotASessionError, NewerFormatError and PartialSessionError.
    """
    path = Path(folder).resolve()
    header = path / "session.json"
    if not path.is_dir():
        raise NotASessionError(f"{path}: the folder does not exist.")
    try:
        info = json.loads(header.read_bytes())
    except FileNotFoundError:
        raise NotASessionError(f"{path}: it is not a session; it has no session.json.") from None
    except ValueError as problem:
        raise NotASessionError(f"{header}: it is not valid JSON ({problem}). Run harvester repair.") from None
    version = info.get("formatVersion") if isinstance(info, dict) else None
    if not isinstance(version, int):
        raise NotASessionError(f"{header}: it has no formatVersion.")
    if version > FORMAT_VERSION:
        raise NewerFormatError(
            f"{header}: the session has format version {version}; this gtaharvest reads up to {FORMAT_VERSION}. Install a newer one.")
    if not allow_partial and (info.get("state") == "recording" or (path / _UNFINISHED_MARK).exists()):
        raise PartialSessionError(
            f"{path}: the recording of the session is unfinished. Finish it with the same command, or open it with allow_partial=True.")
    if not allow_partial and _ends_in_part_of_a_line(path / "labels.jsonl"):
        raise PartialSessionError(
            f"{path / 'labels.jsonl'}: its last line is cut off. Run harvester repair, or open the session with allow_partial=True.")
    return Session(path, info)


def _ends_in_part_of_a_line(path: Path) -> bool:
    if not path.exists() or path.stat().st_size == 0:
        return False
    with open(path, "rb") as stream:
        stream.seek(-1, os.SEEK_END)
        return stream.read(1) != b"\n"
