"""Labels as a pandas table."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Dict, Iterable, List, Optional

from .frame import Frame
from .records import ObjectLabel
from .selection import Selection

if TYPE_CHECKING:
    import pandas

_BOX = ("xMin", "yMin", "xMax", "yMax")


def table_of(frames: Iterable[Frame], selection: Optional[Selection]) -> pandas.DataFrame:
    """A table with one row per object of some frames, all or those that pass a filter.

    Its columns are the fields of ObjectLabel; boxes have the columns box2d_xMin and so on, vectors centre_x and so on. frame,
    time_seconds, view and image name the place. Unknown values are NaN or None.
    """
    import pandas

    rows: List[Dict[str, Any]] = []
    for frame in frames:
        for view in frame.views.values():
            for item in view.objects:
                if selection is None or selection.takes(item):
                    place = {
                        "frame": frame.number,
                        "time_seconds": frame.time_seconds,
                        "view": view.name,
                        "image": view.image_name,
                    }
                    rows.append({**place, **_row(item)})
    return pandas.DataFrame(rows)


def _row(item: ObjectLabel) -> Dict[str, Any]:
    row: Dict[str, Any] = {
        "id": item.id,
        "class_name": item.class_name,
        "model": item.model,
        "name": item.name,
        "parent": item.parent,
        "has_rider": item.has_rider,
        "vehicle": item.vehicle,
    }
    for name, box in (
        ("box2d", item.box2d),
        ("box2d_amodal", item.box2d_amodal),
        ("box2d_visible", item.box2d_visible),
        ("box2d_whole", item.box2d_whole),
    ):
        row.update({f"{name}_{side}": None if box is None else box[i] for i, side in enumerate(_BOX)})
    row.update(
        {
            "truncated_fraction": item.truncated_fraction,
            "occluded_fraction": item.occluded_fraction,
            "occlusion_method": item.occlusion_method,
            "visible_fraction": item.visible_fraction,
            "true_occluded_fraction": item.true_occluded_fraction,
            "lane_id": item.lane_id,
            "distance_metres": item.distance_metres,
        }
    )
    for name, vector in (
        ("centre", item.box3d.centre),
        ("half_extents", item.box3d.half_extents),
        ("forward", item.box3d.forward),
        ("up", item.box3d.up),
        ("velocity", item.velocity),
    ):
        row.update({f"{name}_{axis}": vector[i] for i, axis in enumerate("xyz")})
    row["light_state"] = item.face.light.state if item.face and item.face.light else None
    return row
