"""A frame of a session, and the views of its cameras."""

from __future__ import annotations

import functools
from pathlib import Path
from typing import TYPE_CHECKING, Any, Callable, Dict, Mapping, Optional, Tuple

import numpy as np

from .arrays import ObjectArrays
from .camera import Array, Camera
from .checks import checked, each, integer, number, one_line, optional, text
from .drive import Drive
from .errors import LabelError, MissingPictureError, NotInSessionError, SessionError
from .events import EventMark
from .gnss import gnss_rows
from .imu import imu_rows
from .lanes import Lanes
from .motion import motion_rows
from .picture_header import Picture
from .pictures import Depth, Size, read_class_map, read_depth, read_image, read_mask, read_vectors
from .points import Points, read_points
from .radar import radar_tables
from .records import Ego, IgnoreRegion, ObjectLabel, Pair
from .selection import Selection

if TYPE_CHECKING:
    import pandas

DEPTH_KINDS = ("sparse", "completed", "error")
"""The kinds of depth maps."""

FLOW_KINDS = ("backward", "forward")
"""The kinds of flow: from the pixels of the frame to the frame before, and from the pixels of that to this one."""

FLOW_VALID, FLOW_MOVED, FLOW_COVERED, FLOW_LEAVES_PICTURE, FLOW_PERSON, FLOW_UNKNOWN, FLOW_INFINITE = (
    1 << bit for bit in range(7)
)
"""The flags of flow_flags; docs/flow.md has their meaning."""

BIRDS_EYE_CLASS_NAMES = ("other", "drivable", "lane", "line", "crossing", "vehicle", "person")
"""The classes of bird's-eye maps, by their numbers."""

PICTURE_ENDINGS = (".png", ".jpg", ".jpeg", ".bmp")
"""How names of pictures end."""

_POINTS_ENDINGS = (".bin",)

