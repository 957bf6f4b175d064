"""What can be wrong with a session. Every message is one line that names the file and says what to do."""

from __future__ import annotations


class SessionError(Exception):
    """A session cannot be read as asked. Base of all exceptions of this package."""


class NotASessionError(SessionError):
    """The folder does not exist, or it has no session.json that can be read."""


class NewerFormatError(SessionError):
    """The session was written in a newer version of the format than this package reads."""


class PartialSessionError(SessionError):
    """The recording of the session was cut off or is still running."""


class LabelError(SessionError):
    """A line of labels.jsonl is damaged. The message names the line and the field."""


class MissingPictureError(SessionError):
    """An image or a mask that a label names does not exist, or the frame has none."""


class PictureError(SessionError):
    """An image or a mask cannot be decoded, or does not have the size that its label says."""


class NotInSessionError(SessionError, KeyError):
    """The session has no frame, object or sensor of that number or name."""

    # That of KeyError puts quotation marks around the message.
    __str__ = Exception.__str__


class ScenarioError(Exception):
    """A scenario cannot be read. The message says what is wrong."""
