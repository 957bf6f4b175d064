"""What a driver did, by the truth of the game."""
from __future__ import annotations

from typing import Any, Dict

from gtaharvest.gym import EpisodeCounter, LaneKeeping


class Judge:
    """Counts, from the frames of a drive, what the driver did outside junctions."""

    def __init__(self, frame: Dict[str, Any], wanted_metres: float) -> None:
        self.driver_metres = self._in_lane_metres = self._squares = 0.0
        self._wanted_metres = wanted_metres
        self._counter = EpisodeCounter(wanted_metres)
        self._counter.take(frame)
        self._keeping = LaneKeeping()
        self._keeping.take(frame)
        self._collisions = {"vehicle": 0, "parked": 0, "pedestrian": 0}
        self._last = frame

    def take(self, frame: Dict[str, Any]) -> None:
        """Takes the next frame."""
        last, self._last = self._last, frame
        self._counter.take(frame)
        self._keeping.take(frame)
        if frame["repositioned"] > last["repositioned"] or not LaneKeeping.is_judged(frame):
            return
        for kind, before, after in zip(self._collisions, last["collisions"], frame["collisions"]):
            self._collisions[kind] += after - before
        metres = frame["drivenMetres"] - last["drivenMetres"]
        self.driver_metres += metres
        if frame["laneOffsetMetres"] is not None:
            self._in_lane_metres += metres
            self._squares += metres * frame["laneOffsetMetres"] ** 2

    def figures(self) -> Dict[str, Any]:
        """The figures of the drive. The offset is the root of the mean square over the distance in a lane. The score counts the
        infractions of the whole drive, but only the distance of the driver outside junctions.
        """
        episode = self._counter.episode
        completion = min(1.0, self.driver_metres / self._wanted_metres)
        departures = [
            {"seconds": frame["timeSeconds"], "position": frame["position"], "offsetMetres": frame["laneOffsetMetres"]}
            for frame in self._keeping.departures
        ]
        return {
            "metres": round(episode.driven_metres, 1),
            "score": round(100 * completion * episode.penalty, 1),
            "driverMetres": round(self.driver_metres, 1),
            "departures": departures,
            "collisions": self._collisions,
            "inLaneMetres": round(self._in_lane_metres, 1),
            "rmsOffsetMetres": round((self._squares / max(1, self._in_lane_metres)) ** 0.5, 3),
        }
