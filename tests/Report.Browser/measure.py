"""Speed of the viewer with a large session, made of a small one by repeating its lines: measure.py HARVESTER SESSION FRAMES."""

import json
import os
import pathlib
import shutil
import statistics
import sys
import tempfile
import time
import urllib.request

import page as pages

STEPS = 100
PAUSE_SECONDS = 0.2  # Between two frames, as a person would pause; playback is not measured.


def enlarge(source: pathlib.Path, target: pathlib.Path, frames: int):
    """The frames of a session again and again under new numbers, with the same images."""
    shutil.copytree(source / "frames", target / "frames")
    header = json.loads((source / "session.json").read_text())
    header["manifest"] = False
    header["counters"]["captured"] = frames
    (target / "session.json").write_text(json.dumps(header))
    lines = (source / "labels.jsonl").read_text().splitlines()
    # "frame" is the first field of a line.
    rests = [line[line.index(",") :] for line in lines]
    with open(target / "labels.jsonl", "w") as labels:
        for number in range(frames):
            labels.write(f'{{"frame":{number}{rests[number % len(rests)]}\n')


def measure(session: pathlib.Path):
    from serving import viewer

    size = (session / "labels.jsonl").stat().st_size
    print(f"{state_count(session)} frames, {size / 1e9:.2f} GB of labels", flush=True)
    with pages.browser() as driver, viewer(session) as address:
        served = time.monotonic()
        driver.get(address)
        page = pages.Page(driver, address)
        opening = page.script("return performance.getEntriesByName('first frame')[0].startTime")
        print(f"from the request of the page to its first frame: {opening / 1000:.2f} s", flush=True)
        state = lambda: json.loads(urllib.request.urlopen(address + "state").read())
        while not state()["isIndexed"]:
            time.sleep(0.01)
        print(
            f"all lines are indexed at most {time.monotonic() - served:.2f} s after the address was printed", flush=True
        )
        times = []
        for _ in range(STEPS):
            times.append(
                page.script("const begun = performance.now(); await step(1); return performance.now() - begun")
            )
            time.sleep(PAUSE_SECONDS)
        print(
            f"next frame: median {statistics.median(times):.0f} ms, 95 % within {sorted(times)[int(0.95 * STEPS)]:.0f} ms; "
            f"load {os.getloadavg()[0]:.1f}",
            flush=True,
        )
        while state()["read"] < state()["frames"]:
            time.sleep(0.5)
        print(f"all labels are read {time.monotonic() - served:.0f} s after the address was printed", flush=True)
        page.wait(lambda: page.script("return source.known === source.count"))
        filtering = page.script(
            "const begun = performance.now(); state.farthest = 30; refilter(); return performance.now() - begun"
        )
        heap = page.script("return performance.memory.usedJSHeapSize")
        print(f"a change of filters takes {filtering:.0f} ms; heap of the page {heap / 1e6:.0f} MB", flush=True)


def state_count(session):
    return json.loads((session / "session.json").read_text())["counters"]["captured"]


if __name__ == "__main__":
    os.environ["REPORT_HARVESTER"] = sys.argv[1]
    with tempfile.TemporaryDirectory() as scratch:
        large = pathlib.Path(scratch) / "large"
        large.mkdir()
        enlarge(pathlib.Path(sys.argv[2]), large, int(sys.argv[3]))
        measure(large)
