"""Files that are made to take memory and time: each is read by a process of its own, of which the largest memory is taken."""

from __future__ import annotations

import json
import os
import struct
import subprocess
import sys
import zlib
from pathlib import Path
from typing import Callable, Dict

import pytest
import rich
from conftest import camera

from gtaharvest import png

MAX_MB = 1000
"""No input takes more memory; docs/untrusted-input.md promises it."""

TIMEOUT_SECONDS = 300
"""For what does not end: far above what each takes on a busy machine."""

READ_ALL = r"""
import re, sys
sys.path[:0] = sys.argv[2:]
import gtaharvest, rich
try:
    for name, read in rich.reads(sys.argv[1]):
        try:
            read()
        except gtaharvest.SessionError as refused:
            print(name, refused)
except gtaharvest.SessionError as refused:
    print("session", refused)
print(int(re.search(r"VmHWM:\s*(\d+)", open("/proc/self/status").read())[1]) // 1024)
"""


def chunk(kind: bytes, body: bytes) -> bytes:
    return struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))


def picture(width: int, height: int, packed: bytes, before: bytes = b"") -> bytes:
    """A PNG of red, green and blue."""
    header = chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0))
    return png.SIGNATURE + header + before + chunk(b"IDAT", packed) + chunk(b"IEND", b"")


def zeros(count: int) -> bytes:
    """A number of zeros, packed."""
    packer = zlib.compressobj(9)
    block = bytes(1 << 20)
    parts = [packer.compress(block[: min(len(block), count - at)]) for at in range(0, count, len(block))]
    return b"".join(parts) + packer.flush()


def filtered(side: int) -> bytes:
    """Rows of the largest picture, all filtered with Paeth, packed."""
    packer = zlib.compressobj(1)
    row = b"\4" + bytes(side * 3)
    return b"".join(packer.compress(row) for _ in range(side)) + packer.flush()


def false_length(folder: Path) -> None:
    sound = picture(80, 60, zeros(60 * 241))
    (folder / "frames/00000001.png").write_bytes(
        sound[:33] + struct.pack(">I", 0x7FFFFFFF) + sound[37:] + bytes(19_000)
    )


def more_pixels_than_the_label(folder: Path) -> None:
    (folder / "frames/00000001.png").write_bytes(picture(65_000, 65_000, zeros(500_000_000)))


def more_data_than_the_header(folder: Path) -> None:
    (folder / "frames/00000001.png").write_bytes(picture(80, 60, zeros(2_000_000_000)))


def a_long_text(folder: Path) -> None:
    text = chunk(b"zTXt", b"comment\0\0" + zeros(2_000_000_000))
    (folder / "frames/00000001.png").write_bytes(picture(80, 60, zeros(60 * 241), text))


def largest_picture(folder: Path) -> None:
    label = json.loads((folder / "labels.jsonl").read_bytes())
    label["camera"] = {**camera(), "width": 8192, "height": 8192}
    (folder / "labels.jsonl").write_text(json.dumps(label) + "\n")
    (folder / "frames/00000001.png").write_bytes(picture(8192, 8192, filtered(8192)))


def sparse(name: str, size: int) -> Callable[[Path], None]:
    def write(folder: Path) -> None:
        os.truncate(folder / name, size)

    return write


def a_line_without_end(folder: Path) -> None:
    with open(folder / "labels.jsonl", "ab") as labels:
        labels.truncate(3_000_000_000)
        labels.seek(0, 2)
        labels.write(b"\n")


def a_label_of_many_values(folder: Path) -> None:
    line = b'{"frame":1,"objects":[' + b"[]," * 2_700_000 + b"[]]}\n"
    (folder / "labels.jsonl").write_bytes(line)


def lines_without_labels(folder: Path) -> None:
    with open(folder / "labels.jsonl", "wb") as labels:
        for _ in range(500):
            labels.write(b"\n" * 1_000_000)


def a_manifest_of_no_lines(folder: Path) -> None:
    (folder / "manifest.jsonl").write_bytes(b'{"frame":0,"label":{"bytes":0,"sha256":"0"}}\n' * 5_000_000)


def a_long_header(folder: Path) -> None:
    with open(folder / "session.json", "r+b") as info:
        info.seek(-1, 2)
        info.write(b',"more":[')
        for _ in range(300):
            info.write(b"[]," * 1_000_000)
        info.write(b"[]]}")


INPUTS: Dict[str, Callable[[Path], None]] = {
    "a false length of a chunk": false_length,
    "65,000 x 65,000 pixels where the label says 80 x 60": more_pixels_than_the_label,
    "80 x 60 pixels and 2 GB of data": more_data_than_the_header,
    "2 GB of text in a picture": a_long_text,
    "8,192 x 8,192 pixels filtered with Paeth": largest_picture,
    "an image of 3 GB": sparse("frames/00000001.png", 3_000_000_000),
    "points of 3 GB": sparse("lidar/1.bin", 3_000_000_000),
    "a label line of 3 GB": a_line_without_end,
    "a label of 2,700,000 objects": a_label_of_many_values,
    "500,000,000 empty lines": lines_without_labels,
    "a manifest of 5,000,000 labels of 0 bytes": a_manifest_of_no_lines,
    "a session.json of 900 MB": a_long_header,
}


HARMLESS = ("80 x 60 pixels and 2 GB of data", "2 GB of text in a picture", "a manifest of 5,000,000 labels of 0 bytes")
"""Harmless input: data beyond the pixels is not unpacked, and a manifest that does not fit is not used."""


@pytest.mark.skipif(sys.platform != "linux", reason="measures memory as Linux counts it")
@pytest.mark.parametrize("name", INPUTS)
def test_input_takes_less_than_a_gigabyte(tmp_path: Path, name: str) -> None:
    folder = rich.write(tmp_path / "session")
    INPUTS[name](folder)
    tests = Path(__file__).parent
    done = subprocess.run(
        [sys.executable, "-c", READ_ALL, folder, tests, tests.parent / "src"],
        capture_output=True,
        text=True,
        timeout=TIMEOUT_SECONDS,
    )
    assert done.returncode == 0, done.stderr[-2000:]
    *lines, megabytes = done.stdout.splitlines()
    print(f"{name}: {megabytes} MB; {lines[:1]}")
    assert int(megabytes) < MAX_MB
    assert all(str(folder) in line for line in lines)
    assert bool(lines) != (name in HARMLESS)
