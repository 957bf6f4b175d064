"""Starts the simulated game in a process of its own."""

from __future__ import annotations

import os
import queue
import shlex
import shutil
import subprocess
import tempfile
import threading
import time
from typing import List, Optional, Sequence, Union

from ..checks import one_line
from .errors import GameStartError

HARVESTER_VARIABLE = "GTAHARVEST_HARVESTER"
"""Environment variable with the command that runs harvester, if it is not on the PATH."""

_SERVING = "Serving at "

_ENDING_SECONDS = 5
"""Time that a game has to end by itself; a fifth of a second is enough on an idle machine."""


class GameServer:
    """`harvester serve --lockstep` at a free port of the loopback interface. It ends with its client, so also when this process dies."""

    def __init__(
        self, options: Sequence[str] = (), harvester: Union[None, str, Sequence[str]] = None, patience: float = 60
    ) -> None:
        """options: further options of harvester serve. harvester: the command that runs it; by default that of the environment
        variable GTAHARVEST_HARVESTER, or `harvester` on the PATH. patience: for its start, in seconds.

        Raises GameStartError.
        """
        command = [*_command(harvester), "serve", "--lockstep", "--once", "--port", "0", *options]
        self._faults = tempfile.TemporaryFile()
        try:
            self._process = subprocess.Popen(
                command,
                stdin=subprocess.DEVNULL,
                stdout=subprocess.PIPE,
                stderr=self._faults,
                text=True,
                encoding="utf-8",
                errors="replace",
            )
        except OSError as problem:
            self._faults.close()
            raise GameStartError(
                f"Cannot start '{command[0]}': {problem}. Set {HARVESTER_VARIABLE} to the command that runs harvester."
            ) from None
        lines: queue.Queue[Optional[str]] = queue.Queue()
        threading.Thread(target=self._read, args=(lines,), daemon=True, name="harvester serve").start()
        try:
            self.host, self.port = self._address(lines, patience)
        except BaseException:
            self.close()
            raise

    def close_gently(self) -> None:
        """Waits a while for a game that ends by itself, as when its client has disconnected."""
        try:
            self._process.wait(_ENDING_SECONDS)
        except subprocess.TimeoutExpired:
            pass

    def close(self) -> None:
        """Ends the game. Further calls do nothing."""
        if self._process.poll() is None:
            self.close_gently()
            if self._process.poll() is None:
                self._process.terminate()
                try:
                    self._process.wait(5)
                except subprocess.TimeoutExpired:
                    self._process.kill()
                    self._process.wait()
        self._faults.close()

    def fault(self) -> str:
        """What the game printed as its error, as one line; empty if nothing."""
        if self._faults.closed:
            return ""
        self._faults.seek(0)
        return " ".join(self._faults.read().decode("utf-8", "replace").split())

    def _read(self, lines: queue.Queue[Optional[str]]) -> None:
        assert self._process.stdout is not None
        with self._process.stdout as stream:
            for line in stream:
                lines.put(line)
        lines.put(None)

    def _address(self, lines: queue.Queue[Optional[str]], patience: float) -> tuple[str, int]:
        until = time.monotonic() + patience
        while True:
            try:
                line = lines.get(timeout=max(0.0, until - time.monotonic()))
                if line is None:
                    # A wrapper may close its output and live on.
                    self._process.wait(max(0.0, until - time.monotonic()))
            except (queue.Empty, subprocess.TimeoutExpired):
                raise GameStartError(
                    f"harvester serve did not start within {patience:g} s. Give it more patience."
                ) from None
            if line is None:
                raise GameStartError(
                    f"harvester serve ended at its start with code {self._process.returncode}: {self.fault()}"
                )
            if line.startswith(_SERVING):
                host, _, port = line[len(_SERVING) :].strip().rpartition(":")
                if not host or not port.isdecimal() or len(port) > 5 or int(port) > 65_535:
                    raise GameStartError(f"harvester serve gives no address: '{one_line(line)}'.")
                return host, int(port)


def _command(harvester: Union[None, str, Sequence[str]]) -> List[str]:
    if harvester is None:
        harvester = os.environ.get(HARVESTER_VARIABLE) or shutil.which("harvester")
    if not harvester:
        raise GameStartError(
            f"harvester is not on the PATH. Set {HARVESTER_VARIABLE} to the command that runs it, or name an address to connect to."
        )
    return shlex.split(harvester, posix=os.name != "nt") if isinstance(harvester, str) else list(harvester)
