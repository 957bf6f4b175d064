"""Writes ScenarioNet's pickles, which MetaDrive reads, from a dataset of harvester export --format womd.

python -m gtaharvest.scenarionet DATASET OUT
"""

from __future__ import annotations

import argparse
import pickle
import struct
import sys
from pathlib import Path
from typing import Any, Dict, Iterator, List, Optional, Sequence

import numpy as np
from numpy.typing import NDArray

from . import womd
from .errors import ScenarioError

SUMMARY = "dataset_summary.pkl"
MAPPING = "dataset_mapping.pkl"

_DATASET, _VERSION = "gta", "v1"
_TYPES = {1: "VEHICLE", 2: "PEDESTRIAN", 3: "CYCLIST"}
_LANES = ["LANE_UNKNOWN", "LANE_FREEWAY", "LANE_SURFACE_STREET", "LANE_BIKE_LANE"]
_LINES = [
    "UNKNOWN_LINE",
    "ROAD_LINE_BROKEN_SINGLE_WHITE",
    "ROAD_LINE_SOLID_SINGLE_WHITE",
    "ROAD_LINE_SOLID_DOUBLE_WHITE",
    "ROAD_LINE_BROKEN_SINGLE_YELLOW",
    "ROAD_LINE_BROKEN_DOUBLE_YELLOW",
    "ROAD_LINE_SOLID_SINGLE_YELLOW",
    "ROAD_LINE_SOLID_DOUBLE_YELLOW",
    "ROAD_LINE_PASSING_DOUBLE_YELLOW",
]
_EDGES = ["UNKNOWN", "ROAD_EDGE_BOUNDARY", "ROAD_EDGE_MEDIAN"]
_AREAS = {8: "CROSSWALK", 9: "SPEED_BUMP", 10: "DRIVEWAY"}
_LIGHTS = [
    "LANE_STATE_UNKNOWN",
    "LANE_STATE_ARROW_STOP",
    "LANE_STATE_ARROW_CAUTION",
    "LANE_STATE_ARROW_GO",
    "LANE_STATE_STOP",
    "LANE_STATE_CAUTION",
    "LANE_STATE_GO",
    "LANE_STATE_FLASHING_STOP",
    "LANE_STATE_FLASHING_CAUTION",
]

Scenario = Dict[str, Any]


def scenarios(dataset: Path) -> Iterator[Scenario]:
    """The scenarios of a dataset, as ScenarioNet describes them: only Python and NumPy types.

    Positions are metres, headings radians, velocities metres per second; values are 0 where a track is not valid.
    """
    files = sorted(dataset.glob("*.tfrecord*"))
    if not files:
        raise ScenarioError(f"{dataset}: it has no .tfrecord file. Export with harvester export --format womd.")
    for file in files:
        for record in womd.records(file):
            yield scenario_of(record)


def scenario_of(record: bytes) -> Scenario:
    """The scenario of a Scenario message."""
    try:
        return _scenario(womd.message(record))
    except (AttributeError, IndexError, TypeError, ValueError, struct.error) as problem:
        raise ScenarioError("A scenario is damaged.") from problem


def _scenario(fields: womd.Message) -> Scenario:
    steps = womd.numbers(fields, 1)
    name = womd.text(fields, 5)
    tracks = [_track(track, len(steps)) for track in womd.messages(fields, 2)]
    by_id = {track["metadata"]["object_id"]: track for track in tracks}
    return {
        "id": name,
        "version": _VERSION,
        "length": len(steps),
        "tracks": by_id,
        "dynamic_map_states": _lights(womd.messages(fields, 7), len(steps)),
        "map_features": dict(_feature(feature) for feature in womd.messages(fields, 8)),
        "metadata": {
            "id": name,
            "scenario_id": name,
            "dataset": _DATASET,
            "ts": np.array(steps, dtype=np.float32),
            "metadrive_processed": False,
            "coordinate": "waymo",
            "sdc_id": tracks[womd.whole(fields, 6)]["metadata"]["object_id"],
            "current_time_index": womd.whole(fields, 10),
        },
    }


def write(dataset: Path, out: Path) -> int:
    """Writes a pickle a scenario, and the summary and mapping that ScenarioNet's readers begin with; returns their number."""
    out.mkdir(parents=True, exist_ok=True)
    summary: Dict[str, Any] = {}
    for scenario in scenarios(dataset):
        name = f"sd_{_DATASET}_{_VERSION}_{scenario['id']}.pkl"
        _dump(out / name, scenario)
        summary[name] = scenario["metadata"]
    _dump(out / MAPPING, {name: "" for name in summary})
    _dump(out / SUMMARY, summary)
    return len(summary)


def main(arguments: Optional[Sequence[str]] = None) -> int:
    """Runs the command; returns its exit code."""
    parser = argparse.ArgumentParser(
        prog="python -m gtaharvest.scenarionet",
        description="Writes ScenarioNet's pickles from a dataset of the format womd.",
    )
    parser.add_argument("dataset", type=Path, help="folder that harvester export --format womd wrote")
    parser.add_argument("out", type=Path, help="folder to write to")
    options = parser.parse_args(arguments)
    try:
        print(f"{options.out}: {write(options.dataset, options.out)} scenarios")
    except ScenarioError as problem:
        print(problem, file=sys.stderr)
        return 1
    except OSError as problem:
        print(f"{problem.filename or options.out}: {problem.strerror}.", file=sys.stderr)
        return 3
    return 0


