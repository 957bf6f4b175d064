"""Untrusted pictures: only the formats of sessions, each by its own decoder, and files that are neither pipes nor devices."""

from __future__ import annotations

import os
import random
import struct
import subprocess
import sys
import zlib
from pathlib import Path
from typing import Any, Iterator

import mutation
import numpy as np
import pytest
import rich
from conftest import HEIGHT, WIDTH, HandmadeSession, image

import gtaharvest
from gtaharvest import jpeg, pictures, png
from gtaharvest.pictures import Decoder

DECODERS = {"_opencv": "cv2", "_pillow": "PIL"}
CASES = 300
SEED = 20260101


@pytest.fixture(params=DECODERS)
def decoder(request: pytest.FixtureRequest, monkeypatch: pytest.MonkeyPatch) -> Iterator[str]:
    """Reads JPEG with one decoder, as if no other were installed."""
    pytest.importorskip(DECODERS[request.param])
    for name in DECODERS:
        if name != request.param:
            monkeypatch.setattr(pictures, name, absent)
    pictures.jpeg_decoder.cache_clear()
    yield request.param
    pictures.jpeg_decoder.cache_clear()


def absent() -> Decoder:
    raise ImportError


def encoded(progressive: bool = False) -> bytes:
    cv2 = pytest.importorskip("cv2")
    options = [cv2.IMWRITE_JPEG_QUALITY, 95, cv2.IMWRITE_JPEG_PROGRESSIVE, int(progressive)]
    return bytes(cv2.imencode(".jpg", image(0)[..., ::-1].copy(), options)[1])


def session_with(handmade: HandmadeSession, data: bytes, name: str = "frames/0.jpg") -> gtaharvest.Frame:
    handmade.lines[0]["image"] = name
    folder = handmade.write()
    (folder / name).write_bytes(data)
    return gtaharvest.open_session(folder)[0]


def test_jpeg_is_decoded(handmade: HandmadeSession, decoder: str) -> None:
    # At quality 95, with half the resolution of colours, a smooth picture differs by a few levels.
    assert np.abs(session_with(handmade, encoded()).image().astype(int) - image(0)).mean() < 2


def test_jpeg_without_a_decoder_is_refused(handmade: HandmadeSession, monkeypatch: pytest.MonkeyPatch) -> None:
    for name in DECODERS:
        monkeypatch.setattr(pictures, name, absent)
    pictures.jpeg_decoder.cache_clear()
    with pytest.raises(gtaharvest.PictureError, match="needs Pillow or OpenCV"):
        session_with(handmade, encoded()).image()
    pictures.jpeg_decoder.cache_clear()


def test_only_what_pixels_need_reaches_the_decoder() -> None:
    sound = encoded()
    comment = b"\xff\xfe" + struct.pack(">H", 1002) + bytes(1000)
    assert jpeg.essential(sound[:2] + comment + sound[2:]) == jpeg.essential(sound)


@pytest.mark.parametrize(
    "name, data, words",
    [
        ("EPS", b"%!PS-Adobe-3.0 EPSF-3.0\n%%BoundingBox: 0 0 80 60\n", "not a PNG, JPEG or BMP"),
        ("GIF", b"GIF89a" + bytes(50), "not a PNG, JPEG or BMP"),
        ("TIFF", b"II*\0" + bytes(50), "not a PNG, JPEG or BMP"),
        (
            "PNG with a palette",
            png.SIGNATURE + b"\0\0\0\rIHDR" + struct.pack(">IIBBBBB", WIDTH, HEIGHT, 8, 3, 0, 0, 0) + bytes(50),
            "palette",
        ),
        (
            "BMP with run lengths",
            b"BM" + bytes(16) + struct.pack("<iiHHI", WIDTH, HEIGHT, 1, 24, 1) + bytes(50),
            "uncompressed BMP",
        ),
        ("empty", b"", "not a PNG, JPEG or BMP"),
    ],
)
def test_other_formats_reach_no_decoder(
    handmade: HandmadeSession, monkeypatch: pytest.MonkeyPatch, name: str, data: bytes, words: str
) -> None:
    def decode(_: bytes) -> Any:
        raise AssertionError("a decoder was called")

    monkeypatch.setattr(pictures, "jpeg_decoder", lambda: decode)
    for ending in ("png", "jpg", "bmp"):
        with pytest.raises(gtaharvest.PictureError, match=words):
            session_with(handmade, data, f"frames/0.{ending}").image()


