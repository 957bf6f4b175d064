"""The environment against games that the tests invent: rewards, ends of episodes, spaces, and everything that can go wrong."""

from __future__ import annotations

from typing import Any, Iterator, List

import numpy as np
import pytest
from fake_game import Answer, FakeGame, Message, frame, frames

from gtaharvest import gym, png
from gtaharvest.gym import spaces


@pytest.fixture
def games() -> Iterator[List[FakeGame]]:
    started: List[FakeGame] = []
    yield started
    for game in started:
        game.close()


def environment(
    games: List[FakeGame], answer: Any, hello: Answer = {"type": "hello", "version": 1}, **options: Any
) -> gym.DrivingEnv:
    games.append(FakeGame(answer, hello))
    return gym.DrivingEnv(address=games[-1].address, **{"observation": "state", "patience": 5, **options})


def test_step_sends_the_action_and_gives_the_state(games: List[FakeGame]) -> None:
    with environment(
        games, frames({1: {"speedMetresPerSecond": 12.5, "route": "left", "routeMetres": 30, "light": "red"}})
    ) as env:
        first, info = env.reset(seed=7)
        state, _, terminated, truncated, _ = env.step([0.25, 0.5, 0])

    named = dict(zip(gym.STATE_NAMES, state))
    assert info["seed"] == 7
    assert first in env.observation_space and state in env.observation_space
    assert (named["speed"], named["routeMetres"], named["route:left"], named["route:right"], named["light:red"]) == (
        12.5,
        30,
        1,
        0,
        1,
    )
    assert (terminated, truncated) == (False, False)
    assert games[0].heard[1:] == [
        {"type": "restart", "seed": 7, "image": False},
        {"type": "controls", "steering": 0.25, "throttle": 0.5, "brake": 0.0},
        {"type": "step", "seconds": 0.1, "image": False},
    ]


def test_indicators_are_sent_as_such(games: List[FakeGame]) -> None:
    with environment(games, frames(), action="indicators") as env:
        env.reset(seed=1)
        env.step(np.arange(13))
        with pytest.raises(ValueError, match="13 finite numbers"):
            env.step([0, 0, 0])
    assert games[0].heard[2] == {"type": "indicators", "values": [float(i) for i in range(13)]}


def test_reward_is_the_sum_of_documented_terms(games: List[FakeGame]) -> None:
    changes = {1: {"laneOffsetMetres": -0.5, "appliedControls": [0.4, 0, 0], "redLightsRun": 1}}
    with environment(games, frames(changes)) as env:
        env.reset(seed=1)
        _, reward, _, _, info = env.step([0.4, 0, 0])

    # One metre at 0.1; 0.5 m beside the centre for it at -0.1 each; a change of steering by 0.4 at -0.05; a red light at -5.
    assert reward == pytest.approx(0.1 - 0.05 - 0.02 - 5)
    assert sum(info["reward"].values()) == pytest.approx(reward)


def test_standing_costs_except_at_a_red_light(games: List[FakeGame]) -> None:
    standing = {"speedMetresPerSecond": 0, "drivenMetres": 0}
    with environment(games, frames({1: standing, 2: {**standing, "light": "red"}})) as env:
        env.reset(seed=1)
        assert env.step([0, 0, 1])[1] == pytest.approx(-0.01)
        assert env.step([0, 0, 1])[1] == pytest.approx(0)


@pytest.mark.parametrize(
    ("ending", "changes", "expected"),
    [
        (gym.Ending(), {3: {"collisions": [0, 0, 1]}}, (3, True, False, "collision")),
        (gym.Ending(collision=False, seconds=0.5), {3: {"collisions": [0, 0, 1]}}, (5, False, True, "seconds")),
        (
            gym.Ending(outside_seconds=0.2),
            {n: {"outsideLanes": True} for n in (1, 3, 4, 5)},
            (5, True, False, "outside"),
        ),
        (gym.Ending(metres=4), {}, (4, False, True, "metres")),
        (
            gym.Ending(standing_seconds=0.3),
            {n: {"speedMetresPerSecond": 0} for n in range(2, 9)},
            (5, False, True, "standing"),
        ),
        (gym.Ending(red_light=True), {2: {"redLightsRun": 1}}, (2, True, False, "red_light")),
        (gym.Ending(stop_sign=True), {2: {"stopSignsRun": 1}}, (2, True, False, "stop_sign")),
        (gym.Ending(), {2: {"repositioned": 1}}, (2, False, True, "repositioned")),
    ],
)
def test_episode_ends_as_configured(games: List[FakeGame], ending: gym.Ending, changes: Any, expected: Any) -> None:
    with environment(games, frames(changes), ending=ending) as env:
        env.reset(seed=1)
        for number in range(1, 20):
            _, _, terminated, truncated, info = env.step([0, 1, 0])
            if terminated or truncated:
                break
    assert (number, terminated, truncated, info["ending"]) == expected


