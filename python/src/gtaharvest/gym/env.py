"""The environment."""

from __future__ import annotations

import operator
import time
from typing import Any, Dict as DictOf, List, Optional, Sequence, Tuple, Union

import numpy as np
import numpy.typing as npt

from .. import png as pngs
from ..lanes import INDICATOR_NAMES
from .errors import BridgeError, GameEndedError, GameHungError, GameRefusedError
from .frame_header import Header
from .link import BridgeLink
from .rewards import Reward
from .rules import Ending, Rules
from .server import GameServer
from .spaces import Box, Dict, Env
from .state import STATE_HIGH, STATE_LOW, state_of

Array = npt.NDArray[Any]
StepResult = Tuple[Any, float, bool, bool, DictOf[str, Any]]

_OBSERVATIONS = ("both", "image", "state")
_ACTIONS = ("controls", "indicators")
_RGB = (3, 8)
_MAX_SEED = 2**31 - 1
_INDICATOR_LOW = np.array(
    [-np.pi if name == "angle" else 0 if name.startswith("dist") else -20 for name in INDICATOR_NAMES], np.float32
)
_INDICATOR_HIGH = np.array(
    [np.pi if name == "angle" else 100 if name.startswith("dist") else 20 for name in INDICATOR_NAMES], np.float32
)


