"""Draws the curves of trainings: plot.py OUT.png MODEL... reads the .jsonl of each model."""
from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path
from typing import Dict, List

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

from arguments import output_image  # noqa: E402


TITLES = {"angle": "angle, rad", "lane": "markings of the ego lane, m", "steering": "steering", "pedal": "pedal"}


def main() -> int:
    """Runs the command line."""
    parser = argparse.ArgumentParser(description="Draws the errors on the validation set over the epochs.")
    parser.add_argument("out", type=output_image, help="image to write, .png or .jpg")
    parser.add_argument("models", nargs="+", type=Path, help="files of train.py and imitate.py")
    options = parser.parse_args()
    curves: Dict[Path, List[Dict[str, float]]] = {}
    try:
        for model in options.models:
            log = model.with_suffix(".jsonl")
            curves[model] = [json.loads(line) for line in log.read_text(encoding="utf-8").splitlines()]
            if not all(isinstance(line, dict) and "epoch" in line for line in curves[model] or [None]):
                raise ValueError(f"{log} is not the log of a training.")
    except (OSError, ValueError) as problem:
        print(f"plot.py: {problem}", file=sys.stderr)
        return 1
    shown = [key for key in TITLES if any(key in line for lines in curves.values() for line in lines)]
    figure, axes = pyplot.subplots(1, len(shown), figsize=(4.5 * len(shown), 3.2), layout="constrained", squeeze=False)
    for key, axis in zip(shown, axes[0]):
        for model, lines in curves.items():
            if key in lines[0]:
                axis.plot([line["epoch"] for line in lines], [line[key] for line in lines], label=model.stem)
        axis.set_title(f"mean absolute error: {TITLES[key]}", fontsize=9)
        axis.set_xlabel("epoch", fontsize=9)
        axis.set_ylim(bottom=0)
        axis.grid(alpha=0.3)
        axis.legend(fontsize=8)
    figure.savefig(options.out, dpi=80)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
