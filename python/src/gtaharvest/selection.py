"""Filters of objects."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Collection, Optional

from .records import ObjectLabel


@dataclass(frozen=True)
class Selection:
    """Which objects to take; None does not filter.

    classes: names of classes. min_visible_fraction: 0 to 1; objects whose visibility is unknown are left out.
    max_truncated_fraction: 0 to 1. min_distance_metres, max_distance_metres: from the camera to the centre of the cuboid.
    min_side_pixels: of box2d. with_parts: whether faces of signs and heads of traffic lights, which are part of another object, are taken.
    """

    classes: Optional[Collection[str]] = None
    min_visible_fraction: Optional[float] = None
    max_truncated_fraction: Optional[float] = None
    min_distance_metres: Optional[float] = None
    max_distance_metres: Optional[float] = None
    min_side_pixels: Optional[float] = None
    with_parts: bool = True

    def __post_init__(self) -> None:
        if isinstance(self.classes, str):
            raise TypeError(f"classes must be a collection of names, such as {{'{self.classes}'}}, not a text.")

    def takes(self, item: ObjectLabel) -> bool:
        """Whether an object passes all filters."""
        box = item.box2d
        return (
            (self.classes is None or item.class_name in self.classes)
            and (self.min_visible_fraction is None
                 or (item.visible_fraction is not None and item.visible_fraction >= self.min_visible_fraction))
            and (self.max_truncated_fraction is None or item.truncated_fraction <= self.max_truncated_fraction)
            and (self.min_distance_metres is None or item.distance_metres >= self.min_distance_metres)
            and (self.max_distance_metres is None or item.distance_metres <= self.max_distance_metres)
            and (self.min_side_pixels is None or min(box[2] - box[0], box[3] - box[1]) >= self.min_side_pixels)
            and (self.with_parts or item.parent is None))
