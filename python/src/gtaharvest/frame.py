"""A frame of a session, and the views of its cameras."""

from __future__ import annotations

import functools
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, Dict, Mapping, Optional, Tuple, TypeVar

from .arrays import ObjectArrays
from .camera import Array, Camera
from .drive import Drive
from .errors import LabelError, MissingPictureError, PictureError
from .lanes import Lanes
from .motion import motion_rows
from .pictures import Depth, read_class_map, read_depth, read_image, read_mask
from .png import Picture
from .points import Points, read_points
from .records import Ego, IgnoreRegion, ObjectLabel, Pair
from .selection import Selection

if TYPE_CHECKING:
    import pandas

_T = TypeVar("_T")

DEPTH_KINDS = ("sparse", "completed", "error")
"""The kinds of depth maps."""

ONLY_VIEW = "camera"
"""Name of the view of a session with a single camera."""


def _checked(source: str, read: Callable[[], _T]) -> _T:
    """Reads part of a label; what is missing or of another type becomes a LabelError."""
    try:
        return read()
    except KeyError as missing:
        raise LabelError(f"{source}: the field {missing.args[0]!r} is missing. Run harvester validate.") from None
    except (TypeError, IndexError, ValueError) as problem:
        raise LabelError(f"{source}: a field has the wrong type ({problem}). Run harvester validate.") from None


class View:
    """What one camera shows in a frame. Pictures and records are read when they are asked for.

    name: of the view. frame: number of the frame. raw: the view's part of the label line as parsed JSON.
    """

    def __init__(self, name: str, frame: int, raw: Mapping[str, Any], folder: Path, source: str) -> None:
        self.name = name
        self.frame = frame
        self.raw = raw
        self._folder = folder
        self._source = source

    @functools.cached_property
    def camera(self) -> Camera:
        """The camera, with the lens."""
        return _checked(self._source, lambda: Camera.from_json(self.raw["camera"]))

    @functools.cached_property
    def objects(self) -> Tuple[ObjectLabel, ...]:
        """The objects in the image, by ascending id."""
        return _checked(self._source, lambda: tuple(map(ObjectLabel.from_json, self.raw["objects"])))

    @functools.cached_property
    def ignore_regions(self) -> Tuple[IgnoreRegion, ...]:
        """Regions that show, or may show, an object without a label; nearest first."""
        return _checked(self._source, lambda: tuple(map(IgnoreRegion.from_json, self.raw.get("ignoreRegions", ()))))

    def select(self, selection: Selection) -> Tuple[ObjectLabel, ...]:
        """The objects that pass a filter."""
        return tuple(filter(selection.takes, self.objects))

    def arrays(self, selection: Optional[Selection] = None) -> ObjectArrays:
        """The objects as arrays, all or those that pass a filter."""
        return ObjectArrays.of(self.objects if selection is None else self.select(selection))

    @property
    def image_path(self) -> Path:
        """The file of the image."""
        return self.inner(_checked(self._source, lambda: str(self.raw["image"])))

    @property
    def mask_path(self) -> Optional[Path]:
        """The file of the instance mask; None if the frame has none."""
        mask = self.raw.get("mask")
        return None if mask is None else self.inner(str(mask))

    def image(self) -> Picture:
        """The image as (height, width, 3), uint8, red first.

        Raises MissingPictureError if the file does not exist, and PictureError if it cannot be decoded or has another size.
        """
        path = self.image_path
        return self.sized(path, read_image(path))

    def mask(self) -> Picture:
        """The instance mask as (height, width), uint16: the id of the object visible at each pixel, or 0.

        Raises MissingPictureError if the frame has no mask or the file does not exist, and PictureError as image does.
        """
        path = self.mask_path
        if path is None:
            raise MissingPictureError(f"{self._source}: the frame has no mask. Harvest with --masks, or see harvester masks import.")
        return self.sized(path, read_mask(path))

    @property
    def class_map_path(self) -> Optional[Path]:
        """The file of the class map; None if the frame has none."""
        if self.raw.get("classMap") is None:
            return None
        return self.inner(_checked(self._source, lambda: str(self.raw["classMap"]["file"])))

    def class_map(self) -> Picture:
        """The class map as (height, width), uint8: the place in SEMANTIC_CLASS_NAMES of the class visible at each pixel.

        Raises MissingPictureError if the frame has no class map or the file does not exist, and PictureError as image does.
        """
        path = self.class_map_path
        if path is None:
            raise MissingPictureError(f"{self._source}: the frame has no class map. Harvest with --semantics.")
        return self.sized(path, read_class_map(path))

    def depth_path(self, kind: str = "sparse") -> Optional[Path]:
        """The file of a depth map: "sparse", what rays measured; "completed", every pixel; "error", its estimated error.

        None if the frame has none.
        """
        if kind not in DEPTH_KINDS:
            raise ValueError(f"kind is one of {', '.join(DEPTH_KINDS)}, not {kind!r}.")
        if self.raw.get("depth") is None:
            return None
        name = _checked(self._source, lambda: str(self.raw["depth"][kind] or ""))
        return self.inner(name) if name else None

    def depth(self, kind: str = "sparse") -> Depth:
        """A depth map as (height, width), float32: metres along the camera's axis, or NaN where there is none. kind as in depth_path.

        Raises MissingPictureError if the frame has no such map or the file does not exist, and PictureError as image does.
        """
        path = self.depth_path(kind)
        if path is None:
            raise MissingPictureError(f"{self._source}: the frame has no {kind} depth. Harvest with --depth and --masks.")
        return self.sized(path, read_depth(path))

    def sized(self, path: Path, picture: Picture) -> Picture:
        """A picture of the view. Raises PictureError if it has another size than the label says."""
        size = (self.camera.height, self.camera.width)
        if picture.shape[:2] != size:
            shape = f"{picture.shape[1]}x{picture.shape[0]}"
            raise PictureError(f"{path}: the picture has {shape} pixels; its label says {size[1]}x{size[0]}.")
        return picture

    def inner(self, name: str) -> Path:
        """The path of a file of the session. A label of somebody else must not open files elsewhere."""
        path = (self._folder / name).resolve()
        if self._folder not in path.parents:
            raise LabelError(f"{self._source}: '{name}' is outside the session.")
        return path


