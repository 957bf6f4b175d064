"""Opens the folder of a session."""

from __future__ import annotations

import functools
import io
import itertools
import os
import re
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, Dict, Iterator, List, Mapping, Optional, Tuple, TypeVar, Union

import numpy as np
import numpy.typing as npt

from .camera import Array, Camera
from .checks import checked, each, one_line, text
from .errors import LabelError, NewerFormatError, NotASessionError, NotInSessionError, PartialSessionError
from .events import Event
from .files import open_regular, read_regular
from .frame import ONLY_VIEW, Frame
from .index import LineIndex
from .json_object import parse_object
from .label_line import LabelLine
from .records import ObjectLabel
from .selection import Selection

if TYPE_CHECKING:
    import pandas

_T = TypeVar("_T")

FORMAT_VERSION = 1
"""The newest version of the format that this package reads."""

_UNFINISHED_MARK = ".harvester-unfinished"
_MAX_HEADER_BYTES = 16 * 1024 * 1024
_MAX_EVENT_BYTES = 1024 * 1024


@dataclass(frozen=True, repr=False)
class Track:
    """One object through the frames of a session. frames and times_seconds belong to the labels at the same index."""

    id: int
    frames: Tuple[int, ...]
    times_seconds: Tuple[float, ...]
    labels: Tuple[ObjectLabel, ...]

    def __repr__(self) -> str:
        return f"Track({self.id}, {self.class_name!r}, {len(self.frames)} frames from {self.frames[0]} to {self.frames[-1]})"

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
        return self._of_info(lambda info: each(text, info.get("classes", [])))

    @property
    def camera(self) -> Optional[Camera]:
        """The camera at the start; each frame has its own. None in a repaired session that has lost it."""
        return self._of_info(lambda info: Camera.from_json(info["camera"]) if "camera" in info else None)

    @property
    def state(self) -> str:
        """recording, complete or faulted."""
        return self._of_info(lambda info: text(info["state"]))

    @property
    def view_names(self) -> Tuple[str, ...]:
        """The cameras of the rig, in the order of their frames; ONLY_VIEW in a session with a single camera."""
        return self._of_info(
            lambda info: each(lambda camera: text(camera["name"]), info["rig"]["cameras"])
            if "rig" in info
            else (ONLY_VIEW,)
        )

    def _of_info(self, read: Callable[[Mapping[str, Any]], _T]) -> _T:
        return checked(str(self.folder / "session.json"), lambda: read(self.info), NotASessionError)

    def moments(self) -> Iterator[Dict[str, Frame]]:
        """The frames of each moment by the names of their views. A repaired session may lack some."""
        for _, frames in itertools.groupby(self, lambda frame: frame.number if frame.moment is None else frame.moment):
            yield {frame.view_name: frame for frame in frames}

    @functools.cached_property
    def _index(self) -> LineIndex:
        path = self.folder / "labels.jsonl"
        try:
            return LineIndex(path, self.folder / "manifest.jsonl")
        except OSError as problem:
            raise LabelError(f"{path}: the labels cannot be read: {problem.strerror}.") from None
        except ValueError as problem:
            raise LabelError(f"{path}: {problem}.") from None

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

        Raises NotInSessionError if the session does not have it.
        """
        if 0 <= number < len(self) and self[number].number == number:
            return self[number]
        found = np.flatnonzero(self._numbers == number)
        if len(found) == 0:
            has = (
                f"its {len(self)} frames have the numbers {self._numbers.min()} to {self._numbers.max()}"
                if len(self)
                else "it has none"
            )
            raise NotInSessionError(f"{self.folder}: the session has no frame {number}; {has}.")
        return self[int(found[0])]

    @functools.cached_property
    def _numbers(self) -> npt.NDArray[np.int64]:
        return np.fromiter((frame.number for frame in self), np.int64, len(self))

    def events(self) -> Iterator[Event]:
        """The events in the order in which they ended; none if events were not recorded. An unfinished last line is left out."""
        path = self.folder / "events.jsonl"
        try:
            stream = io.BufferedReader(open_regular(path))  # type: ignore[arg-type]
        except FileNotFoundError:
            return
        except OSError as problem:
            raise LabelError(f"{path}: the events cannot be read: {problem.strerror}.") from None
        with stream:
            number = 0
            while True:
                line = stream.readline(_MAX_EVENT_BYTES)
                number += 1
                if not line.endswith(b"\n"):
                    if len(line) == _MAX_EVENT_BYTES:
                        raise LabelError(f"{path}, line {number}: it is longer than {_MAX_EVENT_BYTES} bytes.")
                    return
                source = f"{path}, line {number}"
                try:
                    value = parse_object(line)
                except ValueError as problem:
                    raise LabelError(f"{source}: it is not a JSON object ({one_line(problem)}).") from None
                yield checked(source, lambda: Event.from_json(value))

    def track(self, id: int) -> Track:
        """The object with an id, in all frames that show it. Reads the whole label file.

        Raises NotInSessionError if no frame shows it.
        """
        # Vehicles in lanes have the same key, so some of these frames may not have the object.
        pattern = re.compile(rb'"id"\s*:\s*%d\b' % id)
        found = self._tracks((self._read(i) for i in range(len(self)) if pattern.search(self._line(i))), only=id)
        if not found:
            raise NotInSessionError(f"{self.folder}: no frame of the session shows an object {id}.")
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
        source = self._source(position)
        return Frame(LabelLine(self._line(position), source), self.folder, source)

    def _line(self, position: int) -> bytes:
        try:
            return self._index.line(position)
        except OSError as problem:
            raise LabelError(f"{self._source(position)}: it cannot be read: {problem.strerror}.") from None
        except ValueError as problem:
            raise LabelError(f"{self._source(position)}: {problem}.") from None

    def _source(self, position: int) -> str:
        return f"{self.folder / 'labels.jsonl'}, line {position + 1}"


def open_session(folder: Union[str, os.PathLike[str]], allow_partial: bool = False) -> Session:
    """Opens the folder of a session.

    allow_partial: also open a session whose recording or last line was cut off, or that is still recorded; the frames whose lines are
    complete are read.

    Raises NotASessionError, NewerFormatError and PartialSessionError.
    """
    try:
        path = Path(folder).resolve()
        is_folder = path.is_dir()
    except (OSError, RuntimeError, ValueError) as problem:
        raise NotASessionError(f"{one_line(folder)}: it cannot be opened: {one_line(problem)}.") from None
    header = path / "session.json"
    if not is_folder:
        raise NotASessionError(f"{path}: the folder does not exist.")
    try:
        info = parse_object(read_regular(header, _MAX_HEADER_BYTES))
    except FileNotFoundError:
        raise NotASessionError(f"{path}: it is not a session; it has no session.json.") from None
    except OSError as problem:
        raise NotASessionError(f"{header}: it cannot be read: {problem.strerror}.") from None
    except ValueError as problem:
        raise NotASessionError(
            f"{header}: it is not a JSON object ({one_line(problem)}). Run harvester repair."
        ) from None
    version = info.get("formatVersion")
    if type(version) is not int:
        raise NotASessionError(f"{header}: it has no formatVersion.")
    if version > FORMAT_VERSION:
        raise NewerFormatError(
            f"{header}: the session has format version {version}; this gtaharvest reads up to {FORMAT_VERSION}. Install a newer one."
        )
    if not allow_partial and (info.get("state") == "recording" or os.path.lexists(path / _UNFINISHED_MARK)):
        raise PartialSessionError(
            f"{path}: the recording of the session is unfinished. Finish it with the same command, or open it with allow_partial=True."
        )
    if not allow_partial and _ends_in_part_of_a_line(path / "labels.jsonl"):
        raise PartialSessionError(
            f"{path / 'labels.jsonl'}: its last line is cut off. Run harvester repair, or open the session with allow_partial=True."
        )
    return Session(path, info)


def _ends_in_part_of_a_line(path: Path) -> bool:
    try:
        with open_regular(path) as stream:
            if stream.seek(0, os.SEEK_END) == 0:
                return False
            stream.seek(-1, os.SEEK_END)
            return stream.read(1) != b"\n"
    except FileNotFoundError:
        return False
    except OSError as problem:
        raise NotASessionError(f"{path}: the labels cannot be read: {problem.strerror}.") from None