def test_game_without_truth_still_rewards_distance(games: List[FakeGame]) -> None:
    unknown = dict.fromkeys(
        (
            "drivenMetres",
            "collision",
            "collisions",
            "outsideLanes",
            "road",
            "lane",
            "acrossMarking",
            "laneOffsetMetres",
            "laneAngleRadians",
            "redLightsRun",
            "stopSignsRun",
            "repositioned",
            "route",
            "routeMetres",
            "light",
            "stopSign",
            "appliedControls",
            "builtInDriver",
        )
    )
    with environment(games, frames({n: unknown for n in range(9)}), restarts=False) as env:
        env.reset(options={"position": (1, 2, 3), "headingDegrees": 90})
        state, reward, terminated, _, _ = env.step([0, 1, 0])

    assert reward == pytest.approx(0.1 * 10 * 0.1)
    assert not terminated
    assert state in env.observation_space
    assert games[0].heard[1:5] == [
        {"type": "pause", "paused": True},
        {"type": "requestFrame", "image": False},
        {"type": "reset", "position": [1.0, 2.0, 3.0], "headingDegrees": 90.0},
        {"type": "requestFrame", "image": False},
    ]


def test_frames_from_before_the_pause_are_passed_over(games: List[FakeGame]) -> None:
    picture = png.encode(np.zeros((210, 280, 3), np.uint8))

    def answer(message: Message) -> Answer:
        # The game is in real time until it is paused, and sends a frame unasked.
        if message["type"] == "requestFrame" and message["image"]:
            return frame(8), picture
        return {"pause": (frame(5), picture), "requestFrame": frame(7)}.get(message["type"])

    with environment(games, answer, restarts=False, observation="image") as env:
        _, info = env.reset()
    assert info["frame"]["frame"] == 8


def test_frame_of_before_the_step_is_passed_over(games: List[FakeGame]) -> None:
    def answer(message: Message) -> Answer:
        # The controls are answered by a frame that a game in real time has sent meanwhile, the step by that of its end.
        return {"restart": frame(0), "controls": frame(0, speedMetresPerSecond=99), "step": frame(1)}.get(
            message["type"]
        )

    with environment(games, answer) as env:
        env.reset(seed=1)
        state, *_ = env.step([0, 0, 0])
    assert state[0] == 10


def test_image_comes_as_pixels(games: List[FakeGame]) -> None:
    picture = np.arange(4 * 6 * 3, dtype=np.uint8).reshape(4, 6, 3)

    def answer(message: Message) -> Answer:
        count = frames()(message)
        return (count, png.encode(picture)) if isinstance(count, dict) else None

    with environment(games, answer, observation="both", size=(6, 4), render_mode="rgb_array") as env:
        observation, _ = env.reset(seed=1)
        assert observation in env.observation_space
        assert np.array_equal(observation["image"], picture) and np.array_equal(env.render(), picture)
    with environment(games, answer, observation="image", size=(8, 4)) as env, pytest.raises(
        gym.BridgeError, match="images of 6x4"
    ):
        env.reset(seed=1)


def test_picture_is_rendered_on_request(games: List[FakeGame]) -> None:
    picture = np.zeros((4, 6, 3), np.uint8)

    def answer(message: Message) -> Answer:
        return (frame(0), png.encode(picture)) if message["type"] == "requestFrame" else frames()(message)

    with environment(games, answer, size=(6, 4), render_mode="rgb_array") as env:
        env.reset(seed=1)
        assert env.render().shape == (4, 6, 3)


