"""The command gtaharvest."""

from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Optional, Sequence

from . import __version__, png
from .draw import KINDS, annotate
from .errors import SessionError
from .picture_header import Picture
from .selection import Selection
from .session import open_session

_EPILOG = """Exit codes: 0 done, 1 the session cannot be read, 2 wrong arguments, 3 a file cannot be written.

Example:
  gtaharvest show session --frame 12 --boxes 3d --out frame.png"""


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Runs the command; returns its exit code."""
    options = _parser().parse_args(arguments)
    try:
        return _show(options)
    except SessionError as problem:
        print(problem, file=sys.stderr)
        return 1
    except OSError as problem:
        print(f"{problem.filename or options.out}: {problem.strerror}.", file=sys.stderr)
        return 3


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(prog="gtaharvest", description="Reads sessions of GtaDataHarvester.")
    parser.add_argument("--version", action="version", version=f"gtaharvest {__version__}")
    commands = parser.add_subparsers(required=True, metavar="COMMAND")
    show = commands.add_parser(
        "show",
        help="draw the labels of a frame into its image",
        description="Draws the labels of a frame into its image.",
        epilog=_EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    show.add_argument("session", metavar="SESSION", type=Path, help="folder of the session")
    show.add_argument("--frame", type=int, metavar="N", help="number of the frame; the first by default")
    show.add_argument("--boxes", choices=KINDS, default="cuboid", help="which boxes to draw (default: cuboid)")
    show.add_argument("--no-joints", action="store_true", help="do not draw the joints of people")
    show.add_argument(
        "--class", dest="classes", action="append", metavar="NAME", help="draw only this class; may be repeated"
    )
    show.add_argument(
        "--min-visible", type=float, metavar="FRACTION", help="draw only objects of which at least this is visible"
    )
    show.add_argument("--max-distance", type=float, metavar="METRES", help="draw only objects up to this distance")
    show.add_argument("--partial", action="store_true", help="also read a session whose recording is unfinished")
    target = show.add_mutually_exclusive_group()
    target.add_argument(
        "--out", type=Path, metavar="FILE.png", help="the file to write; frame-N.png in the current folder by default"
    )
    target.add_argument("--window", action="store_true", help="open a window instead (needs OpenCV); any key closes it")
    return parser


def _show(options: argparse.Namespace) -> int:
    try:
        selection = Selection(options.classes, options.min_visible, max_distance_metres=options.max_distance)
    except ValueError as problem:
        print(problem, file=sys.stderr)
        return 2
    session = open_session(options.session, allow_partial=options.partial)
    if len(session) == 0:
        raise SessionError(f"{session.folder}: the session has no frames.")
    frame = session[0] if options.frame is None else session.frame(options.frame)
    picture = annotate(frame.view, options.boxes, not options.no_joints, selection)
    if options.window:
        return _open_window(f"{session.folder.name}, frame {frame.number}", picture)
    out = options.out or Path(f"frame-{frame.number:08d}.png")
    out.write_bytes(png.encode(picture))
    print(f"{out}: frame {frame.number}, {len(frame.view.select(selection))} objects")
    return 0


def _open_window(title: str, picture: Picture) -> int:
    try:
        import cv2
    except ImportError:
        print("--window needs OpenCV. Install it, or write a file with --out.", file=sys.stderr)
        return 2
    try:
        cv2.imshow(title, picture[..., ::-1].copy())
        cv2.waitKey()
    except cv2.error:
        print("OpenCV cannot open a window here. Write a file with --out.", file=sys.stderr)
        return 2
    return 0
