"""What a driver did, by the truth of the game."""
from __future__ import annotations

from typing import Any, Dict, List

from gtaharvest.gym import EpisodeCounter, driving_score


class Judge:
    """Counts, from the frames of a drive, what the driver did outside junctions."""

    def __init__(self, frame: Dict[str, Any], wanted_metres: float) -> None:
        self.driver_metres = self._squares = 0.0
        self._counter = EpisodeCounter(wanted_metres)
        self._counter.take(frame)
        self._departures: List[Dict[str, Any]] = []
        self._collisions = {"vehicle": 0, "parked": 0, "pedestrian": 0}
        self._last = frame

    def take(self, frame: Dict[str, Any]) -> None:
        """Takes the next frame."""
        last, self._last = self._last, frame
        self._counter.take(frame)
        if last["builtInDriver"] or frame["repositioned"] > last["repositioned"]:
            return
        for kind, before, after in zip(self._collisions, last["collisions"], frame["collisions"]):
            self._collisions[kind] += after - before
        offset = frame["laneOffsetMetres"]
        if frame["outsideLanes"] and not last["outsideLanes"]:
            self._departures.append({"seconds": frame["timeSeconds"], "position": frame["position"], "offsetMetres": offset})
        if offset is not None:
            metres = frame["drivenMetres"] - last["drivenMetres"]
            self.driver_metres += metres
            self._squares += metres * offset**2

    def figures(self) -> Dict[str, Any]:
        """The figures of the drive. The offset is the root of the mean square over the distance. The score counts the whole drive."""
        episode = self._counter.episode
        return {
            "metres": round(episode.driven_metres, 1), "score": round(driving_score(episode), 1),
            "driverMetres": round(self.driver_metres, 1), "departures": self._departures,
            "collisions": self._collisions, "rmsOffsetMetres": round((self._squares / max(1, self.driver_metres)) ** 0.5, 3)}
