"""Steps per second of the environment, and whether the same seeds and actions give the same frames.

PYTHONPATH=python/src GTAHARVEST_HARVESTER=COMMAND python3 bench/python/gym_speed.py [--observation state] [--steps 2000] [--repeat 2]

The car drives by the indicators that the game sends, with the built-in driver in junctions. Processor times are those of the game's process
and of this one; they count on a busy machine too. Linux only.
"""

import argparse
import hashlib
import json
import os
import time

from gtaharvest import gym


def game_seconds(env: gym.DrivingEnv) -> float:
    with open(f"/proc/{env._server._process.pid}/stat", encoding="ascii") as file:
        fields = file.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def drive(env: gym.DrivingEnv, seed: int, steps: int) -> str:
    """The hash of all frames."""
    digest = hashlib.sha256()
    _, info = env.reset(seed=seed)
    for _ in range(steps):
        observation, _, terminated, truncated, info = env.step(info["frame"]["torcsEquivalent"])
        digest.update(json.dumps(info["frame"]).encode())
        if isinstance(observation, dict):
            digest.update(observation["image"])
        if terminated or truncated:
            _, info = env.reset()
    return digest.hexdigest()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--observation", default="state", choices=("both", "image", "state"))
    parser.add_argument("--steps", type=int, default=2000)
    parser.add_argument(
        "--repeat", type=int, default=2, help="times that the same episodes are driven, each in the same game"
    )
    parser.add_argument("--traffic", type=float, default=1.0)
    parser.add_argument("--traffic-radius", type=float, default=200.0)
    parser.add_argument("--seed", type=int, default=5)
    arguments = parser.parse_args()
    with gym.DrivingEnv(
        observation=arguments.observation,
        action="indicators",
        assisted=True,
        traffic=arguments.traffic,
        traffic_radius=arguments.traffic_radius or None,
    ) as env:
        drive(env, 1, min(arguments.steps, 500))
        hashes = []
        for _ in range(arguments.repeat):
            wall, own, game = time.perf_counter(), time.process_time(), game_seconds(env)
            hashes.append(drive(env, arguments.seed, arguments.steps))
            wall, own, game = time.perf_counter() - wall, time.process_time() - own, game_seconds(env) - game
            print(
                f"{arguments.steps / wall:.0f} steps/s; processor time per step: {1e6 * game / arguments.steps:.0f} us of the game, "
                f"{1e6 * own / arguments.steps:.0f} us of this process; {hashes[-1][:16]}",
                flush=True,
            )
    if len(set(hashes)) != 1:
        raise SystemExit("The same seed and actions gave other frames.")


if __name__ == "__main__":
    main()
