"""Checks the header of a frame; docs/bridge.md has its fields."""

from __future__ import annotations

from typing import Any, Callable, Dict, List

from ..checks import each, flag, integer, number, shown, text
from .errors import GameRefusedError, VersionError

Header = Dict[str, Any]


def _measured(value: Any) -> float:
    return float(number(value))


def _listed(count: int, check: Callable[[Any], Any]) -> Callable[[Any], List[Any]]:
    def listed(value: Any) -> List[Any]:
        checked = each(check, value)
        if len(checked) != count:
            raise ValueError(f"{len(checked)} instead of {count}")
        return list(checked)

    return listed


_CHECKS: Dict[str, Callable[[Any], Any]] = {
    **dict.fromkeys(
        (
            "timeSeconds",
            "speedMetresPerSecond",
            "headingDegrees",
            "drivenMetres",
            "laneOffsetMetres",
            "laneAngleRadians",
            "routeMetres",
        ),
        _measured,
    ),
    "position": _listed(3, _measured),
    "appliedControls": _listed(3, _measured),
    "indicators": _listed(13, _measured),
    "torcsEquivalent": _listed(13, _measured),
    **dict.fromkeys(("lanesKnown", "fast", "outsideLanes", "acrossMarking", "stopSign", "builtInDriver"), flag),
    **dict.fromkeys(("road", "lane", "redLightsRun", "stopSignsRun", "repositioned"), integer),
    "collisions": _listed(3, integer),
    **dict.fromkeys(("collision", "route", "light"), text),
}
_REQUIRED = ("timeSeconds", "speedMetresPerSecond", "position", "lanesKnown", "fast", "indicators", "torcsEquivalent")
_KNOWN_IN_A_TRUE_DRIVE = (
    "collisions",
    "outsideLanes",
    "acrossMarking",
    "redLightsRun",
    "stopSignsRun",
    "repositioned",
    "builtInDriver",
)
_PRESENT_IN_A_TRUE_DRIVE = ("road", "lane", "laneOffsetMetres")


def check_frame(header: Header, place: str) -> None:
    """Checks the header of a frame of the game at a place. What is measured becomes a float, also if it is whole.

    Raises VersionError if it lacks a field, and GameRefusedError if one is malformed, such as a number that is not finite.
    """
    missing = [name for name in _REQUIRED if header.get(name) is None]
    if header.get("drivenMetres") is not None:
        missing += [name for name in _KNOWN_IN_A_TRUE_DRIVE if header.get(name) is None]
        missing += [name for name in _PRESENT_IN_A_TRUE_DRIVE if name not in header]
    if missing:
        raise VersionError(
            f"The game at {place} sends frames without '{missing[0]}', as another version does; install matching versions."
        )
    for name, check in _CHECKS.items():
        if header.get(name) is None:
            continue
        try:
            header[name] = check(header[name])
        except (TypeError, ValueError):
            raise GameRefusedError(
                f"{place} sends a frame with a malformed '{name}': {shown(header[name])}; is it the bridge of a game?"
            ) from None
