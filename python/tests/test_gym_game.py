"""The environment with the simulated game. Needs GTAHARVEST_HARVESTER, as tests/Python/run sets it."""

from __future__ import annotations

import hashlib
import importlib
import inspect
import json
import os
import signal
import warnings
from pathlib import Path
from typing import Any, Iterator, List

import numpy as np
import pytest

from gtaharvest import gym
from gtaharvest.gym import spaces
from gtaharvest.gym.server import HARVESTER_VARIABLE

SIZE = (64, 48)
SLOPE_METRES = 0.1  # The origin of a car on a slope is not exactly above the point of the road on which it was put.
ENDLESS = gym.Ending(collision=False, outside_seconds=None, seconds=None, standing_seconds=None)

pytestmark = pytest.mark.skipif(
    HARVESTER_VARIABLE not in os.environ, reason=f"needs {HARVESTER_VARIABLE}; run tests/Python/run"
)


def create(**options: Any) -> gym.DrivingEnv:
    return gym.DrivingEnv(**{"size": SIZE, "traffic": 0.3, "ending": ENDLESS, **options})


@pytest.fixture(scope="module")
def env() -> Iterator[gym.DrivingEnv]:
    with create(observation="both", render_mode="rgb_array") as shared:
        yield shared


def actions(count: int, seed: int) -> List[Any]:
    random = np.random.default_rng(seed)
    return [np.array([random.uniform(-0.2, 0.2), random.uniform(0, 0.6), 0], np.float32) for _ in range(count)]


def drive(env: gym.DrivingEnv, seed: int, count: int = 30) -> List[Any]:
    """All that an episode gives, as comparable bytes."""
    observation, info = env.reset(seed=seed)
    told = [as_bytes(observation), repr(info)]
    for action in actions(count, seed):
        observation, reward, terminated, truncated, info = env.step(action)
        told += [as_bytes(observation), repr((reward, terminated, truncated, info))]
    return told


def as_bytes(observation: Any) -> bytes:
    return b"".join(
        part.tobytes() for part in (observation.values() if isinstance(observation, dict) else [observation])
    )


def test_same_seed_and_actions_give_the_same_episode(env: gym.DrivingEnv) -> None:
    first, other, again = drive(env, 3), drive(env, 4), drive(env, 3)
    with create(observation="both") as fresh:
        elsewhere = drive(fresh, 3)
    assert first == again == elsewhere
    assert first != other


def test_environments_run_side_by_side() -> None:
    several = gym.SideBySide(2, observation="state", size=SIZE, traffic=0.3, ending=gym.Ending(seconds=0.5))
    try:
        observations, infos = several.reset(seed=5)
        assert [info["seed"] for info in infos] == [5, 6]
        assert not np.array_equal(observations[0], observations[1])
        for _ in range(5):
            _, _, _, truncated, _ = several.step([[0, 0.5, 0]] * 2)
        assert truncated == [True, True]
        assert sorted(several.reset_ended()) == [0, 1]
    finally:
        several.close()


def test_town_weather_and_place_can_be_set(env: gym.DrivingEnv) -> None:
    usual, info = env.reset(seed=3)
    rainy, wet = env.reset(seed=3, options={"weather": "rain", "timeOfDay": "22:00"})
    _, elsewhere = env.reset(seed=3, options={"town": 2})
    x, y, z = info["frame"]["position"]
    _, moved = env.reset(seed=4, options={"position": (x, y, z), "headingDegrees": info["frame"]["headingDegrees"]})
    assert wet["frame"]["position"] == info["frame"]["position"] != elsewhere["frame"]["position"]
    assert usual["image"].mean() > 1.5 * rainy["image"].mean()
    assert moved["frame"]["position"][:2] == pytest.approx([x, y], abs=SLOPE_METRES)


def test_indicators_drive_the_car() -> None:
    with create(observation="state", action="indicators", assisted=True, traffic=0) as env:
        _, info = env.reset(seed=3)
        outside = 0
        for _ in range(150):
            # A network would estimate them from the image.
            _, _, _, _, info = env.step(info["frame"]["torcsEquivalent"])
            outside += info["frame"]["outsideLanes"]
    assert info["frame"]["drivenMetres"] > 60
    assert outside == 0


def test_game_that_is_killed_is_told(env: gym.DrivingEnv) -> None:
    with create(observation="state") as own:
        own.reset(seed=1)
        assert own._server is not None
        os.kill(own._server._process.pid, signal.SIGKILL)
        with pytest.raises(gym.GameEndedError):
            own.step([0, 0, 0])
        own.reset(seed=1)


def test_environments_side_by_side_are_reset_together_after_one_has_failed() -> None:
    side = gym.SideBySide(2, observation="state", size=SIZE, traffic=0.0, ending=ENDLESS)
    try:
        first, _ = side.reset(seed=4)
        with pytest.raises(ValueError):
            side.step([[0, 1, 0], [0, float("nan"), 0]])
        with pytest.raises(RuntimeError, match="call reset"):
            side.step([[0, 1, 0], [0, 1, 0]])
        again = side.reset_ended()
        assert again.keys() == {0, 1} and all(info["frame"]["drivenMetres"] == 0 for _, info in again.values())
        fresh, _ = side.reset(seed=4)
        np.testing.assert_array_equal(fresh, first)
    finally:
        side.close()


