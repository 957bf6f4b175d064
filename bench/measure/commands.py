"""Whole commands: how long they take, and how much memory."""

import os
import pathlib
import subprocess
import time
from typing import NamedTuple

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
TOOL = ROOT / "src/Harvester.Cli/bin/Release/net10.0/harvester"
BENCHMARKS = ROOT / "bench/Harvester.Benchmarks/bin/Release/net10.0/Harvester.Benchmarks.dll"
BYTES_PER_KILOBYTE = 1024  # of ru_maxrss on Linux


class Cost(NamedTuple):
    seconds: float
    processor_seconds: float
    megabytes: float


def build():
    for project in ["src/Harvester.Cli", "bench/Harvester.Benchmarks"]:
        subprocess.run(["dotnet", "build", "-c", "Release", "-v", "q", "-clp:ErrorsOnly", ROOT / project], check=True)


def cost_of(*arguments):
    start = time.perf_counter()
    command = [str(TOOL), *map(str, arguments)]
    process = subprocess.Popen(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
    problem = process.stderr.read()
    _, status, usage = os.wait4(process.pid, 0)
    if status:
        raise SystemExit(f"{' '.join(command)}: {problem.decode(errors='replace')}")
    megabytes = usage.ru_maxrss * BYTES_PER_KILOBYTE / 1e6
    return Cost(time.perf_counter() - start, usage.ru_utime + usage.ru_stime, megabytes)


def harvest(folder, frames, *options):
    return cost_of("harvest", "--out", folder, "--overwrite", "--no-report", "-q", "--seed", 3, "--frames", frames, *options)


def own_figures(folder):
    text = subprocess.run(["dotnet", BENCHMARKS, "figures", folder], check=True, stdout=subprocess.PIPE, text=True).stdout
    return {name: float(value) for name, value in (line.split() for line in text.splitlines())}
