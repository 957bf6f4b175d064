"""Lets a network drive through the bridge, and judges the drive by the truth of the game: drive.py MODEL [--kilometres K].

The network sees the images of harvester serve --lockstep, and answers with indicators, by which the game's Stanley controller drives; or,
if it is a policy, which also gets the speed and the route command, with steering and pedals. In junctions the built-in driver takes over.
Run again, it continues with the first town that is not done.
"""
from __future__ import annotations

import argparse
import json
import os
import sys
from pathlib import Path
from typing import Any, Dict, List, Optional, Tuple

import numpy as np
import torch

from gtaharvest.gym import BridgeError, DrivingEnv, Ending, poisson_interval

import filmstrip
from arguments import model_file, output_file, output_image, positive, positive_real
from commands import STOPPED
from drivers import Driver, load_driver
from judge import Judge
from network import NetworkError
from progress import Progress, ProgressError
from sets import TRAINING_WEATHERS

FIRST_TOWN = 301
STANDING_SECONDS = 120
SHOWN_METRES = 100


def drive(
    driver: Driver, env: DrivingEnv, town: int, weather: str, time_of_day: str, metres: float, seconds: float
) -> Tuple[Dict[str, Any], Optional[np.ndarray]]:
    """Drives in a town until the driver has driven so far outside junctions; returns the figures and a picture for the film strip."""
    observation, info = env.reset(seed=town, options={"town": town, "weather": weather, "timeOfDay": time_of_day})
    judge, ended, reason = Judge(info["frame"], metres), False, "metres"
    picture: Optional[np.ndarray] = None
    begun = info["frame"]["timeSeconds"]
    while not ended and judge.driver_metres < metres and info["frame"]["timeSeconds"] - begun < seconds:
        answer = driver.answer(observation, info["frame"])
        if picture is None and judge.driver_metres > SHOWN_METRES and not info["frame"]["builtInDriver"]:
            picture = filmstrip.picture_of(
                observation, info["frame"], answer if driver.action == "indicators" else None
            )
        observation, _, terminated, truncated, info = env.step(answer)
        judge.take(info["frame"])
        ended = terminated or truncated
        reason = str(info["ending"]) if ended else reason
    figures = {
        "town": town,
        "weather": weather,
        "time": time_of_day,
        "ending": reason if ended or judge.driver_metres >= metres else "seconds",
        "seconds": round(info["frame"]["timeSeconds"] - begun, 1),
        **judge.figures(),
    }
    return figures, picture


def total_of(episodes: List[Dict[str, Any]]) -> Dict[str, Any]:
    """The sums over all episodes, the departures per kilometre with their interval of 95 %, and the mean score. What is per distance is
    None without any.
    """
    metres = sum(episode["driverMetres"] for episode in episodes)
    departures = sum(len(episode["departures"]) for episode in episodes)
    collisions = {kind: sum(episode["collisions"][kind] for episode in episodes) for kind in episodes[0]["collisions"]}
    in_lane = sum(episode["inLaneMetres"] for episode in episodes)
    squares = sum(episode["rmsOffsetMetres"] ** 2 * episode["inLaneMetres"] for episode in episodes)
    return {
        "driverMetres": round(metres, 1),
        "departures": departures,
        "departuresPerKilometre": round(departures / metres * 1000, 3) if metres > 0 else None,
        "interval": [round(bound / metres * 1000, 3) for bound in poisson_interval(departures)] if metres > 0 else None,
        "score": round(sum(episode["score"] for episode in episodes) / len(episodes), 1),
        "collisions": collisions,
        "inLaneMetres": round(in_lane, 1),
        "rmsOffsetMetres": round((squares / in_lane) ** 0.5, 3) if in_lane > 0 else None,
    }


