"""The client's side of the socket bridge; docs/bridge.md has the protocol."""

from __future__ import annotations

import json
import socket
import struct
import time
from typing import Optional, Tuple

from ..checks import one_line, shown
from ..json_object import parse_object
from ..picture_header import MAX_BYTES
from .errors import BridgeError, GameEndedError, GameHungError, GameRefusedError, GameStartError, VersionError
from .frame_header import Header, check_frame

PROTOCOL_VERSION = 1
"""The version of the bridge that this package speaks."""

_LENGTHS = struct.Struct(">II")
_MAX_HEADER_BYTES = 1024 * 1024


class BridgeLink:
    """A connection to a game. Nothing waits longer than the patience, in seconds of real time, for each message."""

    def __init__(self, host: str, port: int, token: Optional[str] = None, patience: float = 30) -> None:
        """Connects and exchanges hellos.

        Raises GameStartError if nobody listens there, VersionError, GameRefusedError, GameEndedError and GameHungError.
        """
        if not patience > 0:
            raise ValueError(f"patience must be greater than 0 seconds, not {patience}.")
        self._place = f"{host}:{port}"
        self._patience = patience
        self._unread = bytearray()
        try:
            self._socket = socket.create_connection((host, port), timeout=patience)
        except OSError as problem:
            raise GameStartError(
                f"Cannot connect to a game at {self._place}: {problem}. Start harvester serve first."
            ) from None
        try:
            self._socket.setsockopt(socket.IPPROTO_TCP, socket.TCP_NODELAY, 1)
            self.send({"type": "hello", "version": PROTOCOL_VERSION, **({} if token is None else {"token": token})})
            hello, _ = self.receive()
            if hello.get("type") != "hello":
                raise GameRefusedError(f"{self._place} does not answer with a hello; is it the bridge of a game?")
            if hello.get("version") != PROTOCOL_VERSION:
                raise VersionError(
                    f"The game at {self._place} speaks version {shown(hello.get('version'))} of the bridge, this package version "
                    f"{PROTOCOL_VERSION}; install matching versions."
                )
        except BaseException:
            self.close()
            raise

    def send(self, *messages: Header) -> None:
        """Sends messages in one piece."""
        data = bytearray()
        for message in messages:
            header = json.dumps(message, separators=(",", ":")).encode()
            data += _LENGTHS.pack(len(header), 0)
            data += header
        try:
            self._socket.sendall(data)
        except socket.timeout:
            raise GameHungError(f"The game at {self._place} has not read for {self._patience:g} s.") from None
        except OSError as problem:
            raise self._ended(problem) from None

    def receive(self) -> Tuple[Header, bytes]:
        """The next message: header and payload.

        Raises GameRefusedError if it is an error, GameEndedError if the connection ends, and GameHungError.
        """
        until = time.monotonic() + self._patience
        header_length, payload_length = _LENGTHS.unpack(self._read(_LENGTHS.size, until))
        if header_length > _MAX_HEADER_BYTES or payload_length > MAX_BYTES:
            raise GameRefusedError(
                f"{self._place} announces a message of {header_length + payload_length} bytes; is it the bridge of a game?"
            )
        text = self._read(header_length, until)
        payload = self._read(payload_length, until)
        try:
            header = parse_object(text)
        except ValueError as problem:
            raise GameRefusedError(
                f"{self._place} sends a header that is not a JSON object ({one_line(problem)}); is it the bridge of a game?"
            ) from None
        if header.get("type") == "error":
            reason = header.get("reason")
            words = one_line(reason) if isinstance(reason, str) else "it gives no reason"
            kind = VersionError if "speaks version" in words else GameRefusedError
            raise kind(f"The game at {self._place} refuses: {words}")
        return header, payload

    def frame(self) -> Tuple[Header, bytes]:
        """The next frame: its state and its image as PNG, empty if none was asked for. What is measured is a float, also if it is whole.

        Raises VersionError if the frame lacks a field, and GameRefusedError if one is malformed.
        """
        header, payload = self.receive()
        kind = header.get("type")
        if kind != "frame":
            raise GameRefusedError(f"{self._place} sends {shown(kind)} instead of a frame.")
        check_frame(header, self._place)
        return header, payload

    def close(self) -> None:
        """Ends the connection. Further calls do nothing."""
        self._socket.close()

    def _read(self, count: int, until: float) -> bytes:
        while len(self._unread) < count:
            left = until - time.monotonic()
            try:
                if left <= 0:
                    raise socket.timeout
                self._socket.settimeout(left)
                # Lengths and header of a frame without an image arrive together.
                data = self._socket.recv(max(count - len(self._unread), 65_536))
            except socket.timeout:
                raise GameHungError(
                    f"The game at {self._place} has not answered for {self._patience:g} s; it hangs, or is slower than the patience."
                ) from None
            except OSError as problem:
                raise self._ended(problem) from None
            if not data:
                raise self._ended(None)
            self._unread += data
        taken = bytes(memoryview(self._unread)[:count])
        del self._unread[:count]
        return taken

    def _ended(self, problem: Optional[OSError]) -> BridgeError:
        why = "" if problem is None else f" ({problem})"
        return GameEndedError(f"The game at {self._place} has ended, or another client has replaced this one{why}.")
