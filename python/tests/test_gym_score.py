"""The driving score against hand arithmetic that the tests of the C# library read too, and counters against invented frames."""

from __future__ import annotations

import csv
import math
from pathlib import Path
from typing import Dict, List

import numpy as np
import pytest
from fake_game import frame

from gtaharvest import gym

VECTORS = Path(__file__).parents[2] / "tests" / "Runs.Tests" / "Evaluation" / "Scores"

with (VECTORS.parent / "Figures" / "lane-keeping.csv").open(encoding="utf-8", newline="") as stream:
    PLACES = list(csv.DictReader(stream))

ROUNDED = 5e-5
"""The published intervals have four decimals."""


def rows(name: str) -> List[Dict[str, float]]:
    with (VECTORS / name).open(encoding="utf-8", newline="") as stream:
        return [{key: float(value) for key, value in row.items()} for row in csv.DictReader(stream)]


@pytest.mark.parametrize("row", rows("driving-scores.csv"))
def test_score_is_completion_times_penalties(row: Dict[str, float]) -> None:
    episode = gym.Episode(
        row["wanted"],
        row["driven"],
        row["outside"],
        vehicle_collisions=int(row["vehicle"]),
        parked_collisions=int(row["parked"]),
        pedestrian_collisions=int(row["pedestrian"]),
        red_lights=int(row["red"]),
        stop_signs=int(row["stop"]),
    )
    assert episode.route_completion == pytest.approx(row["completion"])
    assert episode.penalty == pytest.approx(row["penalty"])
    assert gym.driving_score(episode) == pytest.approx(row["score"])


@pytest.mark.parametrize("row", rows("poisson-intervals.csv"))
def test_poisson_intervals_are_those_of_the_tables(row: Dict[str, float]) -> None:
    assert gym.poisson_interval(int(row["events"])) == pytest.approx((row["low"], row["high"]), abs=ROUNDED)


@pytest.mark.parametrize("drive", sorted({row["drive"] for row in PLACES}))
def test_departures_begin_where_the_file_says(drive: str) -> None:
    rows = [row for row in PLACES if row["drive"] == drive]
    keeping, moves = gym.LaneKeeping(), 0
    for number, row in enumerate(rows):
        moves += int(row["moved"])
        keeping.take(
            frame(
                number,
                road=int(row["road"]) if row["road"] else None,
                lane=int(row["lane"]) if row["lane"] else None,
                outsideLanes=row["beyond"] == "1",
                acrossMarking=row["across"] == "1",
                builtInDriver=row["controller"] == "0",
                repositioned=moves,
            )
        )

    assert [begun["frame"] for begun in keeping.departures] == [
        number for number, row in enumerate(rows) if row["departs"] == "1"
    ]


def test_counters_are_differences_between_frames() -> None:
    before = {"collisions": [1, 0, 2], "redLightsRun": 3, "stopSignsRun": 1, "repositioned": 1}
    after = {"collisions": [2, 0, 2], "redLightsRun": 5, "stopSignsRun": 1, "repositioned": 2}
    outside = {"outsideLanes": True}
    episode = gym.Episode.of(
        [
            frame(10, **before),
            frame(11, **before, **outside),
            frame(13, **before, **outside),
            frame(14, **before),
            frame(15, **before, **outside, builtInDriver=True),
            frame(20, **after),
        ],
        wanted_metres=40,
    )

    # The fake car drives a metre per number: 1 + 2 outside in one departure of the client, and 1 of the built-in driver.
    assert (episode.driven_metres, episode.outside_metres, episode.judged_metres, episode.lane_departures) == (
        10,
        4,
        9,
        1,
    )
    assert episode.seconds == pytest.approx(1)
    assert (episode.vehicle_collisions, episode.parked_collisions, episode.pedestrian_collisions) == (1, 0, 0)
    assert (episode.red_lights, episode.stop_signs, episode.repositioned) == (2, 0, 1)
    assert gym.driving_score(episode) == pytest.approx(100 * 0.25 * 0.6 * 0.7**2 * 0.6)


def test_rates_count_the_events_of_all_episodes() -> None:
    rates = gym.rates_per_km([gym.Episode(1000, 1000, red_lights=1), gym.Episode(1000, 3000, red_lights=1)])
    low, high = gym.poisson_interval(2)
    assert rates["red_lights"] == (2, 4, 0.5, pytest.approx(low / 4), pytest.approx(high / 4))
    assert rates["lane_departures"].kilometres == 0
    judged = gym.rates_per_km([gym.Episode(1000, 1000, judged_metres=500, lane_departures=1)])
    assert judged["lane_departures"][:3] == (1, 0.5, 2)
    assert math.isnan(gym.rates_per_km([gym.Episode(1000)])["red_lights"].per_km)


def test_mean_interval_holds_the_mean_of_normal_values() -> None:
    values = list(np.random.default_rng(5).normal(80, 10, 400))
    mean, low, high = gym.mean_interval(values)

    # 1.96 · 10 / √400 = 0.98 on either side; the sample's own deviation and the resampling change it by some hundredths.
    assert mean == pytest.approx(np.mean(values))
    assert (mean - low, high - mean) == (pytest.approx(0.98, abs=0.12), pytest.approx(0.98, abs=0.12))
    assert gym.mean_interval(values) == (mean, low, high)


def test_frames_without_counters_are_refused() -> None:
    with pytest.raises(ValueError, match="only the simulated game"):
        gym.Episode.of([frame(0, drivenMetres=None)], 100)
    with pytest.raises(ValueError, match="at least one frame"):
        gym.Episode.of([], 100)
    with pytest.raises(ValueError, match="greater than 0"):
        gym.EpisodeCounter(0)


def test_lane_keeping_refuses_frames_that_do_not_say_it() -> None:
    with pytest.raises(ValueError, match="does not say whether the car has left its lane"):
        gym.LaneKeeping().take(frame(0, outsideLanes=None, acrossMarking=None))


def test_mean_interval_takes_arrays() -> None:
    assert gym.mean_interval(np.array([50.0, 50.0])) == (50, 50, 50)
    with pytest.raises(ValueError, match="at least one value"):
        gym.mean_interval(np.array([]))