def main() -> int:
    """Runs the command line."""
    parser = argparse.ArgumentParser(
        description="Lets a network drive in towns that it has not seen, and judges the drive.",
        epilog="The file of the figures with the suffix .progress has the towns that are done. The same command, run again, drives only "
        "in the others, in none if the drive is complete, and writes figures and film strip. Another drive needs another --out. Delete the "
        "file to start over.",
    )
    parser.add_argument("model", type=model_file, help="file of train.py or imitate.py")
    parser.add_argument(
        "--kilometres", type=positive_real, default=5, help="distance outside junctions, over all towns; default: 5"
    )
    parser.add_argument("--towns", type=positive, default=10, help="number of towns; default: 10")
    parser.add_argument("--first-town", type=int, default=FIRST_TOWN, help=f"seed of the first; default: {FIRST_TOWN}")
    parser.add_argument(
        "--weathers",
        nargs="+",
        default=list(TRAINING_WEATHERS),
        help="weathers, in turn; default: those of the training",
    )
    parser.add_argument("--traffic", type=float, default=0.5, help="factor on the number of vehicles; default: 0.5")
    parser.add_argument(
        "--seconds", type=positive_real, default=600, help="time limit for each town, seconds of the game; default: 600"
    )
    parser.add_argument("--roads", help="road network of the game in place of towns, with --near")
    parser.add_argument("--near", help="start on the road network, as X,Y")
    parser.add_argument(
        "--out", type=output_file, help="file for the figures; default: the model's name with .drive.json"
    )
    parser.add_argument(
        "--strip", type=output_image, help="image to write a film strip to, .png or .jpg, with an image of each town"
    )
    parser.add_argument("--harvester", help="command that runs harvester; default: GTAHARVEST_HARVESTER, or harvester")
    options = parser.parse_args()
    torch.set_num_threads(1)
    roads = ["--roads", options.roads] if options.roads else []
    near = [f"--near={options.near}"] if options.near else []
    out = options.out or options.model.with_suffix(".drive.json")
    try:
        driver = load_driver(options.model)
        set_by = {
            key: value for key, value in vars(options).items() if key not in ("model", "out", "strip", "harvester")
        }
        roads_file = Path(options.roads) if options.roads else None
        progress = Progress(out.with_suffix(".progress"), options.model, set_by, roads_file)
        if progress.done:
            print(f"{len(progress.done)} of {options.towns} towns are done.", flush=True)
        ending = Ending(collision=False, outside_seconds=None, seconds=None, standing_seconds=STANDING_SECONDS)
        with DrivingEnv(
            "image",
            driver.action,
            ending=ending,
            traffic=options.traffic,
            assisted=True,
            harvester=options.harvester,
            serve_options=["--controller", "stanley", *roads, *near],
        ) as env:
            for number in range(len(progress.done), options.towns):
                weather = options.weathers[number % len(options.weathers)]
                figures, picture = drive(
                    driver,
                    env,
                    options.first_town + number,
                    weather,
                    f"{(8 + 5 * number) % 24:02}:30",
                    options.kilometres * 1000 / options.towns,
                    options.seconds,
                )
                progress.add(figures, picture)
                print(json.dumps({**figures, "departures": len(figures["departures"])}), flush=True)
    except (BridgeError, NetworkError, OSError, ProgressError) as problem:
        print(f"drive.py: {problem}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("drive.py: stopped; run the same command again to continue.", file=sys.stderr)
        return STOPPED
    episodes = [figures for figures, _ in progress.done]
    total = total_of(episodes)
    part = out.with_suffix(".part")
    result = {"model": options.model.name, **progress.drive, "total": total, "episodes": episodes}
    part.write_text(json.dumps(result, indent=1) + "\n", encoding="utf-8")
    os.replace(part, out)
    print(json.dumps(total))
    if options.strip:
        try:
            filmstrip.write(options.strip, [picture for _, picture in progress.done if picture is not None])
        except OSError as problem:
            print(f"drive.py: {problem}", file=sys.stderr)
            return 1
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