ONLY_VIEW = "camera"
"""Name of the view of a session with a single camera."""


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
        return checked(self._source, lambda: Camera.from_json(self.raw["camera"]))

    @functools.cached_property
    def objects(self) -> Tuple[ObjectLabel, ...]:
        """The objects in the image, by ascending id."""
        return checked(self._source, lambda: each(ObjectLabel.from_json, self.raw["objects"]))

    @functools.cached_property
    def ignore_regions(self) -> Tuple[IgnoreRegion, ...]:
        """Regions that show, or may show, an object without a label; nearest first."""
        return checked(self._source, lambda: each(IgnoreRegion.from_json, self.raw.get("ignoreRegions", [])))

    def select(self, selection: Selection) -> Tuple[ObjectLabel, ...]:
        """The objects that pass a filter."""
        return tuple(filter(selection.takes, self.objects))

    def arrays(self, selection: Optional[Selection] = None) -> ObjectArrays:
        """The objects as arrays, all or those that pass a filter."""
        return ObjectArrays.of(self.objects if selection is None else self.select(selection))

    @property
    def image_name(self) -> str:
        """The file of the image, relative to the folder of the session."""
        return checked(self._source, lambda: text(self.raw["image"]))

    @property
    def image_path(self) -> Path:
        """The file of the image."""
        return self.inner(self.image_name)

    @property
    def mask_path(self) -> Optional[Path]:
        """The file of the instance mask; None if the frame has none."""
        name = checked(self._source, lambda: optional(text, self.raw.get("mask")))
        return None if name is None else self.inner(name)

    @property
    def size(self) -> Size:
        """Width and height of the pictures, pixels."""
        return self.camera.width, self.camera.height

    def image(self) -> Picture:
        """The image as (height, width, 3), uint8, red first.

        Raises MissingPictureError if the file does not exist, and PictureError if it cannot be decoded or has another size.
        """
        return read_image(self.image_path, self.size)

    def mask(self) -> Picture:
        """The instance mask as (height, width), uint16: the id of the object visible at each pixel, or 0.

        Raises MissingPictureError if the frame has no mask or the file does not exist, and PictureError as image does.
        """
        path = self.mask_path
        if path is None:
            raise MissingPictureError(
                f"{self._source}: the frame has no mask. Harvest with --masks, or see harvester masks import."
            )
        return read_mask(path, self.size)

    @property
    def class_map_path(self) -> Optional[Path]:
        """The file of the class map; None if the frame has none."""
        name = checked(self._source, lambda: optional(lambda part: text(part["file"]), self.raw.get("classMap")))
        return None if name is None else self.inner(name)

    def class_map(self) -> Picture:
        """The class map as (height, width), uint8: the place in SEMANTIC_CLASS_NAMES of the class visible at each pixel.

        Raises MissingPictureError if the frame has no class map or the file does not exist, and PictureError as image does.
        """
        path = self.class_map_path
        if path is None:
            raise MissingPictureError(f"{self._source}: the frame has no class map. Harvest with --semantics.")
        return read_class_map(path, self.size)

    def depth_path(self, kind: str = "sparse") -> Optional[Path]:
        """The file of a depth map: "sparse", what rays measured; "completed", every pixel; "error", its estimated error.

        None if the frame has none.
        """
        if kind not in DEPTH_KINDS:
            raise ValueError(f"kind is one of {', '.join(DEPTH_KINDS)}, not {kind!r}.")
        name = checked(self._source, lambda: optional(lambda part: optional(text, part[kind]), self.raw.get("depth")))
        return None if name is None else self.inner(name)

    def depth(self, kind: str = "sparse") -> Depth:
        """A depth map as (height, width), float32: metres along the camera's axis, or NaN where there is none. kind as in depth_path.

        Raises MissingPictureError if the frame has no such map or the file does not exist, and PictureError as image does.
        """
        path = self.depth_path(kind)
        if path is None:
            raise MissingPictureError(
                f"{self._source}: the frame has no {kind} depth. Harvest with --depth and --masks."
            )
        return read_depth(path, self.size)

    @property
    def normals_path(self) -> Optional[Path]:
        """The file of the map of normals; None if the frame has none."""
        name = checked(self._source, lambda: optional(lambda part: text(part["file"]), self.raw.get("normals")))
        return None if name is None else self.inner(name)

    def normals(self) -> Depth:
        """The normals of the surfaces as (height, width, 3), float32: unit vectors right, down and forward, or NaN where nothing is seen.

        They point to the camera's side. Raises MissingPictureError if the frame has no map of normals or the file does not exist, and
        PictureError as image does.
        """
        path = self.normals_path
        if path is None:
            raise MissingPictureError(f"{self._source}: the frame has no map of normals. Harvest with --normals.")
        coded = read_image(path, self.size)
        vectors: Depth = (coded.astype(np.float32) - np.float32(128)) / np.float32(127)
        vectors /= np.linalg.norm(vectors, axis=-1, keepdims=True)
        vectors[~coded.any(axis=-1)] = np.nan
        return vectors

    @property
    def flow_from(self) -> Optional[int]:
        """Number of the frame before, to which the flow leads; None if the frame has no flow, as the first of a place."""
        return checked(self._source, lambda: optional(lambda part: integer(part["from"]), self.raw.get("flow")))

    def flow(self, kind: str = "backward") -> Depth:
        """The optical flow as (height, width, 2), float32: pixels to the right and down, or NaN where it is not known.

        kind: "backward", from the pixels of this frame to the frame before; "forward", from the pixels of that to this one. Raises
        MissingPictureError if the frame has no flow or the file does not exist, and PictureError as image does.
        """
        stored = read_vectors(self._flow_path(_flow_kind(kind)), self.size)
        flow: Depth = (stored[..., :2].astype(np.float32) - np.float32(32768)) / np.float32(64)
        flow[stored[..., 2] == 0] = np.nan
        return flow

    def flow_flags(self, kind: str = "backward") -> Picture:
        """What is known of the flow of each pixel as (height, width), uint8: a sum of FLOW_VALID and others. kind and errors as in flow."""
        return read_class_map(self._flow_path(_flow_kind(kind) + "Flags"), self.size)

    def surface_motion(self) -> Depth:
        """How far the surfaces have moved in the world since the frame before, as (height, width, 3), float32.

        Metres to the camera's right, down and forward, or NaN where it is not known. Errors as in flow.
        """
        stored = read_vectors(self._flow_path("motion"), self.size)
        motion: Depth = (stored.astype(np.float32) - np.float32(32768)) / np.float32(1000)
        motion[~stored.any(axis=-1)] = np.nan
        return motion

    @property
    def birds_eye_cell_metres(self) -> Optional[float]:
        """Side of a cell of the bird's-eye map, metres; None if the frame has none."""
        return checked(
            self._source, lambda: optional(lambda part: number(part["cellMetres"]), self.raw.get("birdsEye"))
        )

    def birds_eye(self) -> Picture:
        """What the ground around the ego is, as (cells, cells), uint8: the place of each cell's class in BIRDS_EYE_CLASS_NAMES.

        The ego is in the middle and faces up: row 0 is the farthest ahead, column 0 the farthest to its left. Raises MissingPictureError
        if the frame has no such map or the file does not exist, and PictureError as image does.
        """
        return self._birds_eye("file")

    def birds_eye_visible(self) -> Picture:
        """Which cells of birds_eye the camera sees, as (cells, cells), bool. Errors as in birds_eye; GTA V has no such map."""
        seen: Picture = self._birds_eye("visible") != 0
        return seen

    def _birds_eye(self, kind: str) -> Picture:
        def found(part: Any) -> Optional[Tuple[str, int]]:
            name = optional(text, part[kind])
            return None if name is None else (name, integer(part["cells"]))

        map = checked(self._source, lambda: optional(found, self.raw.get("birdsEye")))
        if map is None:
            raise MissingPictureError(
                f"{self._source}: the frame has no bird's-eye map ({kind}). Harvest with --birds-eye."
            )
        name, cells = map
        return read_class_map(self.inner(name), (cells, cells))

    def occupancy(self) -> Picture:
        """The voxels around the ego as (layers, cells, cells), uint8: 0 free, 255 enclosed by surfaces, or the class of a surface.

        Layers from below; in each, row 0 is the farthest ahead and column 0 the farthest to the left. Raises MissingPictureError if the
        frame has none or a file does not exist, and PictureError as image does.
        """
        name, shape = self._occupancy("file")
        stored: Picture = read_class_map(self.inner(name), (shape[2], shape[0] * shape[1])).reshape(shape)
        return stored

    def occupancy_instances(self) -> Picture:
        """The ids of the objects in the voxels of occupancy, as (layers, cells, cells), uint16; 0 for none. Errors as in occupancy."""
        name, shape = self._occupancy("instances")
        stored: Picture = read_mask(self.inner(name), (shape[2], shape[0] * shape[1])).reshape(shape)
        return stored

    def occupancy_visible(self) -> Picture:
        """Which voxels of occupancy the camera sees, as (layers, cells, cells), bool. Errors as in occupancy."""
        name, shape = self._occupancy("visible")
        seen: Picture = read_class_map(self.inner(name), (shape[2], shape[0] * shape[1])).reshape(shape) != 0
        return seen

    def _occupancy(self, kind: str) -> Tuple[str, Tuple[int, int, int]]:
        def found(part: Any) -> Tuple[str, Tuple[int, int, int]]:
            cells = integer(part["cells"])
            return text(part[kind]), (integer(part["layers"]), cells, cells)

        map = checked(self._source, lambda: optional(found, self.raw.get("occupancy")))
        if map is None:
            raise MissingPictureError(f"{self._source}: the frame has no voxels. Harvest with --occupancy.")
        return map

    def _flow_path(self, kind: str) -> Path:
        name = checked(self._source, lambda: optional(lambda part: text(part[kind]), self.raw.get("flow")))
        if name is None:
            raise MissingPictureError(
                f"{self._source}: the frame has no flow. Harvest with --flow; the first frame of a place never has one."
            )
        return self.inner(name)

    def inner(self, name: str, endings: Tuple[str, ...] = PICTURE_ENDINGS) -> Path:
        """The path of a file of the session. A label of somebody else must not open files elsewhere."""
        shown = f"{self._source}: '{one_line(name)}'"
        if not name.endswith(endings):
            raise LabelError(f"{shown} does not end in {' or '.join(endings)}.")
        if not name.isprintable() or Path(name).is_absolute() or ".." in Path(name).parts:
            raise LabelError(f"{shown} is outside the session.")
        try:
            path = (self._folder / name).resolve()
        except (OSError, RuntimeError):
            raise LabelError(f"{shown} cannot be followed; its links may go in circles.") from None
        if self._folder not in path.parents:
            raise LabelError(f"{shown} is outside the session.")
        return path

    def __repr__(self) -> str:
        return _shown(
            lambda: f"View({self.name!r}, frame {self.frame}, {self.size[0]}x{self.size[1]}, {len(self.objects)} objects)",
            self._source,
        )


