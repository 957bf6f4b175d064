"""Harvests the sessions: harvest.py DATA [SET...]. Run again, it continues where it was stopped."""
from __future__ import annotations

import argparse
import json
import os
import shlex
import sys
import time
from dataclasses import replace
from pathlib import Path
from typing import List

from arguments import positive
from commands import STOPPED, run_all
from sets import SETS, Plan, SessionPlan

SECONDS_PER_FRAME = 1

UNFINISHED = ".harvester-unfinished"
"""The file with the command that is not done with a folder, also if it was stopped in good order."""


def is_done(folder: Path, plan: Plan) -> bool:
    """Whether the folder has a session of the plan that is complete."""
    if (folder / UNFINISHED).exists():
        return False
    try:
        session = json.loads((folder / "session.json").read_text(encoding="utf-8"))
        return bool(session["state"] == "complete" and plan.is_of(session))
    except (OSError, ValueError, KeyError):
        return False


def command_of(harvester: List[str], folder: Path, plan: SessionPlan, roads: str | None) -> List[str]:
    """The command that harvests a session, or continues it if it is of this plan. A session of another plan is replaced."""
    unfinished, begins = folder / UNFINISHED, " ".join(["harvester harvest", *plan.options(None)])
    is_begun = unfinished.exists() and unfinished.read_text(encoding="utf-8").startswith(begins)
    return [
        *harvester,
        "harvest",
        "--out",
        str(folder),
        "--resume" if is_begun else "--overwrite",
        "--quiet",
        *plan.options(roads),
    ]


def main() -> int:
    """Runs the command line."""
    parser = argparse.ArgumentParser(description="Harvests the sessions to learn from. Run again, it continues.")
    parser.add_argument("data", type=Path, help="folder for the sessions")
    parser.add_argument("sets", nargs="*", help=f"sets to harvest: {', '.join(SETS)}; all without --roads but roads")
    parser.add_argument("--roads", help="road network of the game, for the set roads")
    parser.add_argument("--sessions", type=positive, help="harvest only the first sessions of each set")
    parser.add_argument(
        "--frames", type=positive, help="harvest at most N frames of each session; those with more stay as they are"
    )
    parser.add_argument(
        "--jobs", type=positive, default=os.cpu_count() or 1, help="sessions at a time; default: one for each processor"
    )
    parser.add_argument(
        "--harvester",
        default=os.environ.get("GTAHARVEST_HARVESTER", "harvester"),
        help="command that runs harvester; default: the environment variable GTAHARVEST_HARVESTER, or harvester",
    )
    options = parser.parse_args()
    unknown = set(options.sets) - set(SETS)
    if unknown:
        parser.error(f"unknown set '{min(unknown)}'; sets are {', '.join(SETS)}")
    if "roads" in options.sets and not options.roads:
        parser.error("the set roads needs --roads")
    names = options.sets or [name for name in SETS if name != "roads" or options.roads]
    plans = [
        replace(plan, frames=min(plan.frames, options.frames or plan.frames))
        for name in names
        for plan in SETS[name][: options.sessions]
    ]
    left = {plan.name: plan for plan in plans if not is_done(options.data / plan.name, plan)}
    total, done = sum(plan.frames for plan in left.values()), 0
    print(f"{len(plans)} sessions, of which {len(plans) - len(left)} are done; {total} frames to harvest", flush=True)
    harvester, begun = shlex.split(options.harvester), time.monotonic()

    def tell(name: str) -> None:
        nonlocal done
        done += left[name].frames
        rate = done / (time.monotonic() - begun)
        print(f"{name}: {done} of {total} frames, {rate:.0f}/s, {(total - done) / rate / 60:.0f} min left", flush=True)

    try:
        for name in names:
            (options.data / name).mkdir(parents=True, exist_ok=True)
        run_all(
            {name: command_of(harvester, options.data / name, plan, options.roads) for name, plan in left.items()},
            options.jobs,
            tell,
            SECONDS_PER_FRAME * options.jobs * max((plan.frames for plan in left.values()), default=0),
        )
    except (OSError, RuntimeError) as problem:
        print(f"harvest.py: {problem}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("harvest.py: stopped; run the same command again to continue.", file=sys.stderr)
        return STOPPED
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
