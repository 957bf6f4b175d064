"""A packed set of sessions (pack.py)."""
from __future__ import annotations

import hashlib
from dataclasses import dataclass, fields
from pathlib import Path
from typing import Optional
from zipfile import BadZipFile

import numpy as np


class PackedError(Exception):
    """A packed set is damaged, or too small."""


@dataclass(frozen=True)
class Packed:
    """The arrays of a set, as pack.py describes them."""

    images: np.ndarray
    values: np.ndarray
    active: np.ndarray
    width: np.ndarray
    frames: np.ndarray
    controls: np.ndarray
    route: np.ndarray
    speed: np.ndarray
    by_controller: np.ndarray

    def __len__(self) -> int:
        return len(self.images)

    def first(self, sessions: Optional[int]) -> Packed:
        """The frames of the first sessions; all if None."""
        return self if sessions is None else self.where(self.frames[:, 0] < sessions)

    def where(self, mask: np.ndarray) -> Packed:
        """The frames of a mask."""
        return Packed(*(getattr(self, field.name)[mask] for field in fields(self)))

    def digest(self) -> str:
        """SHA-256 of the arrays."""
        digest = hashlib.sha256()
        for field in fields(self):
            digest.update(np.ascontiguousarray(getattr(self, field.name)).reshape(-1).view(np.uint8).data)
        return digest.hexdigest()


def load(data: Path, name: str) -> Packed:
    """Loads a packed set. Raises PackedError, and OSError."""
    file = data / "packed" / f"{name}.npz"
    if not file.exists():
        raise FileNotFoundError(f"{file} does not exist; run pack.py {data} {name} first.")
    try:
        with np.load(file) as arrays:
            return Packed(*(arrays[field.name] for field in fields(Packed)))
    except (BadZipFile, EOFError, KeyError, ValueError) as problem:
        raise PackedError(
            f"{file} is damaged, or of another version; delete it, and run pack.py {data} {name}."
        ) from problem
