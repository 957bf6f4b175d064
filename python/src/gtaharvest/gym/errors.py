"""What can go wrong between an environment and its game. Every message is one line that says what to do."""

from __future__ import annotations


class BridgeError(Exception):
    """The environment cannot go on. Base of all exceptions here; a reset starts or connects a game again."""


class GameStartError(BridgeError):
    """The game could not be started, or nobody listens at the address."""


class GameEndedError(BridgeError):
    """The game has ended or closed the bridge, or another client has replaced this one."""


class GameHungError(BridgeError):
    """The game has not answered for the patience of the environment."""


class GameRefusedError(BridgeError):
    """The game has refused a message. The message has its reason."""


class VersionError(BridgeError):
    """The game speaks another version of the bridge."""
