"""Reads the scenarios that harvester export --format womd writes, without a library for protobuf."""

from __future__ import annotations

import struct
from pathlib import Path
from typing import Any, Dict, Iterator, List, Tuple, Union

from .errors import ScenarioError

Message = Dict[int, List[Any]]

_VARINT, _FIXED64, _BYTES, _FIXED32 = 0, 1, 2, 5
_MAX_RECORD = 8 << 20


def records(path: Path) -> Iterator[bytes]:
    """The records of a TFRecord file. Their checksums are those that harvester validate checks."""
    with open(path, "rb") as file:
        while head := file.read(12):
            if len(head) < 12:
                raise ScenarioError(f"{path}: a record in it is cut off.")
            (length,) = struct.unpack("<Q", head[:8])
            if length > _MAX_RECORD:
                raise ScenarioError(f"{path}: a record in it has {length} bytes, more than {_MAX_RECORD}, the limit.")
            data = file.read(length + 4)
            if len(data) < length + 4:
                raise ScenarioError(f"{path}: a record in it is cut off.")
            yield data[:length]


def message(data: bytes) -> Message:
    """The fields of a protobuf message by number: whole numbers, bytes of 4 or 8, and bytes of any length."""
    fields: Message = {}
    place = 0
    try:
        while place < len(data):
            key, place = _varint(data, place)
            kind = key & 7
            value: Union[int, bytes]
            if kind == _VARINT:
                value, place = _varint(data, place)
            elif kind in (_FIXED64, _FIXED32):
                length = 8 if kind == _FIXED64 else 4
                value, place = data[place : place + length], place + length
            elif kind == _BYTES:
                length, place = _varint(data, place)
                value, place = data[place : place + length], place + length
            else:
                raise ScenarioError("A message has a field of an unknown kind.")
            if place > len(data):
                raise ScenarioError("A message is cut off.")
            fields.setdefault(key >> 3, []).append(value)
    except IndexError:
        raise ScenarioError("A message is cut off.") from None
    return fields


def number(fields: Message, field: int) -> float:
    """A double or float of a message; 0 if it has none."""
    value = fields.get(field, [b""])[-1]
    return float(struct.unpack("<d" if len(value) == 8 else "<f", value)[0]) if value else 0.0


def whole(fields: Message, field: int) -> int:
    """A whole number of a message, with its sign; 0 if it has none."""
    value = fields.get(field, [0])[-1]
    return int(value) - (1 << 64) if value >= 1 << 63 else int(value)


def numbers(fields: Message, field: int) -> List[float]:
    """All doubles of a field, packed or not."""
    return [value for data in fields.get(field, []) for (value,) in struct.iter_unpack("<d", data)]


def wholes(fields: Message, field: int) -> List[int]:
    """All whole numbers of a field, packed or not."""
    found: List[int] = []
    for value in fields.get(field, []):
        if isinstance(value, int):
            found.append(value)
            continue
        place = 0
        while place < len(value):
            one, place = _varint(value, place)
            found.append(one)
    return found


def text(fields: Message, field: int) -> str:
    """A text of a message; empty if it has none."""
    return str(fields.get(field, [b""])[-1], "utf-8")


def messages(fields: Message, field: int) -> List[Message]:
    """All messages of a field."""
    return [message(data) for data in fields.get(field, [])]


def _varint(data: bytes, place: int) -> Tuple[int, int]:
    value = shift = 0
    while True:
        byte = data[place]
        place += 1
        value |= (byte & 0x7F) << shift
        if byte < 0x80:
            return value & 0xFFFFFFFFFFFFFFFF, place
        shift += 7
        if shift > 63:
            raise ScenarioError("A message has a number that is too long.")
