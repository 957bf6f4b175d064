"""Games that send anything: a step ends in an observation within its space, or in a BridgeError, which is one line."""

from __future__ import annotations

import json
import os
import random
import struct
import warnings
from typing import Any, Iterator, List

import mutation
import numpy as np
import pytest
from fake_game import FakeGame, Message, frame

from gtaharvest import gym, png

CASES = int(os.environ.get("GTAHARVEST_FUZZ_CASES", "1500"))
SEED = int(os.environ.get("GTAHARVEST_FUZZ_SEED", "20260101"))
SIZE = (6, 4)
PICTURE = png.encode(np.zeros((SIZE[1], SIZE[0], 3), np.uint8))


@pytest.fixture
def games() -> Iterator[List[FakeGame]]:
    started: List[FakeGame] = []
    yield started
    for game in started:
        game.close()


def packed(header: Any, payload: bytes) -> bytes:
    text = header if isinstance(header, bytes) else json.dumps(header).encode("utf-8", "surrogatepass")
    return struct.pack(">II", len(text), len(payload)) + text + payload


def damaged(number: int, chance: random.Random) -> bytes:
    """The answer to a step: a frame with a damaged header, text or image, or another message."""
    sound = frame(number, light="red", route="left", routeMetres=20)
    kind = chance.randrange(5)
    if kind < 2:
        return packed(mutation.of_json(sound, chance), PICTURE)
    if kind == 2:
        return packed(mutation.of_bytes(json.dumps(sound).encode(), chance), PICTURE)
    if kind == 3:
        return packed(sound, mutation.of_bytes(PICTURE, chance))
    reason = chance.choice(["no\nmore", None, ["x"], "x" * 5000])
    return packed({"type": chance.choice(["error", "frame", "", None, 7]), "reason": reason}, b"")


def test_mutated_frames_never_escape(games: List[FakeGame]) -> None:
    chance = random.Random(SEED)
    refused = 0
    number = 0

    def answer(message: Message) -> Any:
        nonlocal number
        if message["type"] == "restart":
            number = 0
            return frame(0), PICTURE
        if message["type"] != "step":
            return None
        number += 1
        # Raw bytes end the connection, as a game that is gone.
        return damaged(number, chance)

    games.append(FakeGame(answer))
    with warnings.catch_warnings(), gym.DrivingEnv(address=games[0].address, size=SIZE, patience=20) as env:
        warnings.simplefilter("error")
        for case in range(CASES):
            env.close()
            env.reset(seed=case)
            try:
                observation, reward, _, _, info = env.step([0, 1, 0])
            except gym.BridgeError as problem:
                refused += 1
                assert str(problem).isprintable() and len(str(problem)) < 1000
                continue
            except BaseException as escaped:
                raise AssertionError(f"seed {SEED}, case {case}: {escaped!r}") from escaped
            assert observation in env.observation_space, info["frame"]
            assert np.isfinite(reward)
    print(f"{refused} of {CASES} cases were refused")
    assert CASES / 4 < refused < CASES


@pytest.mark.parametrize("value", [float("nan"), float("inf"), -float("inf"), 1e300, 10**400, "fast", [1], {}])
def test_speed_that_is_no_number_is_refused(games: List[FakeGame], value: Any) -> None:
    games.append(FakeGame(lambda message: frame(0, speedMetresPerSecond=value)))
    with gym.DrivingEnv("state", address=games[0].address, patience=20) as env, pytest.raises(gym.GameRefusedError):
        env.reset(seed=1)


@pytest.mark.parametrize(
    "image",
    [
        PICTURE[:33] + struct.pack(">I", 0x7FFFFFFF) + PICTURE[37:] + bytes(19_000),
        PICTURE[:16] + struct.pack(">II", 65_535, 65_535) + PICTURE[24:],
        b"%!PS-Adobe-3.0 EPSF-3.0\n",
        b"BM" + bytes(60),
        b"",
    ],
)
def test_malformed_image_ends_the_step_at_once(games: List[FakeGame], image: bytes) -> None:
    games.append(FakeGame(lambda message: (frame(0), image)))
    with gym.DrivingEnv("image", size=SIZE, address=games[0].address, patience=20) as env, pytest.raises(
        gym.BridgeError
    ):
        env.reset(seed=1)


def test_large_image_is_received_within_the_patience(games: List[FakeGame]) -> None:
    """Received piece by piece into a text that is copied for each piece, 200 MB would take minutes."""
    games.append(FakeGame(lambda message: (frame(0), bytes(200_000_000))))
    with gym.DrivingEnv("image", size=SIZE, address=games[0].address, patience=60) as env:
        with pytest.raises(gym.BridgeError, match="not a PNG"):
            env.reset(seed=1)


@pytest.mark.parametrize("seed", [-1, 2**31, 2**63, 1.5, "7"])
def test_seed_out_of_range_is_refused(seed: Any) -> None:
    with gym.DrivingEnv(address=("127.0.0.1", 9)) as env, pytest.raises(ValueError, match="from 0 to 2147483647, not"):
        env.reset(seed=seed)
    with pytest.raises(ValueError, match="town is a whole number from 0 to 2147483647"):
        gym.DrivingEnv(town=seed)


def test_true_drive_in_some_frames_alone_is_refused(games: List[FakeGame]) -> None:
    def answer(message: Message) -> Any:
        return {"restart": frame(0), "step": frame(1, drivenMetres=None)}.get(message["type"])

    games.append(FakeGame(answer))
    with gym.DrivingEnv("state", address=games[0].address, patience=20) as env:
        env.reset(seed=1)
        with pytest.raises(gym.GameRefusedError, match="in some frames"):
            env.step([0, 0, 0])
