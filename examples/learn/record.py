"""Records drives of the Stanley controller, with disturbances, for imitate.py: record.py DATA. Given again, it continues."""
from __future__ import annotations

import argparse
import json
import os
import shlex
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import List

from harvest import is_whole
from sets import DRIVES, DrivePlan


def is_driven(folder: Path) -> bool:
    """Whether the folder has a drive that was not stopped."""
    try:
        return bool(json.loads((folder / "drive.json").read_text(encoding="utf-8"))["isWhole"])
    except (OSError, ValueError, KeyError):
        return False


def record(command: List[str], data: Path, plan: DrivePlan, metres: int) -> str:
    """Records a drive, unless that is done; returns its name."""
    folder = data / "drives" / plan.name
    if not (is_whole(folder) and is_driven(data / "driven" / plan.name)):
        done = subprocess.run(
            [*command, "drive", "--out", str(data / "driven" / plan.name), "--overwrite", "--record", str(folder), "--quiet",
             *plan.options(metres)],
            stderr=subprocess.PIPE, text=True)
        if done.returncode != 0:
            raise RuntimeError(f"{plan.name}: {done.stderr.strip() or f'exit code {done.returncode}'}")
    return plan.name


def main() -> int:
    """Runs the command line."""
    parser = argparse.ArgumentParser(description="Records drives of a controller to imitate. Given again, it continues.")
    parser.add_argument("data", type=Path, help="folder for the sessions")
    parser.add_argument("--drives", type=int, help="record only the first drives")
    parser.add_argument("--metres", type=int, default=1500, help="distance of each drive; default: 1500")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="drives at a time; default: one for each processor")
    parser.add_argument(
        "--harvester", default=os.environ.get("GTAHARVEST_HARVESTER", "harvester"),
        help="command that runs harvester; default: the environment variable GTAHARVEST_HARVESTER, or harvester")
    options = parser.parse_args()
    command, plans = shlex.split(options.harvester), DRIVES[:options.drives]
    (options.data / "drives").mkdir(parents=True, exist_ok=True)
    with ThreadPoolExecutor(options.jobs) as pool:
        try:
            for number, name in enumerate(pool.map(lambda plan: record(command, options.data, plan, options.metres), plans)):
                print(f"{name}: {number + 1} of {len(plans)} drives", flush=True)
        except (OSError, RuntimeError) as problem:
            pool.shutdown(cancel_futures=True)
            print(f"record.py: {problem}", file=sys.stderr)
            return 1
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