class Frame:
    """One label line of a session: a moment, or one view of it with a rig. raw: the label line as parsed JSON."""

    def __init__(self, raw: Mapping[str, Any], folder: Path, source: str) -> None:
        self.raw = raw
        self._folder = folder
        self._source = source

    @property
    def number(self) -> int:
        """Number of the frame."""
        return _checked(self._source, lambda: int(self.raw["frame"]))

    @property
    def time_seconds(self) -> float:
        """Game time, seconds."""
        return _checked(self._source, lambda: float(self.raw["timeSeconds"]))

    @property
    def weather(self) -> str:
        """The game's name of the weather, in lower case."""
        return _checked(self._source, lambda: str(self.raw["environment"]["weather"]))

    @property
    def time_of_day(self) -> str:
        """Time of day in the game, as 18:30:00."""
        return _checked(self._source, lambda: str(self.raw["environment"]["timeOfDay"]))

    @functools.cached_property
    def ego(self) -> Ego:
        """The vehicle that carries the camera."""
        return _checked(self._source, lambda: Ego.from_json(self.raw["ego"]))

    @functools.cached_property
    def lanes(self) -> Optional[Lanes]:
        """The lanes around the car; None if no roads are known."""
        return _checked(self._source, lambda: Lanes.from_json(self.raw["lanes"]) if "lanes" in self.raw else None)

    @property
    def moment(self) -> Optional[int]:
        """Number of the moment of a rig, which has a frame for each camera; None in a session with a single camera."""
        return _checked(self._source, lambda: int(self.raw["moment"]) if "moment" in self.raw else None)

    @property
    def view_name(self) -> str:
        """Name of the view: that of a camera of the rig, or ONLY_VIEW."""
        return str(self.raw.get("view", ONLY_VIEW))

    @functools.cached_property
    def views(self) -> Dict[str, View]:
        """The view by name. Each view of a rig is a frame of its own; Session.moments has those of a moment together."""
        return {self.view_name: View(self.view_name, self.number, self.raw, self._folder, self._source)}

    @functools.cached_property
    def lidars(self) -> Dict[str, Path]:
        """The files of the LiDARs by name; empty in all but the first view of a moment."""
        return _checked(
            self._source, lambda: {str(each["sensor"]): self.view.inner(str(each["file"])) for each in self.raw.get("lidar", ())})

    @functools.cached_property
    def pairs(self) -> Tuple[Pair, ...]:
        """Further pictures of the moment, in other weathers, at other hours and without objects; empty if there are none."""
        return _checked(self._source, lambda: tuple(map(Pair.from_json, self.raw.get("pairs", ()))))

    def pair_image(self, pair: Pair) -> Picture:
        """A further picture of the moment as (height, width, 3), uint8, red first.

        Raises MissingPictureError if the harvest dropped it or the file does not exist, and PictureError as image does.
        """
        if pair.file is None:
            raise MissingPictureError(f"{self._source}: the picture was dropped during the harvest: {pair.dropped}.")
        path = self.view.inner(pair.file)
        return self.view.sized(path, read_image(path))

    def points(self, sensor: str) -> Points:
        """The points of a LiDAR as a structured array with the fields of POINT_TYPE.

        Raises KeyError if the frame has no such LiDAR, and PictureError if the file cannot be read.
        """
        return read_points(self.lidars[sensor])

    @functools.cached_property
    def motion(self) -> Optional[Array]:
        """The ego at the ticks since the frame before, (ticks, 18); None if motion is not recorded.

        A row has time, position (3), right (3), forward (3), velocity (3), yaw rate, acceleration, steering, throttle and brake; NaN for
        what is unknown.
        """
        return _checked(self._source, lambda: motion_rows(self.raw["motion"]) if "motion" in self.raw else None)

    @functools.cached_property
    def drive(self) -> Optional[Drive]:
        """The action that belongs to the frame; None unless the session is a recorded drive."""
        return _checked(self._source, lambda: Drive.from_json(self.raw["drive"]) if "drive" in self.raw else None)

    @property
    def view(self) -> View:
        """The view of a frame with a single camera."""
        (only,) = self.views.values()
        return only

    @property
    def camera(self) -> Camera:
        """The camera of the only view."""
        return self.view.camera

    @property
    def objects(self) -> Tuple[ObjectLabel, ...]:
        """The objects of the only view."""
        return self.view.objects

    def image(self) -> Picture:
        """The image of the only view; see View.image."""
        return self.view.image()

    def mask(self) -> Picture:
        """The instance mask of the only view; see View.mask."""
        return self.view.mask()

    def class_map(self) -> Picture:
        """The class map of the only view; see View.class_map."""
        return self.view.class_map()

    def depth(self, kind: str = "sparse") -> Depth:
        """A depth map of the only view; see View.depth."""
        return self.view.depth(kind)

    def to_pandas(self, selection: Optional[Selection] = None) -> pandas.DataFrame:
        """A table with one row per object; see Session.to_pandas."""
        from .tables import table_of

        return table_of([self], selection)