def _flow_kind(kind: str) -> str:
    if kind not in FLOW_KINDS:
        raise ValueError(f"kind is one of {', '.join(FLOW_KINDS)}, not {kind!r}.")
    return kind


def _shown(describe: Callable[[], str], source: str) -> str:
    """A text for repr, which does not fail for a damaged label."""
    try:
        return describe()
    except SessionError:
        return f"<damaged label: {source}>"


class Frame:
    """One label line of a session: a moment, or one view of it with a rig. raw: the label line as parsed JSON."""

    def __init__(self, raw: Mapping[str, Any], folder: Path, source: str) -> None:
        self.raw = raw
        self._folder = folder
        self._source = source

    def __repr__(self) -> str:
        return _shown(
            lambda: (
                f"Frame({self.number}, {self.time_seconds:g} s, {self.weather} {self.time_of_day}, view {self.view_name!r}, "
                f"{len(self.objects)} objects)"
            ),
            self._source,
        )

    @property
    def number(self) -> int:
        """Number of the frame."""
        return checked(self._source, lambda: integer(self.raw["frame"]))

    @property
    def time_seconds(self) -> float:
        """Game time, seconds."""
        return checked(self._source, lambda: number(self.raw["timeSeconds"]))

    @property
    def weather(self) -> str:
        """The game's name of the weather, in lower case."""
        return checked(self._source, lambda: text(self.raw["environment"]["weather"]))

    @property
    def time_of_day(self) -> str:
        """Time of day in the game, as 18:30:00."""
        return checked(self._source, lambda: text(self.raw["environment"]["timeOfDay"]))

    @functools.cached_property
    def ego(self) -> Ego:
        """The vehicle that carries the camera."""
        return checked(self._source, lambda: Ego.from_json(self.raw["ego"]))

    @functools.cached_property
    def lanes(self) -> Optional[Lanes]:
        """The lanes around the car; None if no roads are known."""
        return checked(self._source, lambda: Lanes.from_json(self.raw["lanes"]) if "lanes" in self.raw else None)

    @property
    def moment(self) -> Optional[int]:
        """Number of the moment of a rig, which has a frame for each camera; None in a session with a single camera."""
        return checked(self._source, lambda: integer(self.raw["moment"]) if "moment" in self.raw else None)

    @property
    def view_name(self) -> str:
        """Name of the view: that of a camera of the rig, or ONLY_VIEW."""
        return checked(self._source, lambda: text(self.raw.get("view", ONLY_VIEW)))

    @functools.cached_property
    def views(self) -> Dict[str, View]:
        """The view by name. Each view of a rig is a frame of its own; Session.moments has those of a moment together."""
        return {self.view_name: View(self.view_name, self.number, self.raw, self._folder, self._source)}

    @functools.cached_property
    def lidars(self) -> Dict[str, Path]:
        """The files of the LiDARs by name; empty in all but the first view of a moment."""
        names = checked(
            self._source,
            lambda: each(lambda lidar: (text(lidar["sensor"]), text(lidar["file"])), self.raw.get("lidar", [])),
        )
        return {sensor: self.view.inner(name, _POINTS_ENDINGS) for sensor, name in names}

    @functools.cached_property
    def pairs(self) -> Tuple[Pair, ...]:
        """Further pictures of the moment, in other weathers, at other hours and without objects; empty if there are none."""
        return checked(self._source, lambda: each(Pair.from_json, self.raw.get("pairs", [])))

    def pair_image(self, pair: Pair) -> Picture:
        """A further picture of the moment as (height, width, 3), uint8, red first.

        Raises MissingPictureError if the harvest dropped it or the file does not exist, and PictureError as image does.
        """
        if pair.file is None:
            raise MissingPictureError(f"{self._source}: the picture was dropped during the harvest: {pair.dropped}.")
        path = self.view.inner(pair.file)
        return read_image(path, self.view.size)

    def points(self, sensor: str) -> Points:
        """The points of a LiDAR as a structured array with the fields of POINT_TYPE.

        Raises NotInSessionError if the frame has no such LiDAR, and PictureError if the file cannot be read.
        """
        if sensor not in self.lidars:
            names = ", ".join(map(one_line, self.lidars)) or "none"
            raise NotInSessionError(f"{self._source}: the frame has no LiDAR {sensor!r}; its LiDARs: {names}.")
        return read_points(self.lidars[sensor])

    @functools.cached_property
    def motion(self) -> Optional[Array]:
        """The ego at the ticks since the frame before, (ticks, 18); None if motion is not recorded.

        A row has time, position (3), right (3), forward (3), velocity (3), yaw rate, acceleration, steering, throttle and brake; NaN for
        what is unknown.
        """
        return checked(self._source, lambda: motion_rows(self.raw["motion"]) if "motion" in self.raw else None)

    @functools.cached_property
    def radars(self) -> Dict[str, Array]:
        """The detections of each radar of the rig by its name, (detections, 8); empty without a radar.

        A row has range, azimuth and elevation (degrees, to the left and up), radial velocity, ground velocity, cross-section (dB above
        1 m²), object id and origin (0 target, 1 ghost, 2 clutter).
        """
        return checked(self._source, lambda: radar_tables(self.raw.get("radar", [])))

    @functools.cached_property
    def imu(self) -> Optional[Array]:
        """What the inertial unit measured since the frame before, (samples, 7); None if the session has none.

        A row has time, angular rate (3, rad/s) and specific force (3, m/s²), both along the vehicle's right, forward and up.
        """
        return checked(self._source, lambda: imu_rows(self.raw["imu"]) if "imu" in self.raw else None)

    @functools.cached_property
    def gnss(self) -> Optional[Array]:
        """What the satellite receiver reported since the frame before, (samples, 7); None if the session has none.

        A row has time, latitude and longitude (degrees), altitude (metres) and velocity (3, m/s, east, north and up).
        """
        return checked(self._source, lambda: gnss_rows(self.raw["gnss"]) if "gnss" in self.raw else None)

    @functools.cached_property
    def events(self) -> Optional[Tuple[EventMark, ...]]:
        """The events that are open at the moment, by ascending id; None if events are not recorded."""
        return checked(
            self._source, lambda: each(EventMark.from_json, self.raw["events"]) if "events" in self.raw else None
        )

    @functools.cached_property
    def drive(self) -> Optional[Drive]:
        """The action that belongs to the frame; None unless the session is a recorded drive."""
        return checked(self._source, lambda: Drive.from_json(self.raw["drive"]) if "drive" in self.raw else None)

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

    def normals(self) -> Depth:
        """The map of normals of the only view; see View.normals."""
        return self.view.normals()

    @property
    def flow_from(self) -> Optional[int]:
        """Number of the frame before of the only view; see View.flow_from."""
        return self.view.flow_from

    def flow(self, kind: str = "backward") -> Depth:
        """The optical flow of the only view; see View.flow."""
        return self.view.flow(kind)

    def flow_flags(self, kind: str = "backward") -> Picture:
        """What is known of the flow of the only view; see View.flow_flags."""
        return self.view.flow_flags(kind)

    def surface_motion(self) -> Depth:
        """The motion of the surfaces of the only view; see View.surface_motion."""
        return self.view.surface_motion()

    @property
    def birds_eye_cell_metres(self) -> Optional[float]:
        """Side of a cell of the bird's-eye map of the only view; see View.birds_eye_cell_metres."""
        return self.view.birds_eye_cell_metres

    def birds_eye(self) -> Picture:
        """The bird's-eye map of the only view; see View.birds_eye."""
        return self.view.birds_eye()

    def occupancy(self) -> Picture:
        """The voxels of the only view; see View.occupancy."""
        return self.view.occupancy()

    def occupancy_instances(self) -> Picture:
        """The ids of the objects in the voxels of the only view; see View.occupancy_instances."""
        return self.view.occupancy_instances()

    def occupancy_visible(self) -> Picture:
        """The voxels that the camera of the only view sees; see View.occupancy_visible."""
        return self.view.occupancy_visible()

    def birds_eye_visible(self) -> Picture:
        """The cells that the camera of the only view sees; see View.birds_eye_visible."""
        return self.view.birds_eye_visible()

    def to_pandas(self, selection: Optional[Selection] = None) -> pandas.DataFrame:
        """A table with one row per object; see Session.to_pandas."""
        from .tables import table_of

        return table_of([self], selection)
