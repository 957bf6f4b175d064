"""Several environments side by side."""

from __future__ import annotations

from typing import Any, Dict, List, Optional, Sequence, Tuple

from .env import DrivingEnv


class SideBySide:
    """Environments that step at the same time, each with a game in a process of its own.

    The actions go to all games before the first frame is awaited, so n games keep n cores busy. An environment whose episode has ended is
    reset by `reset_ended`.
    """

    def __init__(self, count: int, **options: Any) -> None:
        """count: number of environments. options: those of DrivingEnv."""
        if count < 1:
            raise ValueError(f"At least one environment is needed, not {count}.")
        self.envs = [DrivingEnv(**options) for _ in range(count)]
        self._ended = [True] * count

    def reset(self, seed: Optional[int] = None) -> Tuple[List[Any], List[Dict[str, Any]]]:
        """Resets all; environment i has the seed seed + i."""
        results = [env.reset(seed=None if seed is None else seed + i) for i, env in enumerate(self.envs)]
        self._ended = [False] * len(self.envs)
        return [result[0] for result in results], [result[1] for result in results]

    def reset_ended(self) -> Dict[int, Tuple[Any, Dict[str, Any]]]:
        """Resets the environments whose episodes have ended; observation and info of each by its number."""
        fresh = {i: self.envs[i].reset() for i, ended in enumerate(self._ended) if ended}
        self._ended = [False] * len(self.envs)
        return fresh

    def step(
        self, actions: Sequence[Any]
    ) -> Tuple[List[Any], List[float], List[bool], List[bool], List[Dict[str, Any]]]:
        """Steps all: observations, rewards, terminated, truncated, infos.

        Raises BridgeError or ValueError if one cannot be stepped; then all have to be reset.
        """
        if len(actions) != len(self.envs):
            raise ValueError(f"{len(self.envs)} environments need as many actions, not {len(actions)}.")
        try:
            for env, action in zip(self.envs, actions):
                env.send_step(action)
            results = [env.receive_step() for env in self.envs]
        except BaseException:
            self._ended = [True] * len(self.envs)
            raise
        observations, rewards, terminated, truncated, infos = (list(each) for each in zip(*results))
        self._ended = [before or end or cut for before, end, cut in zip(self._ended, terminated, truncated)]
        return observations, rewards, terminated, truncated, infos

    def close(self) -> None:
        """Closes all."""
        for env in self.envs:
            env.close()
