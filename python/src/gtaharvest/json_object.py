"""JSON objects from untrusted files and peers."""

from __future__ import annotations

import json
from typing import Any, Dict


def parse_object(text: bytes) -> Dict[str, Any]:
    """A JSON object. Raises ValueError if the text is something else, nested too deeply, or has NaN or Infinity, which JSON does not."""
    try:
        value = json.loads(text, parse_constant=_refuse)
    except RecursionError:
        raise ValueError("it is nested too deeply") from None
    if not isinstance(value, dict):
        raise ValueError(f"it is a {type(value).__name__}")
    return value


def _refuse(name: str) -> Any:
    raise ValueError(f"{name} is not a number of JSON")
