"""Untrusted sessions: whatever is in them, reading ends in a result or a SessionError, which is one line."""

from __future__ import annotations

import json
import os
import random
import shutil
import warnings
from pathlib import Path
from typing import Any, Callable

import mutation
import pytest
import rich

import gtaharvest

CASES = int(os.environ.get("GTAHARVEST_FUZZ_CASES", "300"))
"""Cases of each kind."""

SEED = int(os.environ.get("GTAHARVEST_FUZZ_SEED", "20260101"))


def outcome(read: Callable[[], Any]) -> bool:
    """Whether something was read; False if it was refused by a SessionError of one line."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        try:
            read()
            return True
        except gtaharvest.SessionError as refused:
            message = str(refused)
            assert message.isprintable() and len(message) < 1000, message
            return False


def refusals(folder: Path) -> int:
    """Reads all of a session; how much of it was refused."""
    refused = 0
    try:
        for _, read in rich.reads(folder):
            refused += not outcome(read)
    except gtaharvest.SessionError as whole:
        assert str(whole).isprintable()
        refused += 1
    return refused


def test_undamaged_session_is_read_whole(tmp_path: Path) -> None:
    assert refusals(rich.write(tmp_path / "rich")) == 0


@pytest.mark.parametrize(
    "kind", ["label", "session.json", "text of the label", "text of session.json", "files", "pictures", "manifest"]
)
def test_mutated_sessions_never_escape(tmp_path: Path, kind: str) -> None:
    sound = rich.write(tmp_path / "sound")
    (tmp_path / "outside.png").write_bytes((sound / "frames/00000001.png").read_bytes())
    label, info = (json.loads((sound / name).read_bytes()) for name in ("labels.jsonl", "session.json"))
    files = sorted(path.relative_to(sound) for path in sound.rglob("*") if path.is_file())
    refused = 0
    for case in range(CASES):
        chance = random.Random(f"{SEED} {kind} {case}")
        folder = tmp_path / "damaged"
        shutil.copytree(sound, folder)
        if kind == "label":
            # json writes NaN and lone surrogates, as an attacker might.
            (folder / "labels.jsonl").write_text(json.dumps(mutation.of_json(label, chance)) + "\n")
        elif kind == "session.json":
            (folder / kind).write_text(json.dumps(mutation.of_json(info, chance)))
        elif kind == "files":
            mutation.of_a_file(folder / chance.choice(files), chance)
        elif kind == "manifest":
            size = (folder / "labels.jsonl").stat().st_size - 1
            text = b'{"frame":0,"label":{"bytes":%d,"sha256":"0"},"files":[],"check":"0"}\n' % size
            (folder / "manifest.jsonl").write_bytes(mutation.of_bytes(text * chance.choice((1, 2)), chance))
        else:
            name = {"text of the label": "labels.jsonl", "text of session.json": "session.json"}.get(kind)
            path = folder / (name or chance.choice([file for file in files if file.suffix in (".png", ".bin")]))
            path.write_bytes(mutation.of_bytes(path.read_bytes(), chance))
        try:
            refused += refusals(folder) > 0
        except BaseException as escaped:
            raise AssertionError(f"{kind}, seed {SEED}, case {case}: {escaped!r}") from escaped
        shutil.rmtree(folder)
    # Not every damage is noticed: another number may be as good, and a manifest that does not fit is not needed.
    print(f"{kind}: {refused} of {CASES} cases were refused in part or whole")
    assert kind == "manifest" or refused > CASES / 4
