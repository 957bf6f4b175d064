"""Harvests the sessions: harvest.py DATA [SET...]. Given again, it continues where it was stopped."""
from __future__ import annotations

import argparse
import json
import os
import shlex
import subprocess
import sys
import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import replace
from pathlib import Path
from typing import List

from sets import SETS, SessionPlan


def is_whole(folder: Path) -> bool:
    """Whether the folder has a session that is complete. One that was stopped in good order still has the mark."""
    if (folder / ".harvester-unfinished").exists():
        return False
    try:
        return bool(json.loads((folder / "session.json").read_text(encoding="utf-8"))["state"] == "complete")
    except (OSError, ValueError, KeyError):
        return False


def harvest(command: List[str], folder: Path, plan: SessionPlan, roads: str | None) -> None:
    """Harvests a session, or continues it."""
    folder.parent.mkdir(parents=True, exist_ok=True)
    done = subprocess.run(
        [*command, "harvest", "--out", str(folder), "--resume", "--quiet", *plan.options(roads)], stderr=subprocess.PIPE, text=True)
    if done.returncode != 0:
        raise RuntimeError(f"{plan.name}: {done.stderr.strip() or f'exit code {done.returncode}'}")


def main() -> int:
    """Runs the command line."""
    parser = argparse.ArgumentParser(description="Harvests the sessions to learn from. Given again, it continues.")
    parser.add_argument("data", type=Path, help="folder for the sessions")
    parser.add_argument("sets", nargs="*", help=f"sets to harvest: {', '.join(SETS)}; all without --roads but roads")
    parser.add_argument("--roads", help="road network of the game, for the set roads")
    parser.add_argument("--sessions", type=int, help="harvest only the first sessions of each set")
    parser.add_argument("--frames", type=int, help="harvest at most so many frames of each session")
    parser.add_argument("--jobs", type=int, default=os.cpu_count() or 1, help="sessions at a time; default: one for each processor")
    parser.add_argument(
        "--harvester", default=os.environ.get("GTAHARVEST_HARVESTER", "harvester"),
        help="command that runs harvester; default: the environment variable GTAHARVEST_HARVESTER, or harvester")
    options = parser.parse_args()
    unknown = set(options.sets) - set(SETS)
    if unknown:
        parser.error(f"unknown set '{min(unknown)}'; sets are {', '.join(SETS)}")
    if "roads" in options.sets and not options.roads:
        parser.error("the set roads needs --roads")
    names = options.sets or [name for name in SETS if name != "roads" or options.roads]
    plans = [
        replace(plan, frames=min(plan.frames, options.frames or plan.frames)) for name in names for plan in SETS[name][:options.sessions]]
    left = [plan for plan in plans if not is_whole(options.data / plan.name)]
    total, done = sum(plan.frames for plan in left), 0
    print(f"{len(plans)} sessions, of which {len(plans) - len(left)} are done; {total} frames to harvest", flush=True)
    command, begun = shlex.split(options.harvester), time.monotonic()
    with ThreadPoolExecutor(options.jobs) as pool:
        jobs = [(plan, pool.submit(harvest, command, options.data / plan.name, plan, options.roads)) for plan in left]
        try:
            for plan, job in jobs:
                job.result()
                done += plan.frames
                rate = done / (time.monotonic() - begun)
                print(f"{plan.name}: {done} of {total} frames, {rate:.0f}/s, {(total - done) / rate / 60:.0f} min left", flush=True)
        except (OSError, RuntimeError) as problem:
            pool.shutdown(cancel_futures=True)
            print(f"harvest.py: {problem}", file=sys.stderr)
            return 1
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
