"""A label line as parsed JSON."""

from __future__ import annotations

import functools
import json
from typing import Any, Dict, Iterator, Mapping

_LANES = b',"lanes":{'

# Optional fields that stand before the lanes: where they are missing there, the rest need not be parsed to look for them.
_BEFORE_LANES = frozenset(("moment", "view"))


class LabelLine(Mapping[str, Any]):
    """The fields of a label line. The lanes, which are more than half of its text, are parsed when they are asked for.

    Raises ValueError if the text is not a JSON object; for the lanes and what follows them, only when they are asked for.
    """

    def __init__(self, text: bytes) -> None:
        at = text.find(_LANES)
        head = self._object(text) if at < 0 else self._head(text[:at] + b"}")
        # If these bytes are not at the top level, the text before them is no object.
        self._rest_text = b"{}" if at < 0 else b"{" + text[at + 1:]
        if head is None:
            head, self._rest_text = self._object(text), b"{}"
        self._first: Dict[str, Any] = head

    def __getitem__(self, name: str) -> Any:
        return self._first[name] if name in self._first or name in _BEFORE_LANES else self._rest[name]

    def __iter__(self) -> Iterator[str]:
        return iter({**self._first, **self._rest})

    def __len__(self) -> int:
        return len({**self._first, **self._rest})

    @functools.cached_property
    def _rest(self) -> Dict[str, Any]:
        return self._object(self._rest_text)

    @classmethod
    def _head(cls, text: bytes) -> Any:
        try:
            return cls._object(text)
        except ValueError:
            return None

    @staticmethod
    def _object(text: bytes) -> Dict[str, Any]:
        value = json.loads(text)
        if not isinstance(value, dict):
            raise ValueError("it is not an object")
        return value
