"""A game of which the tests decide what it answers, written from docs/bridge.md alone."""

from __future__ import annotations

import json
import socket
import struct
import threading
from typing import Any, Callable, Dict, List, Optional, Tuple, Union

Message = Dict[str, Any]
Answer = Union[Message, Tuple[Message, bytes], bytes, None]

HELLO: Message = {"type": "hello", "version": 1}


def frame(number: int, **fields: Any) -> Message:
    """A frame 0.1 s after the one before, of a car at 10 m/s in the middle of its lane."""
    return {
        "type": "frame",
        "frame": number,
        "timeSeconds": 0.1 * number,
        "speedMetresPerSecond": 10,
        "position": [0, number, 0],
        "headingDegrees": 0,
        "fast": True,
        "lanesKnown": True,
        "indicators": [0] * 13,
        "torcsEquivalent": [0] * 13,
        "drivenMetres": 1.0 * number,
        "collision": None,
        "collisions": [0, 0, 0],
        "outsideLanes": False,
        "road": 4,
        "lane": 0,
        "acrossMarking": False,
        "laneOffsetMetres": 0.0,
        "laneAngleRadians": 0.0,
        "redLightsRun": 0,
        "stopSignsRun": 0,
        "repositioned": 0,
        "route": None,
        "routeMetres": None,
        "light": None,
        "stopSign": False,
        "appliedControls": [0, 0, 0],
        "builtInDriver": False,
        **fields,
    }


class FakeGame:
    """Listens at a free port. `answer` gets each message and gives what is sent back: a message, one with a payload, raw bytes, which end
    the connection, or None for nothing."""

    def __init__(self, answer: Callable[[Message], Answer], hello: Answer = HELLO) -> None:
        self._answer = answer
        self._hello = hello
        self.heard: List[Message] = []
        self._listener = socket.create_server(("127.0.0.1", 0))
        self.address: Tuple[str, int] = self._listener.getsockname()
        threading.Thread(target=self._serve, daemon=True).start()

    def close(self) -> None:
        self._listener.close()

    def _serve(self) -> None:
        while True:
            try:
                connection, _ = self._listener.accept()
            except OSError:
                return
            with connection, connection.makefile("rwb") as stream:
                try:
                    self._talk(stream)
                except (OSError, struct.error):
                    pass

    def _talk(self, stream: Any) -> None:
        while True:
            sizes = stream.read(8)
            if len(sizes) < 8:
                return
            message = json.loads(stream.read(struct.unpack(">II", sizes)[0]))
            self.heard.append(message)
            answer = self._hello if message["type"] == "hello" else self._answer(message)
            if isinstance(answer, bytes):
                stream.write(answer)
                stream.flush()
                return
            if answer is not None:
                header, payload = answer if isinstance(answer, tuple) else (answer, b"")
                text = json.dumps(header).encode()
                stream.write(struct.pack(">II", len(text), len(payload)) + text + payload)
                stream.flush()


def frames(changes: Optional[Dict[int, Dict[str, Any]]] = None) -> Callable[[Message], Answer]:
    """Answers of a game that counts its frames from each restart; changes has fields of some."""
    number = -1

    def answer(message: Message) -> Answer:
        nonlocal number
        if message["type"] not in ("restart", "step", "requestFrame"):
            return None
        number = 0 if message["type"] == "restart" else number + 1
        return frame(number, **(changes or {}).get(number, {}))

    return answer
