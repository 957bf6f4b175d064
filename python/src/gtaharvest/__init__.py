"""Reads the sessions of GtaDataHarvester: images with labels, from GTA V or from its simulation.

open_session opens a folder. docs/python.md of the project has examples, docs/dataset-format.md the meaning of every field.
"""

from ._version import __version__
from .arrays import ObjectArrays
from .camera import Camera, Lens, Projection
from .drive import DRIVERS, Controls, Drive, DriveTarget, DriveTick, DriveTruth
from .errors import (
    LabelError,
    MissingPictureError,
    NewerFormatError,
    NotASessionError,
    NotInSessionError,
    PartialSessionError,
    PictureError,
    SessionError,
)
from .events import EVENT_KINDS, Contact, Event, EventMark, Participant
from .frame import (
    BIRDS_EYE_CLASS_NAMES,
    FLOW_COVERED,
    FLOW_INFINITE,
    FLOW_LEAVES_PICTURE,
    FLOW_MOVED,
    FLOW_PERSON,
    FLOW_UNKNOWN,
    FLOW_VALID,
    Frame,
    View,
)
from .lanes import INDICATOR_NAMES, Indicators, LaneLine, Lanes, VehicleInLane
from .points import POINT_TYPE
from .records import (
    CLASS_NAMES,
    JOINT_NAMES,
    SEMANTIC_CLASS_NAMES,
    Cuboid,
    Ego,
    Face,
    IgnoreRegion,
    Joint,
    Light,
    ObjectLabel,
    Pair,
    VehicleLights,
)
from .selection import Selection
from .session import FORMAT_VERSION, Session, Track, open_session

__all__ = [
    "BIRDS_EYE_CLASS_NAMES",
    "CLASS_NAMES",
    "Camera",
    "Contact",
    "Controls",
    "Cuboid",
    "DRIVERS",
    "Drive",
    "FLOW_COVERED",
    "FLOW_INFINITE",
    "FLOW_LEAVES_PICTURE",
    "FLOW_MOVED",
    "FLOW_PERSON",
    "FLOW_UNKNOWN",
    "FLOW_VALID",
    "DriveTarget",
    "DriveTick",
    "DriveTruth",
    "EVENT_KINDS",
    "Ego",
    "Event",
    "EventMark",
    "FORMAT_VERSION",
    "Face",
    "Frame",
    "INDICATOR_NAMES",
    "IgnoreRegion",
    "Indicators",
    "JOINT_NAMES",
    "Joint",
    "LabelError",
    "LaneLine",
    "Lanes",
    "Lens",
    "Light",
    "MissingPictureError",
    "NewerFormatError",
    "NotASessionError",
    "NotInSessionError",
    "ObjectArrays",
    "ObjectLabel",
    "POINT_TYPE",
    "Pair",
    "PartialSessionError",
    "Participant",
    "PictureError",
    "Projection",
    "SEMANTIC_CLASS_NAMES",
    "Selection",
    "Session",
    "SessionError",
    "Track",
    "VehicleInLane",
    "VehicleLights",
    "View",
    "__version__",
    "open_session",
]
