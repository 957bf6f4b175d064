"""Harvests the pictures of docs/scenarios.md: one frame of each scenario in data/scenarios.

python3 docs/images/scenarios/make.py HARVESTER [NAME...], where HARVESTER is the command, e.g. "dotnet harvester.dll".
"""

import json
import pathlib
import shlex
import shutil
import subprocess
import sys
import tempfile

HERE = pathlib.Path(__file__).resolve().parent
LIBRARY = HERE.parents[2] / "data" / "scenarios"
HZ = 2
SEED = "3"
AFTER_EVENT_SECONDS = 1.0


def moment_of(session: pathlib.Path) -> float:
    """The time of the picture: a second after the first event that is not there from the start, or two fifths of the scenario."""
    record = json.loads((session / "scenario.json").read_text())
    begun = [e["seconds"] for e in record["events"] if e["state"] == "begun" and e["seconds"] > 0.2]
    return begun[0] + AFTER_EVENT_SECONDS if begun else 0.4 * record["scenario"]["end"]["seconds"]


def main(harvester: list[str], names: list[str]) -> None:
    """Makes the pictures of the named scenarios, or of all."""
    for file in sorted(LIBRARY.glob("*.json")):
        name = file.stem
        if name.endswith(".plan") or (names and name not in names):
            continue
        with tempfile.TemporaryDirectory() as folder:
            session = pathlib.Path(folder) / "session"
            options = ["--hz", str(HZ), "--size", "320x240", "--format", "jpg", "--quality", "75", "--detail", "full"]
            run = [*harvester, "scenario", "run", str(file), "--seed", SEED, "--out", str(session), "--no-report", "-q", *options]
            subprocess.run(run, check=True)
            frames = sorted((session / "frames").glob("*.jpg"))
            frame = frames[min(len(frames) - 1, round(moment_of(session) * HZ))]
            shutil.copy(frame, HERE / f"{name}.jpg")
            print(name, frame.name)


if __name__ == "__main__":
    main(shlex.split(sys.argv[1]), sys.argv[2:])
