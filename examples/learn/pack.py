"""Packs a set of sessions into arrays, so that training reads no image file: pack.py DATA [SET...].

DATA/packed/SET.npz has, of all frames in order: images (n, 70, 140, 3), uint8: half size, without the upper third; values (n, 13), float32:
the indicators as in torcsEquivalent; active (n, 13); width (n,), lane widths in metres; frames (n, 2): number of the session and of the
frame in it; speed (n,), m/s; and, of recorded drives, controls (n, 3), route (n,) and by_controller (n,). What a frame lacks is NaN.
A set that is packed is packed again only if its sessions have changed.
"""
from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Any, Dict, List

import cv2
import numpy as np

from gtaharvest import SessionError, open_session

import actions
from commands import STOPPED
from sets import DRIVES, SETS

HEIGHT, WIDTH = 70, 140

TYPES = {"images": np.uint8, "active": np.bool_, "by_controller": np.bool_}
"""Types of the arrays that are not float32."""


def shrink(image: np.ndarray) -> np.ndarray:
    """The image as the network sees it: 140 pixels wide, without the upper third."""
    small = cv2.resize(image, (WIDTH, WIDTH * image.shape[0] // image.shape[1]), interpolation=cv2.INTER_AREA)
    return np.ascontiguousarray(small[-HEIGHT:])


def rows_of(session_number: int, folder: Path) -> Dict[str, List[Any]]:
    """The arrays of a session, as lists."""
    names = ("images", "values", "active", "width", "frames", "controls", "route", "speed", "by_controller")
    rows: Dict[str, List[Any]] = {name: [] for name in names}
    for frame in open_session(folder):
        lanes, drive = frame.lanes, frame.raw.get("drive") or {}
        rows["images"].append(shrink(frame.view.image()))
        rows["values"].append(lanes.torcs_equivalent.values)
        rows["active"].append(lanes.torcs_equivalent.valid)
        rows["width"].append(np.nan if lanes.lane_width_metres is None else lanes.lane_width_metres)
        rows["frames"].append((session_number, frame.number))
        rows["speed"].append(float(np.linalg.norm(frame.ego.velocity)))
        rows["controls"].append(actions.controls_of(drive))
        rows["route"].append(actions.route_of(drive))
        rows["by_controller"].append(drive.get("driver") == "controller")
    return rows


def pack(data: Path, name: str) -> Path:
    """Packs a set, unless it is packed and no session has changed since; returns the file."""
    folders = sorted(folder for folder in (data / name).glob("*") if (folder / "session.json").exists())
    maker = "record.py" if name in DRIVES else "harvest.py"
    if not folders:
        raise SessionError(f"{data / name} has no session; run {maker} first.")
    planned = len((DRIVES if name in DRIVES else SETS)[name])
    if len(folders) < planned:
        print(
            f"pack.py: {data / name} has {len(folders)} of {planned} sessions; {maker} makes the others.",
            file=sys.stderr,
        )
    target = data / "packed" / f"{name}.npz"
    # A folder's own time tells of sessions that were deleted.
    changed = max(path.stat().st_mtime_ns for path in (data / name, *(folder / "session.json" for folder in folders)))
    if target.exists() and target.stat().st_mtime_ns > changed:
        return target
    packed: Dict[str, List[np.ndarray]] = {}
    for number, folder in enumerate(folders):
        for key, values in rows_of(number, folder).items():
            packed.setdefault(key, []).append(np.asarray(values, TYPES.get(key, np.float32)))
        print(f"{name}: {number + 1} of {len(folders)} sessions", flush=True)
    target.parent.mkdir(exist_ok=True)
    part = target.with_suffix(".part.npz")
    np.savez(part, **{key: np.concatenate(arrays) for key, arrays in packed.items()})
    part.replace(target)
    return target


def main() -> int:
    """Runs the command line."""
    parser = argparse.ArgumentParser(description="Packs sets of sessions into arrays.")
    parser.add_argument("data", type=Path, help="folder of harvest.py and record.py")
    parser.add_argument("sets", nargs="*", help="sets to pack; default: all that are there")
    options = parser.parse_args()
    unknown = set(options.sets) - {*SETS, *DRIVES}
    if unknown:
        parser.error(f"unknown set '{min(unknown)}'; sets are {', '.join((*SETS, *DRIVES))}")
    try:
        names = options.sets or [name for name in (*SETS, *DRIVES) if (options.data / name).is_dir()]
        if not names:
            raise SessionError(f"{options.data} has no set; run harvest.py first.")
        for name in names:
            print(pack(options.data, name), flush=True)
    except (OSError, SessionError) as problem:
        print(f"pack.py: {problem}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print(
            "pack.py: stopped; run the same command again to continue with the set that was cut off.", file=sys.stderr
        )
        return STOPPED
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
