"""Lane departures, as `harvester drive` finds them."""

from __future__ import annotations

from typing import Any, Dict, List, Optional, Tuple

Frame = Dict[str, Any]
Place = Tuple[Optional[int], Optional[int]]


class LaneKeeping:
    """Finds the lane departures of a client in the frames of a drive, one after the other.

    A part of the car beyond the lanes of its direction is a departure. A part of it on the adjacent lane is a lane change if the car ends
    up there, a departure if it returns, and neither if a junction or the built-in driver intervenes.
    """

    def __init__(self) -> None:
        self._departures: List[Frame] = []
        self._last: Optional[Frame] = None
        self._begun: Optional[Frame] = None
        self._before: Optional[Place] = None
        self._is_beyond = False

    @property
    def departures(self) -> List[Frame]:
        """The frames at which the departures so far began."""
        pending = [] if self._begun is None or not self._is_departure(self._place_of(self._last)) else [self._begun]
        return [*self._departures, *pending]

    def take(self, frame: Frame) -> None:
        """Takes the next frame. Raises ValueError if the frame does not say where the car is in its lane, as in GTA V."""
        if frame.get("outsideLanes") is None or frame.get("acrossMarking") is None:
            raise ValueError(
                "The frame does not say whether the car has left its lane; only the simulated game reports that."
            )
        is_moved = self._last is not None and frame["repositioned"] > self._last["repositioned"]
        is_crossing = self.is_judged(frame) and bool(frame["outsideLanes"] or frame["acrossMarking"])
        if self._begun is not None and (is_moved or not is_crossing):
            if self._is_departure(self._place_of(self._last if is_moved else frame)):
                self._departures.append(self._begun)
            self._begun = None
        if is_crossing:
            if self._begun is None:
                self._begun, self._is_beyond = frame, False
                self._before = None if is_moved else self._place_of(self._last)
            self._is_beyond |= bool(frame["outsideLanes"])
        self._last = frame

    @staticmethod
    def is_judged(frame: Frame) -> bool:
        """Whether the client drives outside junctions, where alone departures count."""
        return not frame["builtInDriver"] and (frame["road"] is not None or bool(frame["outsideLanes"]))

    def _place_of(self, frame: Optional[Frame]) -> Optional[Place]:
        return (frame["road"], frame["lane"]) if frame is not None and self.is_judged(frame) else None

    def _is_departure(self, after: Optional[Place]) -> bool:
        return self._is_beyond or (after is not None and after == self._before)
