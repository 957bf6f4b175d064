"""Whole commands: how long they take, and how much memory."""

import json
import os
import pathlib
import platform
import subprocess
import sys
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
TOOL = ROOT / "src/Harvester.Cli/bin/Release/net10.0/harvester"
BENCHMARKS = ROOT / "bench/Harvester.Benchmarks/bin/Release/net10.0/Harvester.Benchmarks.dll"
COST = pathlib.Path(__file__).resolve().parent / "cost.py"


class Cost(NamedTuple):
    seconds: float
    processor_seconds: float
    megabytes: float


def build():
    for project in ["src/Harvester.Cli", "bench/Harvester.Benchmarks"]:
        subprocess.run(["dotnet", "build", "-c", "Release", "-v", "q", "-clp:ErrorsOnly", ROOT / project], check=True)


def publish(folder):
    """Publishes the tool for this system, compiled ahead of time, and returns its path."""
    machine = {"x86_64": "x64", "aarch64": "arm64"}[platform.machine()]
    subprocess.run(
        [
            "dotnet",
            "publish",
            "-c",
            "Release",
            "-r",
            f"linux-{machine}",
            "--no-self-contained",
            "-v",
            "q",
            "-clp:ErrorsOnly",
            "-o",
            folder,
            ROOT / "src/Harvester.Cli",
        ],
        check=True,
    )
    return os.path.join(folder, TOOL.name)


def cost_of(*arguments, tool=TOOL):
    command = [str(tool), *map(str, arguments)]
    run = subprocess.run([sys.executable, str(COST), *command], capture_output=True, text=True, check=True)
    cost = json.loads(run.stdout)
    if cost.pop("code"):
        raise SystemExit(f"{' '.join(command)}: {run.stderr}")
    return Cost(**cost)


def harvest(folder, frames, *options, tool=TOOL):
    return cost_of(
        "harvest",
        "--out",
        folder,
        "--overwrite",
        "--no-report",
        "-q",
        "--seed",
        3,
        "--frames",
        frames,
        *options,
        tool=tool,
    )


def own_figures(folder):
    text = subprocess.run(
        ["dotnet", BENCHMARKS, "figures", folder], check=True, stdout=subprocess.PIPE, text=True
    ).stdout
    return {name: float(value) for name, value in (line.split() for line in text.splitlines())}