@pytest.mark.parametrize(
    ("hello", "error", "words"),
    [
        ({"type": "hello", "version": 2}, gym.VersionError, "version 2"),
        (
            {"type": "error", "reason": "the client speaks version 1 of the bridge, the game version 2."},
            gym.VersionError,
            "version 2",
        ),
        (
            {"type": "error", "reason": "the first message must be a hello with the right token."},
            gym.GameRefusedError,
            "right token",
        ),
        ({"type": "frame"}, gym.GameRefusedError, "is it the bridge of a game"),
        (b"HTTP/1.1 400 Bad Request\r\n\r\n", gym.GameRefusedError, "is it the bridge of a game"),
        (b"", gym.GameEndedError, "has ended"),
        (None, gym.GameHungError, "has not answered for 0.5 s"),
    ],
)
def test_wrong_hello_is_one_clear_line(games: List[FakeGame], hello: Answer, error: Any, words: str) -> None:
    with environment(games, frames(), hello, patience=0.5) as env, pytest.raises(error, match=words) as caught:
        env.reset(seed=1)
    assert "\n" not in str(caught.value)


@pytest.mark.parametrize(
    ("reply", "error"),
    [
        (None, gym.GameHungError),
        (b"", gym.GameEndedError),
        (b"\0\0\0\x05\0\0\0\0{}", gym.GameEndedError),
        (b"\0\0\0\x02\0\0\0\0]]", gym.GameRefusedError),
        ({"type": "error", "reason": "no"}, gym.GameRefusedError),
    ],
)
def test_game_that_fails_is_told_and_a_reset_begins_anew(games: List[FakeGame], reply: Answer, error: Any) -> None:
    counted = frames()
    broken = [True]

    def answer(message: Message) -> Answer:
        if message["type"] == "step" and broken:
            broken.clear()
            return reply
        return counted(message)

    with environment(games, answer, patience=0.5) as env:
        env.reset(seed=1)
        with pytest.raises(error):
            env.step([0, 0, 0])
        with pytest.raises(RuntimeError, match="call reset"):
            env.step([0, 0, 0])
        env.reset(seed=1)
        env.step([0, 0, 0])


@pytest.mark.parametrize(
    ("fields", "missing", "error", "words"),
    [
        ({}, "fast", gym.VersionError, "without 'fast', as another version does"),
        ({}, "acrossMarking", gym.VersionError, "without 'acrossMarking'"),
        ({"speedMetresPerSecond": "fast"}, "", gym.GameRefusedError, "malformed 'speedMetresPerSecond': 'fast'"),
        ({"position": 5}, "", gym.GameRefusedError, "malformed 'position': 5"),
        ({"indicators": [0] * 12}, "", gym.GameRefusedError, "malformed 'indicators'"),
    ],
)
def test_malformed_frame_is_one_clear_line(
    games: List[FakeGame], fields: Message, missing: str, error: Any, words: str
) -> None:
    counted = frames()

    def answer(message: Message) -> Answer:
        reply = counted(message)
        assert isinstance(reply, dict)
        return {name: value for name, value in {**reply, **fields}.items() if name != missing}

    with environment(games, answer) as env, pytest.raises(error, match=words) as caught:
        env.reset(seed=1)
    assert "\n" not in str(caught.value)


def test_game_whose_start_is_interrupted_is_ended(monkeypatch: pytest.MonkeyPatch) -> None:
    serving = ["sh", "-c", "echo Serving at 127.0.0.1:9; exec sleep 60"]

    def interrupted(*_: Any) -> None:
        raise KeyboardInterrupt

    monkeypatch.setattr("gtaharvest.gym.env.BridgeLink", interrupted)
    monkeypatch.setattr("gtaharvest.gym.server._ENDING_SECONDS", 0.1)
    with gym.DrivingEnv(harvester=serving) as env:
        with pytest.raises(KeyboardInterrupt):
            env.reset(seed=1)
        assert env._server is None


def test_nobody_at_the_port_is_told() -> None:
    env = gym.DrivingEnv(address=("127.0.0.1", 9))
    with pytest.raises(gym.GameStartError, match="Cannot connect to a game at 127.0.0.1:9"):
        env.reset()


def test_missing_harvester_is_told() -> None:
    with gym.DrivingEnv(harvester=["no-such-harvester"]) as env, pytest.raises(
        gym.GameStartError, match="Cannot start 'no-such"
    ):
        env.reset()


