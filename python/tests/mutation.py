"""Damages JSON, bytes and folders, by a seed."""

from __future__ import annotations

import copy
import os
import random
import socket
from pathlib import Path
from typing import Any, Callable, List, Tuple

_VALUES: Tuple[Any, ...] = (
    None,
    True,
    False,
    0,
    -1,
    1,
    2**31,
    2**63,
    10**30,
    -(10**400),
    0.5,
    1e300,
    -1e-300,
    float("nan"),
    float("inf"),
    "",
    "x",
    "../x.png",
    "\0",
    "a\nb.png",
    "/etc/passwd",
    "/dev/zero",
    "x" * 5000 + ".png",
    "😀\ud800.png",
    [],
    {},
    [[]],
    [None],
    ["x"] * 3,
    [1, 2],
    [1, 2, 3],
    [1, 2, 3, 4],
    [float("nan")] * 4,
    [10**30] * 3,
    {"x": 1},
    "frames",
    "labels.jsonl",
    ".",
    "frames/../labels.jsonl",
)
_TEXTS = (
    "NaN",
    "1e999",
    "-Infinity",
    "9" * 5000,
    "[" * 3000,
    "[" * 930 + "]" * 930,
    "[" * 970 + "]" * 970,
    '{"a":' * 3000,
    '"\\ud800"',
    "\x00",
    "{}",
    "[]",
    "null",
    "1",
    '"x"',
    "",
    "\n",
    "{",
)


def of_json(value: Any, chance: random.Random) -> Any:
    """JSON with one to three places changed: another type, a number out of range, an element left out, repeated or moved."""
    changed = copy.deepcopy(value)
    for _ in range(chance.choice((1, 1, 1, 2, 3))):
        places = _places(changed)
        holder, key = chance.choice(places)
        others = chance.choice(places)
        change = chance.randrange(6)
        if change == 0:
            del holder[key]
        elif change == 1 and isinstance(holder, list):
            holder.extend([holder[key]] * chance.choice((1, 30)))
        elif change == 2:
            holder[key] = copy.deepcopy(others[0][others[1]])
        elif change == 3:
            for _ in range(chance.choice((1, 50, 150))):
                holder[key] = [holder[key]]
        else:
            holder[key] = chance.choice(_VALUES)
        if not changed:
            break
    return changed


def _places(value: Any) -> List[Tuple[Any, Any]]:
    found: List[Tuple[Any, Any]] = []
    rest = [value]
    while rest:
        holder = rest.pop()
        for key in list(holder) if isinstance(holder, dict) else range(len(holder)):
            found.append((holder, key))
            if isinstance(holder[key], (dict, list)):
                rest.append(holder[key])
    return found


def of_bytes(data: bytes, chance: random.Random) -> bytes:
    """Bytes with one to three changes: bits flipped, a part cut out, repeated, or replaced."""
    changed = bytearray(data)
    for _ in range(chance.choice((1, 1, 2, 3))):
        start = chance.randrange(len(changed) + 1)
        end = min(len(changed), start + chance.choice((1, 2, 4, 8, 100, 10_000)))
        part = bytes(changed[start:end])
        changed[start:end] = chance.choice(
            (
                lambda: b"",
                lambda: part * 2,
                lambda: bytes(byte ^ (1 << chance.randrange(8)) for byte in part),
                lambda: b"\xff" * len(part),
                lambda: b"\x00" * len(part),
                lambda: chance.choice(_TEXTS).encode("utf-8", "surrogatepass"),
            )
        )()
    return bytes(changed)


def of_a_file(path: Path, chance: random.Random) -> None:
    """Puts something else in the place of a file: nothing, a pipe, socket, folder, or a link to another file or a device."""
    path.unlink()
    chance.choice(_REPLACEMENTS)(path)


def _socket(path: Path) -> None:
    # The name of a socket is at most 107 bytes long.
    with socket.socket(socket.AF_UNIX) as listener:
        here = os.open(".", os.O_RDONLY)
        try:
            os.chdir(path.parent)
            listener.bind(path.name)
        finally:
            os.fchdir(here)
            os.close(here)


_REPLACEMENTS: Tuple[Callable[[Path], Any], ...] = (
    lambda path: None,
    os.mkfifo,
    Path.mkdir,
    _socket,
    lambda path: path.symlink_to("/dev/zero"),
    lambda path: path.symlink_to(path.name),
    lambda path: path.symlink_to("/etc/hostname"),
    lambda path: path.symlink_to("nowhere"),
    lambda path: path.write_bytes(b""),
    lambda path: path.symlink_to(path.parent.parent.parent / "outside.png"),
    lambda path: path.symlink_to("."),
)
