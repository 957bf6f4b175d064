"""Filters of objects."""

from __future__ import annotations

import difflib
from dataclasses import dataclass
from typing import Collection, Optional

from .records import CLASS_NAMES, ObjectLabel


def check_classes(names: Optional[Collection[str]]) -> None:
    """Raises TypeError if these are no collection of names, and ValueError if one is no class of the format."""
    if isinstance(names, str):
        raise TypeError(f"classes must be a collection of names, such as {{'{names}'}}, not a text.")
    for name in names or ():
        if name not in CLASS_NAMES:
            similar = difflib.get_close_matches(str(name), CLASS_NAMES, 1)
            hint = f"; did you mean '{similar[0]}'?" if similar else f"; classes are {', '.join(CLASS_NAMES)}."
            raise ValueError(f"Unknown class {name!r}{hint}")


@dataclass(frozen=True)
class Selection:
    """Which objects to take; None does not filter.

    classes: names of classes. min_visible_fraction: 0 to 1; objects whose visibility is unknown are left out.
    max_truncated_fraction: 0 to 1. min_distance_metres, max_distance_metres: from the camera to the centre of the cuboid.
    min_side_pixels: of box2d. with_parts: whether faces of signs and heads of traffic lights, which are part of another object, are taken.

    Raises ValueError for an unknown class, and for a number out of range.
    """

    classes: Optional[Collection[str]] = None
    min_visible_fraction: Optional[float] = None
    max_truncated_fraction: Optional[float] = None
    min_distance_metres: Optional[float] = None
    max_distance_metres: Optional[float] = None
    min_side_pixels: Optional[float] = None
    with_parts: bool = True

    def __post_init__(self) -> None:
        check_classes(self.classes)
        for name in ("min_visible_fraction", "max_truncated_fraction"):
            value = getattr(self, name)
            if value is not None and not 0 <= value <= 1:
                raise ValueError(f"{name} is from 0 to 1, not {value}.")
        for name in ("min_distance_metres", "max_distance_metres", "min_side_pixels"):
            value = getattr(self, name)
            if value is not None and not value >= 0:
                raise ValueError(f"{name} is 0 or more, not {value}.")

    def takes(self, item: ObjectLabel) -> bool:
        """Whether an object passes all filters."""
        box = item.box2d
        return (
            (self.classes is None or item.class_name in self.classes)
            and (
                self.min_visible_fraction is None
                or (item.visible_fraction is not None and item.visible_fraction >= self.min_visible_fraction)
            )
            and (self.max_truncated_fraction is None or item.truncated_fraction <= self.max_truncated_fraction)
            and (self.min_distance_metres is None or item.distance_metres >= self.min_distance_metres)
            and (self.max_distance_metres is None or item.distance_metres <= self.max_distance_metres)
            and (self.min_side_pixels is None or min(box[2] - box[0], box[3] - box[1]) >= self.min_side_pixels)
            and (self.with_parts or item.parent is None)
        )