def test_harvester_that_ends_is_told_with_its_error() -> None:
    failing = ["sh", "-c", "echo the reason >&2; exit 3"]
    with gym.DrivingEnv(harvester=failing) as env, pytest.raises(gym.GameStartError, match="code 3: the reason"):
        env.reset()


def test_harvester_that_hangs_is_ended() -> None:
    with gym.DrivingEnv(harvester=["sh", "-c", "exec sleep 60"], start_patience=0.2) as env, pytest.raises(
        gym.GameStartError, match="within 0.2 s"
    ):
        env.reset()


def test_wrong_arguments_are_refused(games: List[FakeGame]) -> None:
    for wrong in (
        {"observation": "sound"},
        {"action": "thoughts"},
        {"step_seconds": 0},
        {"render_mode": "human"},
        {"patience": 0},
        {"start_patience": -1},
    ):
        with pytest.raises(ValueError):
            gym.DrivingEnv(**wrong)
    with environment(games, frames()) as env:
        with pytest.raises(RuntimeError, match="call reset"):
            env.step([0, 0, 0])
        with pytest.raises(ValueError, match="fuel"):
            env.reset(options={"fuel": 1})
        env.reset()
        with pytest.raises(ValueError, match="finite"):
            env.step([float("nan"), 0, 0])


def test_plain_spaces_sample_within_their_bounds() -> None:
    box = spaces.PlainBox([-1, 0], [1, 2], dtype=np.float32)
    both = spaces.PlainDict({"a": box, "b": spaces.PlainBox(0, 255, (2, 3), np.uint8)})
    both.seed(3)
    first = both.sample()
    assert all(both.sample() in both for _ in range(50))
    both.seed(3)
    assert all(np.array_equal(first[name], again) for name, again in both.sample().items())
    assert np.array([0, 3], np.float32) not in box and np.array([0, 1], np.float64) not in box and [0, 1] not in box
    assert {"a": first["a"]} not in both


def test_step_after_an_interrupted_one_is_refused_and_reset_connects_anew(games: List[FakeGame]) -> None:
    with environment(games, frames({}), render_mode="rgb_array") as env:
        env.reset(seed=1)
        with pytest.raises(RuntimeError, match="send_step"):
            env.receive_step()
        env.send_step([0, 1, 0])
        for refused in (lambda: env.send_step([0, 1, 0]), env.render):
            with pytest.raises(RuntimeError, match="call reset"):
                refused()
        _, info = env.reset(seed=2)
        # The interrupted step's frame would have been the one at 0.1 s.
        assert info["frame"]["timeSeconds"] == 0
        assert [message["type"] for message in games[0].heard].count("hello") == 2
        env.step([0, 1, 0])


def test_bad_action_has_not_been_sent(games: List[FakeGame]) -> None:
    with environment(games, frames({})) as env:
        env.reset(seed=1)
        with pytest.raises(ValueError, match="3 finite numbers"):
            env.step([0, float("nan"), 0])
        _, _, _, _, info = env.step([0, 1, 0])
    assert info["frame"]["frame"] == 1


@pytest.mark.parametrize(
    "options, message",
    [
        ({"town": 3}, "can be restarted"),
        ({"headingDegrees": 90}, "needs the option position"),
        ({"colour": 1}, "colour"),
    ],
)
def test_reset_refuses_options_without_effect(games: List[FakeGame], options: Message, message: str) -> None:
    with environment(games, frames({}), restarts=False) as env, pytest.raises(ValueError, match=message):
        env.reset(options=options)


def test_measured_numbers_are_floats_also_if_whole(games: List[FakeGame]) -> None:
    with environment(games, frames({})) as env:
        _, info = env.reset(seed=1)
    seen = info["frame"]
    assert all(isinstance(seen[name], float) for name in ("speedMetresPerSecond", "headingDegrees", "drivenMetres"))
    assert all(isinstance(number, float) for name in ("position", "indicators") for number in seen[name])
    assert isinstance(seen["frame"], int) and isinstance(seen["redLightsRun"], int)


def test_images_per_second_follow_the_step(games: List[FakeGame]) -> None:
    with environment(games, frames({}), step_seconds=0.05) as env:
        assert env.metadata["render_fps"] == 20
    assert gym.DrivingEnv.metadata["render_fps"] == 10