class DrivingEnv(Env):
    """A car in the simulated game, or in GTA V. The same seed and actions give the same observations in the simulated game.

    | | |
    |---|---|
    | action space | `Box([-1, 0, 0], [1, 1, 1], (3,), float32)`: steering, throttle, brake; or the 13 indicators |
    | observation space | `Dict` of `image`, `Box(0, 255, (210, 280, 3), uint8)`, and `state`, a `Box` of float32; or one of them |
    | reward | weighted sum of the terms of `Reward` |
    | terminated | collision, more than a second outside the lanes (`Ending`) |
    | truncated | 120 s, a minute standing, or the game has put the car elsewhere (`Ending`) |
    | version | v0, in 0.1.0 |

    docs/gym.md documents the terms, the numbers of the state, seeds and errors.
    """

    metadata = {"render_modes": ["rgb_array"], "render_fps": 10}

    def __init__(
        self,
        observation: str = "both",
        action: str = "controls",
        step_seconds: float = 0.1,
        reward: Reward = Reward(),
        ending: Ending = Ending(),
        size: Tuple[int, int] = (280, 210),
        town: int = 1,
        traffic: float = 1.0,
        traffic_radius: Optional[float] = 200.0,
        weather: str = "clear",
        assisted: bool = False,
        serve_options: Sequence[str] = (),
        harvester: Union[None, str, Sequence[str]] = None,
        address: Optional[Tuple[str, int]] = None,
        token: Optional[str] = None,
        restarts: bool = True,
        patience: float = 30.0,
        start_patience: float = 120.0,
        render_mode: Optional[str] = None,
    ) -> None:
        """observation: `image`, `state` or `both`. action: `controls` (steering, throttle, brake) or `indicators` (thirteen, by which the
        game's controller drives). step_seconds: game time of a step. size: width and height of the images.

        Without an address, a game is started at the first reset, with a town (its seed), traffic (a factor on the number of vehicles and
        pedestrians, of which those within traffic_radius metres of the car move, or all if it is None), weather, and, if assisted, with
        its built-in driver in junctions; serve_options are further options of harvester serve, and harvester the command that runs
        it. With an address, a running game is used. restarts: whether it can be restarted, as by serve --lockstep; GTA V cannot. patience:
        seconds of real time to wait for an answer; start_patience: for the start of a game.
        """
        if observation not in _OBSERVATIONS:
            raise ValueError(f"observation is one of {', '.join(_OBSERVATIONS)}, not '{observation}'.")
        if action not in _ACTIONS:
            raise ValueError(f"action is one of {', '.join(_ACTIONS)}, not '{action}'.")
        if not 0 < step_seconds <= 10:
            raise ValueError(f"step_seconds is greater than 0 and at most 10, not {step_seconds}.")
        for name, seconds in (("patience", patience), ("start_patience", start_patience)):
            if not seconds > 0:
                raise ValueError(f"{name} is greater than 0 seconds, not {seconds}.")
        if render_mode not in (None, "rgb_array"):
            raise ValueError(f"render_mode is None or 'rgb_array', not '{render_mode}'.")
        self.render_mode = render_mode
        self.metadata = {**self.metadata, "render_fps": max(1, round(1 / step_seconds))}
        self._has_image = observation != "state"
        self._has_state = observation != "image"
        self._by_controls = action == "controls"
        self._step_seconds = float(step_seconds)
        self._reward = reward
        self._ending = ending
        self._size = (int(size[0]), int(size[1]))
        self._options = _serve_options(
            size, _seed("town", town), traffic, traffic_radius, weather, assisted, serve_options
        )
        self._harvester = harvester
        self._address = address
        self._token = token
        self._restarts = restarts
        self._patience = patience
        self._start_patience = start_patience
        self._server: Optional[GameServer] = None
        self._link: Optional[BridgeLink] = None
        self._rules: Optional[Rules] = None
        self._frame: Header = {}
        self._picture: Optional[Array] = None
        self._is_awaiting = False
        image = Box(0, 255, (size[1], size[0], 3), np.uint8)
        state = Box(STATE_LOW, STATE_HIGH, dtype=np.float32)
        self.observation_space = (
            Dict({"image": image, "state": state}) if observation == "both" else image if self._has_image else state
        )
        self.action_space = (
            Box(np.array([-1, 0, 0], np.float32), np.ones(3, np.float32), dtype=np.float32)
            if self._by_controls
            else Box(_INDICATOR_LOW, _INDICATOR_HIGH, dtype=np.float32)
        )

    def reset(
        self, *, seed: Optional[int] = None, options: Optional[DictOf[str, Any]] = None
    ) -> Tuple[Any, DictOf[str, Any]]:
        """Begins an episode. seed: decides traffic, people, route and start, and the seeds of the following resets without one.
        options: `town` (the seed of another town), `weather`, `timeOfDay` (as 17:30), `position` (x, y, z) with `headingDegrees`.

        A game of which a frame is still awaited, because a step was interrupted, is ended, and another one started.

        Raises BridgeError, and ValueError for a seed that is not from 0 to 2,147,483,647 and for wrong options.
        """
        if seed is not None:
            seed = _seed("seed", seed)
        super().reset(seed=seed)
        episode = int(self.np_random.integers(_MAX_SEED + 1)) if seed is None else seed
        wanted = dict(options or {})
        unknown = set(wanted) - {"town", "weather", "timeOfDay", "position", "headingDegrees"}
        if unknown:
            raise ValueError(f"Unknown options of reset: {', '.join(sorted(unknown))}.")
        if "town" in wanted and not self._restarts:
            raise ValueError("The option town needs a game that can be restarted.")
        if "headingDegrees" in wanted and "position" not in wanted:
            raise ValueError("The option headingDegrees needs the option position.")
        if self._is_awaiting:
            self.close()
        try:
            self._begin(episode, wanted)
        except BaseException:
            self.close()
            raise
        self._rules = Rules(self._ending, self._frame)
        return self._observation(), {"seed": episode, "frame": self._frame}

    def step(self, action: Any) -> StepResult:
        """Drives for a step. info has the `frame` with all that the game tells, the terms of the reward, and the reason of an end.

        Raises BridgeError; the next reset starts or connects again.
        """
        self.send_step(action)
        return self.receive_step()

    def send_step(self, action: Any) -> None:
        """The first half of a step: sends the action, so that several games can work at once. receive_step must follow.

        Raises BridgeError, and RuntimeError if receive_step has not followed the last call.
        """
        link = self._idle()
        values = [float(value) for value in np.asarray(action, np.float64).reshape(-1)]
        if len(values) != self.action_space.shape[0] or not np.all(np.isfinite(values)):
            raise ValueError(f"An action has {self.action_space.shape[0]} finite numbers, not {action!r}.")
        message: Header = (
            {"type": "controls", "steering": values[0], "throttle": values[1], "brake": values[2]}
            if self._by_controls
            else {"type": "indicators", "values": values}
        )
        self._is_awaiting = True
        try:
            link.send(message, {"type": "step", "seconds": self._step_seconds, "image": self._has_image})
        except BridgeError as problem:
            raise self._lost(problem) from None

    def receive_step(self) -> StepResult:
        """The second half of a step: waits for the frame at its end."""
        _, rules = self._ready()
        if not self._is_awaiting:
            raise RuntimeError("No step has been sent; call send_step first.")
        before = self._frame
        try:
            self._take(before["timeSeconds"] + self._step_seconds / 2, self._has_image)
        except BridgeError as problem:
            raise self._lost(problem) from None
        terms = self._reward.terms(before, self._frame)
        terminated, truncated = rules.judge(self._frame)
        info = {"frame": self._frame, "reward": terms, "ending": terminated or truncated}
        return self._observation(), float(sum(terms.values())), terminated is not None, truncated is not None, info

    def render(self) -> Optional[Array]:
        """The image of the current frame, (height, width, 3); None without the render mode `rgb_array`."""
        if self.render_mode is None:
            return None
        link = self._idle()
        if self._picture is None:
            self._is_awaiting = True
            try:
                link.send({"type": "requestFrame"})
                self._picture = self._decoded(link.frame()[1])
                self._is_awaiting = False
            except BridgeError as problem:
                raise self._lost(problem) from None
        return self._picture

    def close(self) -> None:
        """Disconnects, and ends the game if this environment has started it. A reset starts again."""
        self._rules = None
        self._is_awaiting = False
        if self._link is not None:
            self._link.close()
            self._link = None
        if self._server is not None:
            self._server.close()
            self._server = None

    def _ready(self) -> Tuple[BridgeLink, Rules]:
        if self._link is None or self._rules is None:
            raise RuntimeError("The environment has no episode; call reset first.")
        return self._link, self._rules

    def _idle(self) -> BridgeLink:
        link, _ = self._ready()
        if self._is_awaiting:
            raise RuntimeError("The frame of the step before has not been received; call reset.")
        return link

    def _begin(self, episode: int, options: DictOf[str, Any]) -> None:
        link = self._connected()
        self._is_awaiting = True
        after: List[Header] = []
        if "weather" in options or "timeOfDay" in options:
            after.append(
                {"type": "environment", **{name: options[name] for name in ("weather", "timeOfDay") if name in options}}
            )
        if "position" in options:
            position = [float(value) for value in options["position"]]
            after.append(
                {"type": "reset", "position": position, "headingDegrees": float(options.get("headingDegrees", 0))}
            )
        if self._restarts:
            town = {"town": _seed("town", options["town"])} if "town" in options else {}
            link.send({"type": "restart", "seed": episode, **town, "image": self._has_image and not after})
            self._take(None, self._has_image and not after)
        else:
            self._pause(link)
        if after or not self._restarts:
            self._is_awaiting = True
            link.send(*after, {"type": "requestFrame", "image": self._has_image})
            self._take(None, self._has_image)

    def _pause(self, link: BridgeLink) -> None:
        """Pauses a game in real time and skips the frames that it has sent unasked: they have an image, unlike the one asked for here."""
        link.send({"type": "pause", "paused": True}, {"type": "requestFrame", "image": False})
        until = time.monotonic() + self._patience
        while link.frame()[1]:
            if time.monotonic() > until:
                raise GameHungError(f"The game has not been paused for {self._patience:g} s.")

    def _connected(self) -> BridgeLink:
        if self._link is None:
            if self._address is None:
                self._server = GameServer(self._options, self._harvester, self._start_patience)
            host, port = self._address or (self._server.host, self._server.port)  # type: ignore[union-attr]
            self._link = BridgeLink(host, port, self._token, self._patience)
        return self._link

    def _take(self, at_least: Optional[float], has_image: bool) -> None:
        """Takes the next frame. A game in real time may have sent frames from before `at_least` seconds; these are skipped."""
        assert self._link is not None
        until = time.monotonic() + self._patience
        while True:
            frame, png = self._link.frame()
            if at_least is None or frame["timeSeconds"] >= at_least:
                break
            if time.monotonic() > until:
                raise GameHungError(f"The game has sent no frame of the end of the step for {self._patience:g} s.")
        if at_least is not None and (frame.get("drivenMetres") is None) != (self._frame.get("drivenMetres") is None):
            raise GameRefusedError("The game reports the true drive in some frames and not in others.")
        self._frame = frame
        self._picture = self._decoded(png) if has_image else None
        self._is_awaiting = False

    def _decoded(self, png: bytes) -> Array:
        try:
            header = pngs.header(png)
            if header[:2] != self._size:
                raise BridgeError(
                    f"The game sends images of {header.width}x{header.height}; create the environment with this size."
                )
            if header[2:] != _RGB:
                raise BridgeError("The game sends images that are not red, green and blue of 8 bits.")
            picture: Array = pngs.decode(png)
            return picture
        except ValueError as problem:
            raise BridgeError(f"The image of a frame cannot be decoded: {problem}.") from None

    def _observation(self) -> Any:
        if self._has_image and self._has_state:
            return {"image": self._picture, "state": state_of(self._frame)}
        return self._picture if self._has_image else state_of(self._frame)

    def _lost(self, problem: BridgeError) -> BridgeError:
        """The problem, with what a game that was started here said of it."""
        server = self._server
        fault = ""
        if server is not None and isinstance(problem, GameEndedError):
            server.close_gently()
            fault = server.fault()
        self.close()
        return type(problem)(f"{problem} {fault}") if fault else problem


def _seed(name: str, value: Any) -> int:
    """A seed of the game, which has 31 bits."""
    try:
        seed = operator.index(value)
    except TypeError:
        seed = -1
    if not 0 <= seed <= _MAX_SEED:
        raise ValueError(f"{name} is a whole number from 0 to {_MAX_SEED}, not {value!r}.")
    return seed


def _serve_options(
    size: Tuple[int, int],
    town: int,
    traffic: float,
    radius: Optional[float],
    weather: str,
    assisted: bool,
    further: Sequence[str],
) -> List[str]:
    near = [] if radius is None else ["--traffic-radius", f"{radius:g}"]
    options = [
        *near,
        "--size",
        f"{size[0]}x{size[1]}",
        "--seed",
        str(town),
        "--traffic",
        f"{traffic:g}",
        "--weather",
        weather,
    ]
    return [*options, *([] if assisted else ["--unassisted"]), *further]
