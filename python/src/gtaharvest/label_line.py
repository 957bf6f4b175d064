"""A label line as parsed JSON."""

from __future__ import annotations

import functools
from typing import Any, Dict, Iterator, Mapping, Optional

from .checks import one_line
from .errors import LabelError
from .json_object import parse_object

_LANES = b',"lanes":{'

# Optional fields that stand before the lanes: where they are missing there, the rest need not be parsed to look for them.
_BEFORE_LANES = frozenset(("moment", "view", "events"))


class LabelLine(Mapping[str, Any]):
    """The fields of a label line. The lanes, which are more than half of its text, are parsed when they are asked for.

    Raises LabelError, which names the source, if the text is not a JSON object; for the lanes and what follows them, only when they are
    asked for.
    """

    def __init__(self, text: bytes, source: str) -> None:
        self._source = source
        at = text.find(_LANES)
        head = self._object(text) if at < 0 else self._head(text[:at] + b"}")
        # If these bytes are not at the top level, the text before them is no object.
        self._rest_text = b"{}" if at < 0 else b"{" + text[at + 1 :]
        if head is None:
            head, self._rest_text = self._object(text), b"{}"
        self._first: Dict[str, Any] = head

    def __getitem__(self, name: str) -> Any:
        return self._first[name] if name in self._first or name in _BEFORE_LANES else self._rest[name]

    def __iter__(self) -> Iterator[str]:
        return iter({**self._first, **self._rest})

    def __len__(self) -> int:
        return len({**self._first, **self._rest})

    def __repr__(self) -> str:
        return f"LabelLine({self._source!r})"

    @functools.cached_property
    def _rest(self) -> Dict[str, Any]:
        return self._object(self._rest_text)

    @staticmethod
    def _head(text: bytes) -> Optional[Dict[str, Any]]:
        try:
            return parse_object(text)
        except ValueError:
            return None

    def _object(self, text: bytes) -> Dict[str, Any]:
        try:
            return parse_object(text)
        except ValueError as problem:
            raise LabelError(
                f"{self._source}: it is not a JSON object ({one_line(problem)}). Run harvester validate, or harvester repair."
            ) from None