def test_jpeg_of_another_kind_reaches_no_decoder(handmade: HandmadeSession, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(pictures, "jpeg_decoder", None)
    sound = encoded()
    start = sound.index(b"\xff\xc0")
    for data, words in (
        (encoded(progressive=True), "not a baseline JPEG"),
        (sound[:-2], "cut off"),
        (sound + sound, "after its end"),
        (
            sound[: start + 5] + struct.pack(">HH", 65_500, 65_500) + sound[start + 9 :],
            "65500x65500 pixels; its label says 80x60",
        ),
    ):
        with pytest.raises(gtaharvest.PictureError, match=words):
            session_with(handmade, data).image()


def test_mutated_jpeg_never_escapes(handmade: HandmadeSession, decoder: str) -> None:
    sound = encoded()
    frame = session_with(handmade, sound)
    refused = 0
    for case in range(CASES):
        frame.view.image_path.write_bytes(mutation.of_bytes(sound, random.Random(f"{SEED} {case}")))
        try:
            assert frame.image().shape == (HEIGHT, WIDTH, 3)
        except gtaharvest.SessionError as problem:
            assert str(problem).isprintable()
            refused += 1
    assert CASES / 4 < refused < CASES


@pytest.mark.parametrize("kinds", ["34", "43210", "0123401234", "444", "1240"])
def test_filters_are_undone_as_the_specification_says(kinds: str) -> None:
    """Rows with the filters in turn, encoded here by the formulas of the specification."""
    chance = np.random.default_rng(5)
    for height, width, channels in ((1, 1, 1), (7, 1, 3), (1, 9, 3), (13, 6, 3), (5, 17, 1)):
        picture = chance.integers(0, 256, (height, width, channels)).astype(np.uint8)
        flat = picture.reshape(height, -1).astype(int)
        rows = b""
        for y, row in enumerate(flat):
            kind = int(kinds[y % len(kinds)])
            rows += bytes([kind])
            for x, value in enumerate(row):
                a = row[x - channels] if x >= channels else 0
                b = flat[y - 1][x] if y else 0
                c = flat[y - 1][x - channels] if y and x >= channels else 0
                p = a + b - c
                paeth = min(((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c)))[2]
                rows += bytes([(value - (0, a, b, (a + b) // 2, paeth)[kind]) % 256])
        header = struct.pack(">IIBBBBB", width, height, 8, 0 if channels == 1 else 2, 0, 0, 0)
        data = png.SIGNATURE + b"".join(
            struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body))
            for kind, body in ((b"IHDR", header), (b"IDAT", zlib.compress(rows)), (b"IEND", b""))
        )
        np.testing.assert_array_equal(png.decode(data), picture[..., 0] if channels == 1 else picture)


@pytest.mark.parametrize(
    "name",
    [
        "session.json",
        "labels.jsonl",
        "manifest.jsonl",
        "frames/00000001.png",
        "masks/00000001.png",
        "classes/1.png",
        "depth/1.png",
        "pairs/1.png",
        "lidar/1.bin",
    ],
)
@pytest.mark.parametrize("kind", ["pipe", "device"])
def test_pipe_or_device_does_not_block(tmp_path: Path, name: str, kind: str) -> None:
    """In a process of its own, which a pipe without a writer would block forever."""
    folder = rich.write(tmp_path / "session")
    (folder / name).unlink(missing_ok=True)
    if kind == "pipe":
        os.mkfifo(folder / name)
    else:
        (folder / name).symlink_to("/dev/zero")
    tests = Path(__file__).parent
    program = "import sys; sys.path[:0] = sys.argv[2:]\nimport test_hostile, pathlib\nprint(test_hostile.refusals(pathlib.Path(sys.argv[1])))"
    done = subprocess.run(
        [sys.executable, "-c", program, folder, tests, tests.parent / "src"], capture_output=True, text=True, timeout=60
    )
    assert done.returncode == 0, done.stderr[-2000:]
    # Without a manifest the lines are searched for.
    assert (int(done.stdout) > 0) == (name != "manifest.jsonl")
