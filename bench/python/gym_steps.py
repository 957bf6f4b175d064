"""Steps an environment and prints a digest of its frames: gym_steps.py [--steps N] [--seed S]

Two runs with the same options print the same digests, at every tenth of the steps and at the end. Actions are drawn from the seed; an episode
ends after 60 s of the game or when the environment ends it. Only the state is observed. Needs PYTHONPATH=python/src and the environment
variable GTAHARVEST_HARVESTER, or harvester on the PATH.
"""
from __future__ import annotations

import argparse
import hashlib
import json
import time

import numpy as np

from gtaharvest.gym import DrivingEnv, Ending


def main() -> None:
    """Runs the command line."""
    parser = argparse.ArgumentParser(description="Steps an environment and prints digests of its frames.")
    parser.add_argument("--steps", type=int, default=1_000_000, help="number of steps; default: 1000000")
    parser.add_argument("--seed", type=int, default=1, help="seed of the episodes and the actions; default: 1")
    options = parser.parse_args()
    random, digest, begun = np.random.default_rng(options.seed), hashlib.sha256(), time.monotonic()
    episodes = 0
    with DrivingEnv("state", ending=Ending(seconds=60)) as env:
        _, info = env.reset(seed=options.seed)
        for step in range(1, options.steps + 1):
            # Mostly straight on, so that the car gets somewhere.
            action = np.array([random.normal(0, 0.05), random.uniform(0, 0.6), 0.0], np.float32)
            _, reward, terminated, truncated, info = env.step(action)
            digest.update(json.dumps([info["frame"], reward], sort_keys=True).encode())
            if terminated or truncated:
                episodes += 1
                _, info = env.reset()
                digest.update(json.dumps(info["frame"], sort_keys=True).encode())
            if step % max(1, options.steps // 10) == 0:
                rate = step / (time.monotonic() - begun)
                print(f"{step} steps, {episodes} episodes ended, {digest.hexdigest()}, {rate:.0f} steps/s", flush=True)


if __name__ == "__main__":
    main()
