"""Evaluation of drives: route completion, infractions per kilometre and a driving score, as `harvester drive` computes them."""

from __future__ import annotations

import dataclasses
import math
from typing import Any, Callable, Dict, Iterable, NamedTuple, Sequence, Tuple

import numpy as np

from .lane_keeping import LaneKeeping

PENALTIES: Dict[str, float] = {
    "pedestrian_collisions": 0.50,
    "vehicle_collisions": 0.60,
    "parked_collisions": 0.60,
    "red_lights": 0.70,
    "stop_signs": 0.80,
}
"""Factor on the score for each infraction of a kind: those of CARLA's leaderboards 1.0 and 2.0, parked vehicles being vehicles."""

_RATES = (*PENALTIES, "lane_departures", "repositioned")


@dataclasses.dataclass(frozen=True)
class Episode:
    """Counters of a drive. `EpisodeCounter` takes them from the frames of a game."""

    wanted_metres: float
    """Distance to drive, metres, greater than 0."""

    driven_metres: float = 0.0
    """Distance driven, metres, without repositioning."""

    outside_metres: float = 0.0
    """Part of it with a part of the car outside the lanes of its direction, metres."""

    seconds: float = 0.0
    """Game time."""

    vehicle_collisions: int = 0
    """Collisions with vehicles in traffic."""

    parked_collisions: int = 0
    """Collisions with parked vehicles."""

    pedestrian_collisions: int = 0
    """Collisions with pedestrians."""

    red_lights: int = 0
    """Red lights run."""

    stop_signs: int = 0
    """Stop signs passed without a stop."""

    judged_metres: float = 0.0
    """Distance that the client drove outside junctions, metres, where alone lane departures count."""

    lane_departures: int = 0
    """Times that a part of the car left the lanes of its direction, or entered the adjacent lane and came back, while the client drove."""

    repositioned: int = 0
    """Times that the game put the car elsewhere, as when it was stuck."""

    @classmethod
    def of(cls, frames: Iterable[Dict[str, Any]], wanted_metres: float) -> Episode:
        """The counters between the first and the last of some frames, `info["frame"]` of an environment.

        Raises ValueError if there is no frame or the game does not know the counters, as GTA V.
        """
        counter = EpisodeCounter(wanted_metres)
        for frame in frames:
            counter.take(frame)
        return counter.episode

    @property
    def route_completion(self) -> float:
        """Share of the wanted distance that was driven, 0 to 1."""
        return min(1.0, self.driven_metres / self.wanted_metres)

    @property
    def outside_share(self) -> float:
        """Share of the driven distance outside the lanes, 0 to 1."""
        return min(1.0, self.outside_metres / self.driven_metres) if self.driven_metres > 0 else 0.0

    @property
    def penalty(self) -> float:
        """Product of the factors of all infractions, and of the share of the distance inside the lanes: 0 to 1."""
        product = 1 - self.outside_share
        for name, factor in PENALTIES.items():
            product *= factor ** int(getattr(self, name))
        return product


class EpisodeCounter:
    """Counts what happens in the frames of a drive, one after the other."""

    def __init__(self, wanted_metres: float) -> None:
        if not wanted_metres > 0:
            raise ValueError(f"wanted_metres is greater than 0, not {wanted_metres}.")
        self._wanted_metres = wanted_metres
        self._first: Dict[str, Any] = {}
        self._last: Dict[str, Any] = {}
        self._outside_metres = 0.0
        self._judged_metres = 0.0
        self._keeping = LaneKeeping()

    def take(self, frame: Dict[str, Any]) -> None:
        """Takes the next frame. The distance from the frame before counts by where, and by whom, it ends."""
        if frame.get("drivenMetres") is None or frame.get("collisions") is None:
            raise ValueError("The frame has no counters; only the simulated game knows them.")
        if self._last:
            metres = frame["drivenMetres"] - self._last["drivenMetres"]
            self._outside_metres += metres * bool(frame["outsideLanes"])
            self._judged_metres += metres * LaneKeeping.is_judged(frame)
        else:
            self._first = frame
        self._keeping.take(frame)
        self._last = frame

    @property
    def episode(self) -> Episode:
        """The counters so far. Raises ValueError if no frame was taken."""
        if not self._last:
            raise ValueError("An episode has at least one frame.")
        first, last = self._first, self._last
        vehicles, parked, pedestrians = (
            after - before for before, after in zip(first["collisions"], last["collisions"])
        )
        return Episode(
            wanted_metres=self._wanted_metres,
            driven_metres=last["drivenMetres"] - first["drivenMetres"],
            outside_metres=self._outside_metres,
            seconds=last["timeSeconds"] - first["timeSeconds"],
            vehicle_collisions=int(vehicles),
            parked_collisions=int(parked),
            pedestrian_collisions=int(pedestrians),
            red_lights=last["redLightsRun"] - first["redLightsRun"],
            stop_signs=last["stopSignsRun"] - first["stopSignsRun"],
            judged_metres=self._judged_metres,
            lane_departures=len(self._keeping.departures),
            repositioned=last["repositioned"] - first["repositioned"],
        )