def test_game_ends_with_its_environment() -> None:
    own = create(observation="state")
    own.reset(seed=1)
    process = own._server._process
    own.close()
    own.close()
    assert process.returncode == 0


def test_recording_has_the_seed_and_the_town_of_each_restart(tmp_path: Path) -> None:
    with create(observation="image", traffic=0.0, serve_options=["--record", str(tmp_path / "drives")]) as own:
        for options in ({}, {"town": 3}):
            own.reset(seed=7, options=options)
            own.step([0, 0.5, 0])

    infos = [
        json.loads((tmp_path / "drives" / name / "session.json").read_text(encoding="utf-8"))
        for name in ("0001", "0002")
    ]
    assert [(info["seed"], info["settings"]["town"]) for info in infos] == [(7, "1"), (7, "3")]


def test_hung_game_is_told_and_ended() -> None:
    with create(observation="state", patience=1) as own:
        own.reset(seed=1)
        pid = own._server._process.pid
        os.kill(pid, signal.SIGSTOP)
        with pytest.raises(gym.GameHungError):
            own.step([0, 0, 0])
        # The environment ends the game that it has started.
        with pytest.raises(ProcessLookupError):
            os.kill(pid, 0)


needs_gymnasium = pytest.mark.skipif(spaces.gymnasium_module is None, reason="gymnasium is not installed")


@needs_gymnasium
@pytest.mark.parametrize("observation", ["both", "state", "image"])
def test_check_env_of_gymnasium(observation: str) -> None:
    checker = importlib.import_module("gymnasium.utils.env_checker")
    with spaces.gymnasium_module.make(
        "gtaharvest/Driving-v0", observation=observation, size=SIZE
    ) as env, warnings.catch_warnings():
        warnings.simplefilter("error")
        checker.check_env(env.unwrapped)


@needs_gymnasium
def test_vector_environments_of_gymnasium_give_the_same_steps() -> None:
    def digest(mode: str) -> str:
        made = spaces.gymnasium_module.make_vec(
            "gtaharvest/Driving-v0",
            num_envs=2,
            vectorization_mode=mode,
            observation="state",
            ending=gym.Ending(seconds=1),
        )
        result = hashlib.sha256()
        try:
            observations, _ = made.reset(seed=5)
            result.update(observations.tobytes())
            ended = 0
            for _ in range(25):
                observations, rewards, terminated, truncated, _ = made.step(np.tile(np.float32([0.1, 0.5, 0]), (2, 1)))
                result.update(b"".join(part.tobytes() for part in (observations, rewards, terminated, truncated)))
                ended += int(np.sum(truncated))
        finally:
            made.close()
        assert ended >= 2, "the steps go over ends of episodes"
        return result.hexdigest()

    assert digest("sync") == digest("async")


@pytest.mark.skipif(spaces.gymnasium_module is not None, reason="test_check_env_of_gymnasium")
def test_environment_keeps_what_check_env_asks(env: gym.DrivingEnv) -> None:
    """What gymnasium.utils.env_checker.check_env examines, in its order."""
    for space in (env.action_space, *env.observation_space.values()):
        assert space.low.shape == space.high.shape == space.shape and np.all(space.low < space.high)
        assert np.all(np.isfinite(space.low)) and np.all(np.isfinite(space.high))
    # Recommended for actions: symmetric or from 0, and normalised.
    low, high = env.action_space.low, env.action_space.high
    assert np.all((low == 0) | (np.abs(low) == np.abs(high))) and low.min() >= -1 and high.max() <= 1
    assert env.unwrapped is env and not callable(getattr(env, "seed", None))
    parameters = inspect.signature(env.reset).parameters
    assert parameters["seed"].default is None and "options" in parameters and "return_info" not in parameters

    first, info = env.reset(seed=123)
    assert first in env.observation_space and isinstance(info, dict)
    generator = env._np_random.bit_generator.state
    second, _ = env.reset()
    third, _ = env.reset(seed=123)
    assert env._np_random.bit_generator.state == generator
    fourth, _ = env.reset()
    assert (
        as_bytes(first) == as_bytes(third)
        and as_bytes(second) == as_bytes(fourth)
        and as_bytes(first) != as_bytes(second)
    )
    env.reset(seed=456)
    assert env._np_random.bit_generator.state != generator
    env.reset(options={})

    env.action_space.seed(123)
    action = env.action_space.sample()
    assert action in env.action_space
    results = []
    for _ in range(2):
        env.reset(seed=123)
        generator = env._np_random.bit_generator.state
        results.append(env.step(action))
        assert env._np_random.bit_generator.state == generator
    observation, reward, terminated, truncated, info = results[0]
    assert as_bytes(observation) == as_bytes(results[1][0]) and results[0][1:] == results[1][1:]
    assert observation in env.observation_space
    for name, space in env.observation_space.items():
        assert isinstance(observation[name], np.ndarray) and observation[name].dtype == space.dtype
    assert isinstance(reward, float) and np.isfinite(reward)
    assert terminated is False and truncated is False and isinstance(info, dict)
    assert env.render_mode in env.metadata["render_modes"] and env.metadata["render_fps"] > 0
    picture = env.render()
    assert picture.dtype == np.uint8 and picture.ndim == 3 and picture.shape[2] == 3
