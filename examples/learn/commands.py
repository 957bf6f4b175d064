"""Runs several commands at a time."""
from __future__ import annotations

import signal
import subprocess
import time
from tempfile import TemporaryFile
from typing import IO, Callable, Dict, List, Mapping, Tuple

POLL_SECONDS = 0.1

STOP_SECONDS = 10
"""Time that a command has to end after it was asked to; then it is killed."""

LIMIT_SECONDS = 3600
"""Time beyond what a command may take on a slow machine, after which it counts as hung."""

STOPPED = 130
"""Exit code of a program that was stopped."""


def run_all(commands: Mapping[str, List[str]], jobs: int, on_end: Callable[[str], None], seconds: float = 0) -> None:
    """Runs several commands at a time, and prints the name of each that has ended. seconds: how long one may take on a slow machine.

    Raises RuntimeError if a command fails or hangs, and KeyboardInterrupt at SIGINT and SIGTERM; those that still run are ended first.
    """
    signal.signal(signal.SIGTERM, signal.default_int_handler)
    waiting = list(commands.items())
    running: Dict[str, Tuple[subprocess.Popen[bytes], IO[str]]] = {}
    begun: Dict[str, float] = {}
    try:
        while waiting or running:
            while waiting and len(running) < max(1, jobs):
                name, command = waiting.pop(0)
                errors = TemporaryFile("w+", encoding="utf-8", errors="replace")
                running[name] = subprocess.Popen(command, stderr=errors), errors
                begun[name] = time.monotonic()
            for name in [name for name, (process, _) in running.items() if process.poll() is not None]:
                _check(name, *running.pop(name))
                on_end(name)
            for name in running:
                if time.monotonic() - begun[name] > seconds + LIMIT_SECONDS:
                    minutes = (seconds + LIMIT_SECONDS) / 60
                    raise RuntimeError(
                        f"{name}: the command has not ended within {minutes:.0f} minutes, and was stopped."
                    )
            time.sleep(POLL_SECONDS)
    finally:
        for process, _ in running.values():
            process.terminate()
        until = time.monotonic() + STOP_SECONDS
        for process, _ in running.values():
            try:
                process.wait(max(0.0, until - time.monotonic()))
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


def _check(name: str, process: subprocess.Popen[bytes], errors: IO[str]) -> None:
    with errors:
        errors.seek(0)
        if process.returncode != 0:
            raise RuntimeError(f"{name}: {errors.read().strip() or f'exit code {process.returncode}'}")
