"""Draws labels into images, with NumPy alone; names are written if OpenCV is installed."""

from __future__ import annotations

from typing import Any, Dict, Sequence, Tuple

import numpy as np

from .camera import Array, Camera
from .frame import View
from .picture_header import Picture
from .records import CUBOID_EDGES, ObjectLabel
from .selection import Selection

Colour = Tuple[int, int, int]

CLASS_COLOURS: Dict[str, Colour] = {
    "car": (0, 200, 255),
    "truck": (255, 140, 0),
    "bus": (255, 220, 0),
    "motorcycle": (200, 80, 255),
    "bicycle": (120, 120, 255),
    "trailer": (180, 120, 60),
    "pedestrian": (255, 60, 90),
    "rider": (255, 140, 200),
    "sign": (60, 230, 90),
    "trafficLight": (180, 255, 60),
}
"""Red, green, blue by class; other classes are white."""

KINDS = ("cuboid", "amodal", "visible", "whole", "3d", "none")
"""The kinds of boxes that annotate draws."""

_WHITE: Colour = (255, 255, 255)


def annotate(view: View, boxes: str = "cuboid", joints: bool = True, selection: Selection = Selection()) -> Picture:
    """The image of a view with its labels drawn into it, (height, width, 3), uint8, red first.

    boxes: one of KINDS. joints: whether joints in the image are drawn. selection: the objects to draw.
    """
    if boxes not in KINDS:
        raise ValueError(f"Unknown kind of box '{boxes}'; kinds are {', '.join(KINDS)}.")
    picture = np.ascontiguousarray(view.image()).copy()
    for item in view.select(selection):
        colour = CLASS_COLOURS.get(item.class_name, _WHITE)
        box = {
            "cuboid": item.box2d,
            "amodal": item.box2d_amodal,
            "visible": item.box2d_visible,
            "whole": item.box2d_whole,
        }.get(boxes)
        if boxes == "3d":
            draw_cuboid(picture, view.camera, item, colour)
        elif box is not None:
            draw_box(picture, box, colour)
            _write(picture, f"{item.class_name} {item.distance_metres:.0f} m", box, colour)
        if joints:
            for joint in item.joints or ():
                if joint.pixel is not None and joint.visibility != "outside":
                    draw_point(picture, joint.pixel, colour if joint.visibility == "visible" else (128, 128, 128))
    return picture


def draw_box(picture: Picture, box: Sequence[float], colour: Colour) -> None:
    """Draws the outline of a box, pixels, one pixel wide: the outermost pixels that the box touches."""
    height, width = picture.shape[:2]
    x_min, y_min = int(max(box[0], -1)), int(max(box[1], -1))
    x_max, y_max = int(np.ceil(min(box[2], width + 1.0))) - 1, int(np.ceil(min(box[3], height + 1.0))) - 1
    columns, rows = slice(max(x_min, 0), max(x_max + 1, 0)), slice(max(y_min, 0), max(y_max + 1, 0))
    for row in (y_min, y_max):
        if 0 <= row < height and (row == y_min and box[1] >= 0 or row == y_max and box[3] <= height):
            picture[row, columns] = colour
    for column in (x_min, x_max):
        if 0 <= column < width and (column == x_min and box[0] >= 0 or column == x_max and box[2] <= width):
            picture[rows, column] = colour


def draw_cuboid(picture: Picture, camera: Camera, item: ObjectLabel, colour: Colour) -> None:
    """Draws the edges of an object's cuboid with the lens, cut at the near plane."""
    corners = item.box3d.corners
    for start, end in CUBOID_EDGES:
        # Through a lens an edge is a curve.
        along = np.linspace(0, 1, 33)[:, np.newaxis]
        draw_line(picture, camera.project(corners[start] * (1 - along) + corners[end] * along).pixels, colour)


def draw_line(picture: Picture, pixels: Array, colour: Colour) -> None:
    """Draws a polyline, (n, 2) in continuous pixels; points that are NaN interrupt it."""
    height, width = picture.shape[:2]
    for start, end in zip(pixels[:-1], pixels[1:]):
        # A point far outside the image would make an endless line.
        if not np.all(np.isfinite([start, end])) or np.abs([start, end]).max() > 10 * (width + height):
            continue
        steps = int(np.abs(end - start).max()) + 2
        points = np.floor(np.linspace(start, end, steps)).astype(np.int64)
        inside = points[(points[:, 0] >= 0) & (points[:, 0] < width) & (points[:, 1] >= 0) & (points[:, 1] < height)]
        picture[inside[:, 1], inside[:, 0]] = colour


def draw_point(picture: Picture, pixel: Sequence[float], colour: Colour) -> None:
    """Draws a square of three pixels around a point."""
    column, row = int(np.floor(pixel[0])), int(np.floor(pixel[1]))
    picture[max(row - 1, 0) : max(row + 2, 0), max(column - 1, 0) : max(column + 2, 0)] = colour


def _write(picture: Picture, text: str, box: Sequence[float], colour: Colour) -> None:
    try:
        import cv2
    except ImportError:
        return
    at: Any = (int(max(box[0], 0)), int(max(box[1] - 2, 8)))
    cv2.putText(picture, text, at, cv2.FONT_HERSHEY_SIMPLEX, 0.3, colour, 1, cv2.LINE_AA)
