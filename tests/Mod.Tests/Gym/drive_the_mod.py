"""Drives the game that a test serves, as a learner does: drive_the_mod.py PORT STEPS. Prints what it gets as lines of JSON."""

import json
import sys

import numpy as np

from gtaharvest import gym


def tell(**what):
    print(json.dumps(what), flush=True)


def tell_frame(env, observation, info, **more):
    image, state = observation["image"], observation["state"]
    tell(
        shapes=[list(image.shape), list(state.shape)],
        types=[str(image.dtype), str(state.dtype)],
        isInSpace=observation in env.observation_space,
        levels=[int(image.min()), int(image.max())],
        state=dict(zip(gym.STATE_NAMES, map(float, state))),
        seconds=info["frame"]["timeSeconds"],
        position=info["frame"]["position"],
        heading=info["frame"]["headingDegrees"],
        **more,
    )


def main(port, steps):
    ending = gym.Ending(seconds=None, standing_seconds=None)
    env = gym.DrivingEnv(address=("127.0.0.1", port), restarts=False, observation="both", ending=ending)
    observation, info = env.reset(options={"position": (100, 190, 0.6), "headingDegrees": 0})
    tell_frame(env, observation, info)
    for step in range(steps):
        action = np.array([(step % 64 - 32) / 64, 0.5, 0], np.float32)
        observation, reward, terminated, truncated, info = env.step(action)
        tell_frame(env, observation, info, steering=float(action[0]), reward=reward, ended=[terminated, truncated])
    tell(state="driven")
    errors = []
    try:
        while True:
            env.step([0, 0, 1])
    except gym.BridgeError as problem:
        errors.append(type(problem).__name__)
    try:
        env.reset()
    except gym.BridgeError as problem:
        errors.append(type(problem).__name__)
    tell(errors=errors)


main(int(sys.argv[1]), int(sys.argv[2]))
