"""Draws the curves of trainings: plot.py OUT.png MODEL... reads the .jsonl of each model."""
from __future__ import annotations

import argparse
import json
import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402


def main() -> int:
    """Runs the command line."""
    parser = argparse.ArgumentParser(description="Draws the errors on the validation set over the epochs.")
    parser.add_argument("out", type=Path, help="image to write")
    parser.add_argument("models", nargs="+", type=Path, help="files of train.py")
    options = parser.parse_args()
    figure, axes = pyplot.subplots(1, 2, figsize=(9, 3.2), layout="constrained")
    try:
        for model in options.models:
            with open(model.with_suffix(".jsonl"), encoding="utf-8") as log:
                lines = [json.loads(line) for line in log]
            for axis, key in zip(axes, ("angle", "lane")):
                axis.plot([line["epoch"] for line in lines], [line[key] for line in lines], label=model.stem)
    except OSError as problem:
        print(f"plot.py: {problem}", file=sys.stderr)
        return 1
    for axis, title in zip(axes, ("angle, rad", "markings of the ego lane, m")):
        axis.set_title(f"mean absolute error: {title}", fontsize=9)
        axis.set_xlabel("epoch", fontsize=9)
        axis.set_ylim(bottom=0)
        axis.grid(alpha=0.3)
    axes[0].legend(fontsize=8)
    figure.savefig(options.out, dpi=80)
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
