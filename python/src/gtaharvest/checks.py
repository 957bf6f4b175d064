"""Checks untrusted values of labels and frames where they are read."""

from __future__ import annotations

from typing import Any, Callable, Iterable, List, Optional, Sequence, Tuple, Type, TypeVar

from .errors import LabelError

_T = TypeVar("_T")

Vector = Tuple[float, float, float]
Box = Tuple[float, float, float, float]

MAX_NUMBER = 1e12
"""No number of a session is larger."""

MAX_TEXT = 4096
"""No text of a session is longer."""

_MAX_MESSAGE = 200


def one_line(text: object) -> str:
    """Untrusted text for a message: one short line without control characters."""
    line = "".join(letter if letter.isprintable() else " " for letter in str(text)[: _MAX_MESSAGE * 4])
    line = " ".join(line.split())
    return line if len(line) <= _MAX_MESSAGE else line[:_MAX_MESSAGE] + "..."


def shown(value: object) -> str:
    """An untrusted value for a message; for lists and objects, which may be large, only the type."""
    return one_line(repr(value)) if isinstance(value, (str, int, float)) else f"a {type(value).__name__}"


def checked(source: str, read: Callable[[], _T], error: Type[Exception] = LabelError) -> _T:
    """Reads part of a label; what is missing or of another type becomes an error that names the source."""
    try:
        return read()
    except KeyError as missing:
        raise error(f"{source}: the field {missing.args[0]!r} is missing. Run harvester validate.") from None
    except (TypeError, IndexError, ValueError, AttributeError, RecursionError) as problem:
        raise error(f"{source}: a field has the wrong type ({one_line(problem)}). Run harvester validate.") from None


def number(value: Any) -> float:
    """A finite number. Raises TypeError for another type, and ValueError if it is out of range."""
    if not -MAX_NUMBER <= value <= MAX_NUMBER:
        raise ValueError(f"{value!r} is out of range")
    return value  # type: ignore[no-any-return]


def positive(value: Any) -> float:
    """A number greater than 0."""
    if not 0 < value <= MAX_NUMBER:
        raise ValueError(f"{value!r} is not greater than 0")
    return value  # type: ignore[no-any-return]


def integer(value: Any) -> int:
    """A whole number. Raises TypeError for another type, and ValueError if it is out of range."""
    if type(value) is not int:
        raise TypeError(f"{type(value).__name__} instead of a whole number")
    if not -MAX_NUMBER <= value <= MAX_NUMBER:
        raise ValueError(f"{value!r} is out of range")
    return value


def flag(value: Any) -> bool:
    """A boolean. Raises TypeError for another type."""
    if type(value) is not bool:
        raise TypeError(f"{type(value).__name__} instead of a boolean")
    return value


def text(value: Any) -> str:
    """A text. Raises TypeError for another type, and ValueError if it is too long."""
    if type(value) is not str:
        raise TypeError(f"{type(value).__name__} instead of a text")
    if len(value) > MAX_TEXT:
        raise ValueError(f"a text has {len(value)} characters")
    return value


def optional(check: Callable[[Any], _T], value: Any) -> Optional[_T]:
    """A value, or None."""
    return None if value is None else check(value)


def vector(value: Sequence[Any]) -> Vector:
    """Three numbers. Raises TypeError and ValueError."""
    x, y, z = value
    return number(x), number(y), number(z)


def box(value: Sequence[Any]) -> Box:
    """Four numbers. Raises TypeError and ValueError."""
    x_min, y_min, x_max, y_max = value
    return number(x_min), number(y_min), number(x_max), number(y_max)


def numbers(value: Iterable[Any]) -> List[float]:
    """Numbers, as many as there are."""
    return [number(each) for each in _listed(value)]


def each(check: Callable[[Any], _T], value: Iterable[Any]) -> Tuple[_T, ...]:
    """A list, of which each element is checked."""
    return tuple(map(check, _listed(value)))


def _listed(value: Any) -> List[Any]:
    if type(value) is not list:
        raise TypeError(f"{type(value).__name__} instead of a list")
    return value
