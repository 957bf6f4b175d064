"""A session that has, by hand, every field that the package reads."""

from __future__ import annotations

import copy
import struct
from pathlib import Path
from typing import Any, Dict, Iterator, List, Tuple

import numpy as np
from conftest import HEIGHT, WIDTH, HandmadeSession
from test_drive import ACTION

import gtaharvest
from gtaharvest import Selection, draw, png

_NUMBERS = {name: float(i) for i, name in enumerate(gtaharvest.INDICATOR_NAMES)}
_FLAGS = {name: i % 2 == 0 for i, name in enumerate(gtaharvest.INDICATOR_NAMES)}
_LINE = {
    "index": 0,
    "side": "left",
    "points": [[0, 1, 2]],
    "inCamera": [[3, 4, 5]],
    "pixels": [[6, 7]],
    "hidden": [None],
    "style": "solid",
    "colour": "white",
    "widthMetres": 0.15,
    "painted": [True],
}
_MEASURED = {**_LINE, "source": "paint", "sigmaMetres": 0.02}
_LANES: Dict[str, Any] = {
    "status": "known",
    "source": "simulation",
    "confidence": 1,
    "inJunction": False,
    "laneCount": 2,
    "lane": 0,
    "laneWidthMetres": 4,
    "laneWidthSource": "constant",
    "offsetFromLaneCentreMetres": 0.5,
    "lookAheadMetres": 10,
    "curvaturePerMetre": 0,
    "fast": False,
    "indicators": _NUMBERS,
    "valid": _FLAGS,
    "torcsEquivalent": _NUMBERS,
    "atCar": {"indicators": _NUMBERS, "valid": _FLAGS},
    "vehicles": [{"id": 7, "lane": 1, "oncoming": False, "distanceMetres": 9, "bumperDistanceMetres": 5}],
    "boundaries": [_LINE],
    "markings": [_MEASURED],
    "laneWidthsMetres": [3.5, 4.5],
    "laneId": "0:1-0:2/f0",
    "lanesAhead": ["0:1-0:2/f0>0:3-0:4/f0", "0:3-0:4/f0"],
}


def write(folder: Path) -> Path:
    """Writes the session: one frame, of a rig with one camera and a LiDAR."""
    session = HandmadeSession(folder)
    session.info["rig"] = {"name": "one", "cameras": [{"name": "front"}]}
    line = session.lines[1]
    del session.lines[0], session.lines[1]
    light = {"state": "red", "method": "set", "litFraction": 0.5}
    car, person = line["objects"]
    car["lights"] = {"brake": True, "left": False, "right": False, "head": True}
    car.update(box2dVisible=[1, 2, 3, 4], box2dWhole=[1, 2, 3, 4], trueOccludedFraction=0.1)
    car.update(laneId="0:1-0:2/b0", governedLanes=["0:1-0:2/f0"])
    person["space"] = {
        "face": 0,
        "mutcd": "R1-1",
        "facesCamera": True,
        "facingAngleDegrees": 3,
        "provenance": "measured",
        "light": light,
    }
    person["joints"] = [{"joint": "neck", "position": [1, 21, 0], "pixel": [3, 4], "visibility": "visible"}]
    line.update(
        moment=0,
        view="front",
        classMap={"file": "classes/1.png"},
        depth={"sparse": "depth/1.png", "completed": None, "error": None},
        normals={"file": "normals/1.png"},
        flow={
            "from": 0,
            "backward": "flow/1.png",
            "forward": "flow/2.png",
            "motion": "flow/3.png",
            "backwardFlags": "flow/4.png",
            "forwardFlags": "flow/5.png",
        },
        birdsEye={
            "file": "birds-eye/1.png",
            "visible": "birds-eye-visible/1.png",
            "cells": 12,
            "cellMetres": 1.0,
            "source": "exact",
        },
        occupancy={
            "file": "occupancy/1.png",
            "instances": "occupancy-instances/1.png",
            "visible": "occupancy-visible/1.png",
            "cells": 4,
            "layers": 3,
            "cellMetres": 0.4,
            "lowestMetres": -1.0,
            "origin": [0.0, 0.0, -0.3],
        },
        lidar=[{"sensor": "top", "file": "lidar/1.bin"}],
        motion=[[float(i) for i in range(13)]],
        radar=[
            {
                "sensor": "ahead",
                "ranges": [9.0],
                "azimuthsDegrees": [1.0],
                "elevationsDegrees": [0.0],
                "radialVelocities": [-2.0],
                "groundVelocities": [3.0],
                "crossSections": [10.0],
                "objects": [7],
                "origins": [0],
            }
        ],
        imu={"timesSeconds": [1.0], "angularRates": [0.0, 0.1, 0.2], "specificForces": [0.0, 0.1, 9.8]},
        gnss={"timesSeconds": [1.0], "positions": [34.0, -118.0, 30.0], "velocities": [0.0, 10.0, 0.0]},
        drive=copy.deepcopy(ACTION),
        pairs=[{"file": "pairs/1.png", "weather": "rain", "timeOfDay": "06:00:00", "without": [7]}],
        lanes=copy.deepcopy(_LANES),
    )
    session.write()
    grey = np.ones((HEIGHT, WIDTH), np.uint8)
    colours = np.stack([grey] * 3, axis=-1)
    for name, picture in (
        ("classes/1.png", grey),
        ("depth/1.png", grey.astype(np.uint16)),
        ("normals/1.png", colours),
        ("pairs/1.png", colours),
        ("flow/1.png", colours.astype(np.uint16)),
        ("flow/2.png", colours.astype(np.uint16)),
        ("flow/3.png", colours.astype(np.uint16)),
        ("flow/4.png", grey),
        ("flow/5.png", grey),
        ("occupancy/1.png", np.ones((12, 4), np.uint8)),
        ("occupancy-instances/1.png", np.ones((12, 4), np.uint16)),
        ("occupancy-visible/1.png", np.full((12, 4), 255, np.uint8)),
        ("birds-eye/1.png", np.ones((12, 12), np.uint8)),
        ("birds-eye-visible/1.png", np.full((12, 12), 255, np.uint8)),
    ):
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_bytes(png.encode(picture))
    (folder / "lidar").mkdir(exist_ok=True)
    (folder / "lidar/1.bin").write_bytes(struct.pack("<4f3H2B", 1, 2, 3, 0.5, 7, 4, 12, 11, 0))
    return folder


