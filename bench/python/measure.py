"""Measures the Python package: measure.py SESSION [--long FRAMES]. The figures are in docs/python.md; times are processor time.

SESSION: images of 280x210 with masks. --long: also makes a session of that many frames by repeating its labels, in a temporary folder
(40 kB of labels per frame), and measures how long it takes to open.
"""

import argparse
import json
import re
import shutil
import tempfile
import time
from pathlib import Path

import gtaharvest


def best(action, rounds=5):
    """The shortest of some runs, seconds."""
    times = []
    for _ in range(rounds):
        start = time.process_time()
        action()
        times.append(time.process_time() - start)
    return min(times)


def rate(session, name, read):
    seconds = best(lambda: [read(frame) for frame in session])
    print(f"{name}: {len(session) / seconds:.0f} frames/s")


def measure(session):
    rate(session, "labels as records", lambda frame: frame.objects)
    rate(session, "labels and images", lambda frame: (frame.objects, frame.image()))
    rate(
        session, "labels as arrays, images and masks", lambda frame: (frame.view.arrays(), frame.image(), frame.mask())
    )
    rate(session, "the same and lanes", lambda frame: (frame.view.arrays(), frame.image(), frame.mask(), frame.lanes))


def lengthen(session, folder, frames):
    lines = (session.folder / "labels.jsonl").read_bytes().splitlines()
    shutil.copy(session.folder / "session.json", folder)
    with open(folder / "labels.jsonl", "wb") as labels, open(folder / "manifest.jsonl", "wb") as manifest:
        entry = json.loads((session.folder / "manifest.jsonl").read_bytes().splitlines()[0])
        for number in range(frames):
            line = re.sub(rb'^\{"frame":\d+', b'{"frame":%d' % number, lines[number % len(lines)])
            labels.write(line + b"\n")
            entry["frame"], entry["label"]["bytes"] = number, len(line)
            manifest.write(json.dumps(entry, separators=(",", ":")).encode() + b"\n")


def measure_opening(folder):
    def open_and_read():
        opened = gtaharvest.open_session(folder)
        assert opened[len(opened) // 2].objects
        return opened

    for name in ("with its manifest", "without a manifest"):
        start = time.perf_counter()
        seconds, frames = best(open_and_read, 3), len(open_and_read())
        elapsed = (time.perf_counter() - start) / 4
        print(f"opening {frames} frames {name} and reading one: {seconds:.2f} s ({elapsed:.2f} s elapsed)")
        (folder / "manifest.jsonl").unlink(missing_ok=True)


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("session", type=Path)
    arguments.add_argument("--long", type=int, metavar="FRAMES")
    options = arguments.parse_args()
    session = gtaharvest.open_session(options.session)
    measure(session)
    if options.long:
        with tempfile.TemporaryDirectory() as folder:
            lengthen(session, Path(folder), options.long)
            measure_opening(Path(folder))


main()
