"""The objects of an image as arrays."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Optional, Sequence

import numpy as np
import numpy.typing as npt

from .camera import Array
from .records import JOINT_NAMES, Box, ObjectLabel


@dataclass(frozen=True, repr=False)
class ObjectArrays:
    """The objects of an image, one row each. NaN stands for unknown.

    ids: (n,). class_names: (n,), text. box2d, box2d_amodal, box2d_visible, box2d_whole: (n, 4), pixels. truncated_fraction,
    occluded_fraction, visible_fraction, distance_metres: (n,). centre, half_extents, velocity: (n, 3), metres and metres per second, world.
    axes: (n, 3, 3), right, forward and up as rows. joints: (n, 22, 3), metres, world. joint_pixels: (n, 22, 2).
    joint_visibility: (n, 22), text, empty for objects without joints.
    """

    ids: npt.NDArray[np.int64]
    class_names: npt.NDArray[np.str_]
    box2d: Array
    box2d_amodal: Array
    box2d_visible: Array
    box2d_whole: Array
    truncated_fraction: Array
    occluded_fraction: Array
    visible_fraction: Array
    distance_metres: Array
    centre: Array
    half_extents: Array
    axes: Array
    velocity: Array
    joints: Array
    joint_pixels: Array
    joint_visibility: npt.NDArray[np.str_]

    def __len__(self) -> int:
        return len(self.ids)

    def __repr__(self) -> str:
        return f"ObjectArrays({len(self)} objects)"

    @staticmethod
    def of(objects: Sequence[ObjectLabel]) -> ObjectArrays:
        """The arrays of some objects."""
        count = len(objects)
        joints = np.full((count, len(JOINT_NAMES), 3), np.nan)
        pixels = np.full((count, len(JOINT_NAMES), 2), np.nan)
        visibility = np.full((count, len(JOINT_NAMES)), "", dtype="U12")
        for row, item in enumerate(objects):
            for column, joint in enumerate(item.joints or ()):
                joints[row, column] = joint.position
                pixels[row, column] = (np.nan, np.nan) if joint.pixel is None else joint.pixel
                visibility[row, column] = joint.visibility
        return ObjectArrays(
            np.array([item.id for item in objects], dtype=np.int64),
            np.array([item.class_name for item in objects], dtype=np.str_),
            _rows([item.box2d for item in objects], 4),
            _rows([item.box2d_amodal for item in objects], 4),
            _rows([_box(item.box2d_visible) for item in objects], 4),
            _rows([_box(item.box2d_whole) for item in objects], 4),
            np.array([item.truncated_fraction for item in objects], dtype=np.float64),
            np.array([item.occluded_fraction for item in objects], dtype=np.float64),
            np.array([item.visible_fraction for item in objects], dtype=np.float64),
            np.array([item.distance_metres for item in objects], dtype=np.float64),
            _rows([item.box3d.centre for item in objects], 3),
            _rows([item.box3d.half_extents for item in objects], 3),
            _rows([item.box3d.right + item.box3d.forward + item.box3d.up for item in objects], 9).reshape(-1, 3, 3),
            _rows([item.velocity for item in objects], 3),
            joints,
            pixels,
            visibility,
        )


def _box(box: Optional[Box]) -> Any:
    return (np.nan,) * 4 if box is None else box


def _rows(rows: Sequence[Any], columns: int) -> Array:
    return np.array(rows, dtype=np.float64).reshape(-1, columns)
