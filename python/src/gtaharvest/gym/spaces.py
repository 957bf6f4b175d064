"""The spaces of Gymnasium that the environment needs: those of the package if it is installed, otherwise small ones of the same form."""

from __future__ import annotations

import importlib
from typing import Any, Dict as DictOf, Iterator, Mapping, Optional, Sequence, Tuple

import numpy as np
import numpy.typing as npt

Array = npt.NDArray[Any]


def _import_gymnasium() -> Any:
    try:
        return importlib.import_module("gymnasium")
    except ImportError:
        return None


gymnasium_module: Any = _import_gymnasium()
"""The package gymnasium, or None."""


class PlainSpace:
    """What all spaces have: shape, dtype, and a random generator of their own for samples."""

    def __init__(
        self, shape: Optional[Tuple[int, ...]], dtype: Optional[npt.DTypeLike], seed: Optional[int] = None
    ) -> None:
        self.shape = shape
        self.dtype = None if dtype is None else np.dtype(dtype)
        self._np_random = np.random.default_rng(seed)

    @property
    def np_random(self) -> np.random.Generator:
        return self._np_random

    def seed(self, seed: Optional[int] = None) -> Any:
        """Restarts the sequence of samples."""
        self._np_random = np.random.default_rng(seed)
        return seed

    def sample(self) -> Any:
        raise NotImplementedError

    def contains(self, x: Any) -> bool:
        raise NotImplementedError

    def __contains__(self, x: Any) -> bool:
        return self.contains(x)


class PlainBox(PlainSpace):
    """Arrays of a shape, each element within its bounds."""

    def __init__(
        self,
        low: Any,
        high: Any,
        shape: Optional[Sequence[int]] = None,
        dtype: npt.DTypeLike = np.float32,
        seed: Optional[int] = None,
    ) -> None:
        size = tuple(shape) if shape is not None else np.shape(low)
        super().__init__(size, dtype, seed)
        self.low: Array = np.broadcast_to(np.asarray(low, dtype), size).copy()
        self.high: Array = np.broadcast_to(np.asarray(high, dtype), size).copy()

    def sample(self) -> Array:
        if np.issubdtype(self.low.dtype, np.integer):
            return self._np_random.integers(self.low, self.high, endpoint=True, dtype=self.low.dtype)
        return self._np_random.uniform(self.low, self.high).astype(self.low.dtype)

    def contains(self, x: Any) -> bool:
        return bool(
            isinstance(x, np.ndarray)
            and np.can_cast(x.dtype, self.low.dtype)
            and x.shape == self.shape
            and np.all(x >= self.low)
            and np.all(x <= self.high)
        )

    def __eq__(self, other: object) -> bool:
        return (
            isinstance(other, PlainBox)
            and self.low.dtype == other.low.dtype
            and np.array_equal(self.low, other.low)
            and np.array_equal(self.high, other.high)
        )

    def __repr__(self) -> str:
        return f"Box({self.low.min()}, {self.high.max()}, {self.shape}, {self.low.dtype})"


class PlainDict(PlainSpace):
    """Dictionaries with a space for each key."""

    def __init__(self, spaces: Mapping[str, Any], seed: Optional[int] = None) -> None:
        super().__init__(None, None, seed)
        self.spaces: DictOf[str, Any] = dict(sorted(spaces.items()))

    def seed(self, seed: Optional[int] = None) -> Any:
        super().seed(seed)
        return {
            name: space.seed(None if seed is None else seed + i) for i, (name, space) in enumerate(self.spaces.items())
        }

    def sample(self) -> DictOf[str, Any]:
        return {name: space.sample() for name, space in self.spaces.items()}

    def contains(self, x: Any) -> bool:
        return (
            isinstance(x, dict)
            and x.keys() == self.spaces.keys()
            and all(x[name] in space for name, space in self.spaces.items())
        )

    def __getitem__(self, name: str) -> Any:
        return self.spaces[name]

    def __iter__(self) -> Iterator[str]:
        return iter(self.spaces)

    def __len__(self) -> int:
        return len(self.spaces)

    def keys(self) -> Any:
        return self.spaces.keys()

    def values(self) -> Any:
        return self.spaces.values()

    def items(self) -> Any:
        return self.spaces.items()

    def __eq__(self, other: object) -> bool:
        return isinstance(other, PlainDict) and self.spaces == other.spaces

    def __repr__(self) -> str:
        return f"Dict({', '.join(f'{name!r}: {space!r}' for name, space in self.spaces.items())})"


class PlainEnv:
    """The part of gymnasium.Env that does not depend on the environment."""

    metadata: DictOf[str, Any] = {"render_modes": []}
    render_mode: Optional[str] = None
    spec: Any = None
    _np_random: Optional[np.random.Generator] = None
    _np_random_seed = -1

    @property
    def unwrapped(self) -> PlainEnv:
        return self

    @property
    def np_random(self) -> np.random.Generator:
        if self._np_random is None:
            self._np_random = np.random.default_rng()
        return self._np_random

    @property
    def np_random_seed(self) -> int:
        """The seed of the last reset that had one; -1 before."""
        return self._np_random_seed

    def reset(self, *, seed: Optional[int] = None, options: Optional[DictOf[str, Any]] = None) -> Any:
        if seed is not None:
            self._np_random = np.random.default_rng(seed)
            self._np_random_seed = int(seed)

    def close(self) -> None:
        pass

    def __enter__(self) -> Any:
        return self

    def __exit__(self, *_: Any) -> None:
        self.close()


Env: Any = PlainEnv if gymnasium_module is None else gymnasium_module.Env
Box: Any = PlainBox if gymnasium_module is None else gymnasium_module.spaces.Box
Dict: Any = PlainDict if gymnasium_module is None else gymnasium_module.spaces.Dict