def _reads_of_a_session(session: gtaharvest.Session) -> List[Tuple[str, Any]]:
    return [
        ("info", lambda: (repr(session), session.classes, session.state, session.view_names, session.camera)),
        ("moments", lambda: list(session.moments())),
        ("tracks", session.tracks),
        ("track", lambda: session.track(7)),
        ("frame", lambda: session.frame(1)),
    ]


def _reads_of_a_frame(frame: gtaharvest.Frame) -> List[Tuple[str, Any]]:
    return [
        ("repr", lambda: (repr(frame), repr(frame.view))),
        (
            "scalars",
            lambda: (frame.number, frame.time_seconds, frame.weather, frame.time_of_day, frame.moment, frame.view_name),
        ),
        ("ego", lambda: frame.ego),
        ("lanes", lambda: repr(frame.lanes)),
        ("motion", lambda: frame.motion),
        ("imu", lambda: frame.imu),
        ("gnss", lambda: frame.gnss),
        ("radars", lambda: frame.radars),
        ("drive", lambda: frame.drive),
        ("pairs", lambda: [frame.pair_image(pair) for pair in frame.pairs]),
        ("points", lambda: [frame.points(name) for name in frame.lidars]),
        (
            "objects",
            lambda: (frame.view.arrays(), frame.view.arrays(Selection(min_visible_fraction=0.1, min_side_pixels=1))),
        ),
        ("project", lambda: [frame.camera.project(item.box3d.corners) for item in frame.objects]),
        ("camera", lambda: frame.camera.directions([[1, 2]])),
        ("ignore regions", lambda: frame.view.ignore_regions),
        ("fields", lambda: {**frame.raw}),
        ("image", frame.image),
        ("mask", frame.mask),
        ("class map", frame.class_map),
        ("depth", frame.depth),
        ("normals", frame.normals),
        (
            "flow",
            lambda: (
                frame.flow_from,
                frame.flow(),
                frame.flow("forward"),
                frame.flow_flags(),
                frame.flow_flags("forward"),
            ),
        ),
        ("motion of surfaces", frame.surface_motion),
        ("bird's eye", lambda: (frame.birds_eye(), frame.birds_eye_visible(), frame.birds_eye_cell_metres)),
        ("drawing", lambda: (draw.annotate(frame.view), draw.annotate(frame.view, "3d"))),
    ]


def reads(folder: Path) -> Iterator[Tuple[str, Any]]:
    """Everything that can be read of a session in a folder: names, and calls that raise SessionError if it cannot."""
    session = gtaharvest.open_session(folder, allow_partial=True)
    yield from _reads_of_a_session(session)
    for frame in session:
        yield from _reads_of_a_frame(frame)
