"""docs/performance.md: the table between its marks."""

import datetime
import os
import pathlib
import platform

import cv2
import numpy

from measure.commands import ROOT

PAGE = ROOT / "docs/performance.md"
BEGIN, END = "<!-- bench/run: begin -->", "<!-- bench/run: end -->"
HEADER = ("what", "goal", "measured", "beside it, in the same run", "ratio", "measured by")


def write(rows, command, load):
    lines = [line(HEADER), "|" + "---|" * len(HEADER), *map(line, rows)]
    cores = os.cpu_count()
    note = [
        f"Measured by `{command}` on {datetime.date.today().isoformat()}: {processor()}, {cores} cores, Linux {platform.release()},",
        f"OpenCV {cv2.__version__}, NumPy {numpy.__version__}. The mean load of the machine was {load[0]:.1f} before the run and "
        f"{load[1]:.1f} after it;",
        f"an idle machine has about 0 before and at most {cores} after, and on a busier one all times are longer.",
    ]
    text = PAGE.read_text(encoding="utf-8")
    before, after = text.split(BEGIN)[0], text.split(END)[1]
    PAGE.write_text(before + "\n".join([BEGIN, "", *note, "", *lines, "", END]) + after, encoding="utf-8")


def line(cells):
    return "| " + " | ".join(cells) + " |"


def processor():
    for text in pathlib.Path("/proc/cpuinfo").read_text(encoding="utf-8").splitlines():
        if text.startswith("model name"):
            return text.split(":", 1)[1].strip()
    return platform.processor()
