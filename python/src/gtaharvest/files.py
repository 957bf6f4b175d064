"""Opens files of untrusted sessions: only regular files, because a pipe or a device can block or never end."""

from __future__ import annotations

import errno
import os
import stat
from pathlib import Path
from typing import BinaryIO

_FLAGS = os.O_RDONLY | getattr(os, "O_NONBLOCK", 0) | getattr(os, "O_BINARY", 0)


def open_regular(path: Path) -> BinaryIO:
    """Opens a file for reading, unbuffered.

    Raises OSError, also if the path leads to a folder, pipe, socket or device. Its type is known before it is opened, and again after.
    """
    _check(os.stat(path), path)
    stream = os.fdopen(os.open(path, _FLAGS), "rb", buffering=0)
    try:
        _check(os.fstat(stream.fileno()), path)
    except BaseException:
        stream.close()
        raise
    return stream


def read_regular(path: Path, max_bytes: int) -> bytes:
    """The content of a file. Raises OSError as open_regular does, and if the file has more than max_bytes."""
    with open_regular(path) as stream:
        size = os.fstat(stream.fileno()).st_size
        if size > max_bytes:
            raise OSError(errno.EFBIG, f"it has {size} bytes, more than {max_bytes}", str(path))
        return stream.read(size)


def _check(status: os.stat_result, path: Path) -> None:
    if not stat.S_ISREG(status.st_mode):
        raise OSError(errno.EINVAL, "it is not a regular file", str(path))
