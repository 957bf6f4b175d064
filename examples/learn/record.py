"""Records drives of the Stanley controller, with disturbances, for imitate.py and evaluate.py: record.py DATA [SET...].

Run again, it continues with the drives that are not done.
"""
from __future__ import annotations

import argparse
import json
import os
import shlex
import sys
from dataclasses import replace
from pathlib import Path
from typing import List

from arguments import positive
from commands import STOPPED, run_all
from harvest import is_done
from sets import DRIVES, DrivePlan


SECONDS_PER_METRE = 1


def is_whole(folder: Path) -> bool:
    """Whether the folder has a drive that was not stopped."""
    try:
        return bool(json.loads((folder / "drive.json").read_text(encoding="utf-8"))["isWhole"])
    except (OSError, ValueError, KeyError):
        return False


def driven(data: Path, plan: DrivePlan) -> Path:
    """The folder of what the drive was like; the session that it recorded has one of its own."""
    return data / "driven" / str(plan.seed)


def command_of(harvester: List[str], data: Path, plan: DrivePlan) -> List[str]:
    """The command that records a drive, in place of what there is of it."""
    return [
        *harvester,
        "drive",
        "--out",
        str(driven(data, plan)),
        "--overwrite",
        "--record",
        str(data / plan.name),
        "--quiet",
        *plan.options(),
    ]


def main() -> int:
    """Runs the command line."""
    parser = argparse.ArgumentParser(description="Records drives of a controller to imitate. Run again, it continues.")
    parser.add_argument("data", type=Path, help="folder for the sessions")
    parser.add_argument("sets", nargs="*", help=f"sets to record: {', '.join(DRIVES)}; default: all")
    parser.add_argument("--drives", type=positive, help="record only the first drives of each set")
    parser.add_argument(
        "--metres",
        type=positive,
        default=1500,
        help="distance of each drive; longer ones stay as they are; default: 1500",
    )
    parser.add_argument(
        "--jobs", type=positive, default=os.cpu_count() or 1, help="drives at a time; default: one for each processor"
    )
    parser.add_argument(
        "--harvester",
        default=os.environ.get("GTAHARVEST_HARVESTER", "harvester"),
        help="command that runs harvester; default: the environment variable GTAHARVEST_HARVESTER, or harvester",
    )
    options = parser.parse_args()
    unknown = set(options.sets) - set(DRIVES)
    if unknown:
        parser.error(f"unknown set '{min(unknown)}'; sets are {', '.join(DRIVES)}")
    names = options.sets or list(DRIVES)
    plans = [replace(plan, metres=options.metres) for name in names for plan in DRIVES[name][: options.drives]]
    left = [
        plan for plan in plans if not (is_done(options.data / plan.name, plan) and is_whole(driven(options.data, plan)))
    ]
    done = len(plans) - len(left)
    print(f"{len(plans)} drives, of which {done} are done", flush=True)

    def tell(name: str) -> None:
        nonlocal done
        done += 1
        print(f"{name}: {done} of {len(plans)} drives", flush=True)

    try:
        for name in names:
            (options.data / name).mkdir(parents=True, exist_ok=True)
        run_all(
            {plan.name: command_of(shlex.split(options.harvester), options.data, plan) for plan in left},
            options.jobs,
            tell,
            SECONDS_PER_METRE * options.jobs * options.metres,
        )
    except (OSError, RuntimeError) as problem:
        print(f"record.py: {problem}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("record.py: stopped; run the same command again to continue.", file=sys.stderr)
        return STOPPED
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