def _dump(path: Path, content: Any) -> None:
    part = path.with_name(path.name + ".part")
    with open(part, "wb") as file:
        pickle.dump(content, file, protocol=4)
    part.replace(path)


def _track(track: womd.Message, length: int) -> Dict[str, Any]:
    states = womd.messages(track, 3)
    if len(states) != length:
        raise ScenarioError("A track has not as many states as there are steps.")
    valid = np.array([bool(womd.whole(state, 11)) for state in states])

    def column(field: int) -> NDArray[np.float64]:
        return np.array([womd.number(state, field) if known else 0.0 for state, known in zip(states, valid)])

    kind = _TYPES.get(womd.whole(track, 2), "OTHER")
    identity = str(womd.whole(track, 1))
    return {
        "type": kind,
        "state": {
            "position": np.stack([column(2), column(3), column(4)], axis=-1),
            "heading": column(8),
            "velocity": np.stack([column(9), column(10)], axis=-1),
            "length": column(5),
            "width": column(6),
            "height": column(7),
            "valid": valid,
        },
        "metadata": {"type": kind, "object_id": identity, "track_length": length, "dataset": _DATASET},
    }


def _lights(steps: List[womd.Message], length: int) -> Dict[str, Any]:
    lights: Dict[str, Any] = {}
    for step, state in enumerate(steps):
        for light in womd.messages(state, 1):
            lane = str(womd.whole(light, 1))
            if lane not in lights:
                lights[lane] = {
                    "type": "TRAFFIC_LIGHT",
                    "state": {"object_state": [_LIGHTS[0]] * length},
                    "lane": lane,
                    "stop_point": _point(womd.messages(light, 3)[0]),
                    "metadata": {
                        "type": "TRAFFIC_LIGHT",
                        "object_id": lane,
                        "track_length": length,
                        "dataset": _DATASET,
                    },
                }
            lights[lane]["state"]["object_state"][step] = _LIGHTS[womd.whole(light, 2)]
    return lights


def _feature(feature: womd.Message) -> "tuple[str, Dict[str, Any]]":
    identity = str(womd.whole(feature, 1))
    if 3 in feature:
        return identity, _lane(womd.messages(feature, 3)[0])
    for field, types in ((4, _LINES), (5, _EDGES)):
        if field in feature:
            line = womd.messages(feature, field)[0]
            return identity, {"type": types[womd.whole(line, 1)], "polyline": _points(line, 2)}
    if 7 in feature:
        sign = womd.messages(feature, 7)[0]
        return identity, {
            "type": "STOP_SIGN",
            "lane": [str(lane) for lane in womd.wholes(sign, 1)],
            "position": _point(womd.messages(sign, 2)[0]),
        }
    for field, name in _AREAS.items():
        if field in feature:
            return identity, {"type": name, "polygon": _points(womd.messages(feature, field)[0], 1)}
    raise ScenarioError(f"Map feature {identity} is of an unknown kind.")


def _lane(lane: womd.Message) -> Dict[str, Any]:
    def beside(field: int) -> List[Dict[str, Any]]:
        return [
            {
                "feature_id": str(womd.whole(neighbour, 1)),
                "self_start_index": womd.whole(neighbour, 2),
                "self_end_index": womd.whole(neighbour, 3),
                "neighbor_start_index": womd.whole(neighbour, 4),
                "neighbor_end_index": womd.whole(neighbour, 5),
            }
            for neighbour in womd.messages(lane, field)
        ]

    def along(field: int) -> List[Dict[str, Any]]:
        return [
            {
                "lane_start_index": womd.whole(boundary, 1),
                "lane_end_index": womd.whole(boundary, 2),
                "boundary_feature_id": str(womd.whole(boundary, 3)),
                "boundary_type": _LINES[womd.whole(boundary, 4)],
            }
            for boundary in womd.messages(lane, field)
        ]

    return {
        "type": _LANES[womd.whole(lane, 2)],
        "polyline": _points(lane, 8),
        "interpolating": bool(womd.whole(lane, 3)),
        "entry_lanes": [str(other) for other in womd.wholes(lane, 9)],
        "exit_lanes": [str(other) for other in womd.wholes(lane, 10)],
        "left_neighbor": beside(11),
        "right_neighbor": beside(12),
        "left_boundaries": along(13),
        "right_boundaries": along(14),
    }


def _points(fields: womd.Message, field: int) -> NDArray[np.float64]:
    return np.array([_point(point) for point in womd.messages(fields, field)])


def _point(point: womd.Message) -> NDArray[np.float64]:
    return np.array([womd.number(point, 1), womd.number(point, 2), womd.number(point, 3)])


if __name__ == "__main__":
    sys.exit(main())
