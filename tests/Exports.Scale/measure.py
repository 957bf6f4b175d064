"""Counts and exports long sessions, in every format, and measures the memory that it takes at its peak: it must not grow with the session."""

import json
import os
import shutil
import sys
import time

FORMATS = [
    "kitti",
    "kitti-tracking",
    "coco",
    "coco-panoptic",
    "yolo",
    "yolo-segment",
    "voc",
    "cityscapes",
    "bdd100k",
    "motchallenge",
    "openlabel",
    "deepdriving",
    "tusimple",
    "culane",
    "openlane",
    "webdataset",
    "imagefolder",
    "mcap",
    "csv",
    "parquet",
]
# These keep a session in one split.
WHOLE_SESSIONS = {"kitti-tracking", "motchallenge", "openlabel", "mcap"}
MOST_MEBIBYTES = 300
# What the runtime's collector leaves lying about differs from run to run; a list of all frames would add hundreds of mebibytes.
MOST_GROWTH_MEBIBYTES = 60


def run(command):
    """Runs a command and gives the seconds it took and the mebibytes that it held at its peak."""
    start = time.monotonic()
    child = os.posix_spawnp(
        command[0], command, os.environ, file_actions=[(os.POSIX_SPAWN_OPEN, 1, os.devnull, os.O_WRONLY, 0)]
    )
    _, status, usage = os.wait4(child, 0)
    if status != 0:
        sys.exit(f"failed: {' '.join(command)}")
    return time.monotonic() - start, usage.ru_maxrss / 1024


def lengthen(source, target, frames):
    """Makes a long session of a short one: the same labels over and over, images and masks as further names of the same files."""
    with open(os.path.join(source, "labels.jsonl"), encoding="utf-8") as file:
        labels = [json.loads(line) for line in file]
    for folder in ("frames", "masks"):
        os.makedirs(os.path.join(target, folder))
    with open(os.path.join(source, "session.json"), encoding="utf-8") as file:
        info = json.load(file)
    info["counters"]["captured"] = frames
    with open(os.path.join(target, "session.json"), "w", encoding="utf-8") as file:
        json.dump(info, file)
    with open(os.path.join(target, "labels.jsonl"), "w", encoding="utf-8") as file:
        for frame in range(frames):
            label = labels[frame % len(labels)] | {"frame": frame}
            for field, folder in (("image", "frames"), ("mask", "masks")):
                name = f"{folder}/{frame:08d}.png"
                link(os.path.join(source, labels[frame % len(labels)][field]), os.path.join(target, name))
                label[field] = name
            file.write(json.dumps(label, separators=(",", ":")) + "\n")


def link(source, target):
    try:
        os.link(source, target)
    except OSError:
        # The number of names of a file is limited.
        copy = source + ".copy"
        shutil.copyfile(source, copy)
        os.replace(copy, source)
        os.link(source, target)


def measure(harvester, scratch, lengths, formats):
    peaks = {}
    for frames in lengths:
        session = os.path.join(scratch, f"session-{frames}")
        lengthen(os.path.join(scratch, "short"), session, frames)
        seconds, peak = run([*harvester, "stats", session])
        peaks.setdefault("stats", []).append(peak)
        print(f"| stats of the session | {frames:,} | {seconds:.0f} | {peak:.0f} | | |", flush=True)
        for name in formats:
            out = os.path.join(scratch, "out")
            splits = [] if name in WHOLE_SESSIONS else ["--split", "train:0.8,val:0.2", "--split-block", "100"]
            seconds, export_peak = run([*harvester, "export", session, "--format", name, "--out", out, *splits])
            check_seconds, check_peak = run([*harvester, "validate", out])
            shutil.rmtree(out)
            peaks.setdefault(name, []).append(export_peak)
            print(
                f"| {name} | {frames:,} | {seconds:.0f} | {export_peak:.0f} | {check_seconds:.0f} | {check_peak:.0f} |",
                flush=True,
            )
        shutil.rmtree(session)
    return peaks


if __name__ == "__main__":
    harvester, scratch, lengths = sys.argv[1].split(), sys.argv[2], [int(word) for word in sys.argv[3].split(",")]
    formats = sys.argv[4].split(",") if len(sys.argv) > 4 else FORMATS
    print("| format | frames | export, s | peak, MiB | validate, s | peak, MiB |\n|---|---|---|---|---|---|")
    grown = [
        name
        for name, peaks in measure(harvester, scratch, lengths, formats).items()
        if max(peaks) > MOST_MEBIBYTES or peaks[-1] > peaks[0] + MOST_GROWTH_MEBIBYTES
    ]
    sys.exit(f"Too much memory: {', '.join(grown)}" if grown else 0)