def driving_score(episode: Episode) -> float:
    """The driving score of an episode, 0 to 100: route completion times the penalty."""
    return 100.0 * episode.route_completion * episode.penalty


class Rate(NamedTuple):
    """Events per kilometre with an exact interval for events of a Poisson process."""

    events: int
    kilometres: float
    per_km: float
    low: float
    high: float


def rates_per_km(episodes: Sequence[Episode], confidence: float = 0.95) -> Dict[str, Rate]:
    """The infractions of all episodes, by the names of `Episode`, with Garwood's exact intervals: lane departures per kilometre that the
    client drove outside junctions, all others per kilometre driven. Not a number if no such distance was driven.
    """
    driven, judged = (
        sum(getattr(episode, name) for episode in episodes) / 1000 for name in ("driven_metres", "judged_metres")
    )
    rates = {}
    for name in _RATES:
        events = sum(int(getattr(episode, name)) for episode in episodes)
        kilometres = judged if name == "lane_departures" else driven
        low, high = poisson_interval(events, confidence)
        rates[name] = Rate(
            events, kilometres, *(value / kilometres if kilometres > 0 else math.nan for value in (events, low, high))
        )
    return rates


def poisson_interval(events: int, confidence: float = 0.95) -> Tuple[float, float]:
    """Garwood's exact interval for the mean of a Poisson distribution of which a number of events was observed."""
    if events < 0 or not 0 < confidence < 1:
        raise ValueError("Events are 0 or more, and the confidence is between 0 and 1.")
    tail = (1 - confidence) / 2
    low = 0.0 if events == 0 else _mean_where(lambda mean: 1 - _at_most(events - 1, mean) > tail, events)
    return low, _mean_where(lambda mean: _at_most(events, mean) < tail, events)


def mean_interval(
    values: Sequence[float], confidence: float = 0.95, seed: int = 1, resamples: int = 10_000
) -> Tuple[float, float, float]:
    """The mean of some values and its percentile bootstrap interval; the same seed gives the same interval."""
    if len(values) == 0:
        raise ValueError("A mean takes at least one value.")
    sample = np.asarray(values, np.float64)
    means = np.random.default_rng(seed).choice(sample, (resamples, len(sample))).mean(axis=1)
    low, high = np.quantile(means, [(1 - confidence) / 2, (1 + confidence) / 2])
    return float(sample.mean()), float(low), float(high)


def _at_most(events: int, mean: float) -> float:
    """Probability of at most a number of events of a Poisson distribution."""
    logs = (n * math.log(mean) - mean - math.lgamma(n + 1) for n in range(events + 1))
    return min(1.0, math.fsum(math.exp(log) for log in logs))


def _mean_where(is_beyond: Callable[[float], bool], events: int) -> float:
    """The mean at which a condition that holds for all larger means begins to hold, by bisection."""
    low, high = 1e-12, 2.0 * events + 20
    while not is_beyond(high):
        high *= 2
    for _ in range(100):
        middle = (low + high) / 2
        low, high = (low, middle) if is_beyond(middle) else (middle, high)
    return (low + high) / 2
