"""Evaluates networks on sets that they have not seen: evaluate.py DATA MODEL... prints a table in Markdown.

Mean absolute errors where an indicator is active and the network takes it for active; metres are those of the road. `wrong` is the fraction
of frames in which the network takes it for the wrong one of active and inactive. The constant guess is the median of the training set.
With --all, every active indicator counts, by the value that the network has for it even if it takes it for inactive.
"""
from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Dict, List, Optional, Tuple

import numpy as np
import torch

from gtaharvest import INDICATOR_NAMES

from network import INACTIVE, INDICATORS, SCALE, Network, indicators_of, predict
from packed import Packed, load

GROUPS: Dict[str, List[str]] = {
    "angle (rad)": ["angle"],
    "ego lane (m)": ["toMarkingML", "toMarkingMR"],
    "neighbouring lanes (m)": ["toMarkingLL", "toMarkingRR"],
    "on a marking (m)": ["toMarkingL", "toMarkingM", "toMarkingR"],
    "vehicle in lane (m)": ["distMM"],
    "other vehicles (m)": ["distL", "distR", "distLL", "distRR"],
}
COLUMNS = [[INDICATOR_NAMES.index(name) for name in names] for names in GROUPS.values()]


def row(values: np.ndarray, active: Optional[np.ndarray], packed: Packed, counts_all: bool = False) -> List[str]:
    """The errors of estimates, one for each group, and the fraction of wrong activity."""
    wrong = np.abs(values - packed.values)
    wrong[:, [1, 2, 3, 6, 7, 8, 9]] *= packed.width[:, None] / 4
    counted = packed.active if active is None or counts_all else packed.active & active
    errors = [wrong[:, columns][counted[:, columns]] for columns in COLUMNS]
    cells = [f"{each.mean():.3f}" if len(each) > 0 else "none" for each in errors]
    return [*cells, "" if active is None else f"{(active != packed.active).mean():.3f}"]


def load_network(file: Path) -> Network:
    """The network of a file that train.py wrote."""
    saved = torch.load(file)
    network = Network(saved["outputs"], saved["extras"])
    network.load_state_dict(saved["network"])
    return network


def main() -> int:
    """Runs the command line."""
    parser = argparse.ArgumentParser(description="Evaluates networks on sets that they have not seen; prints a table in Markdown.")
    parser.add_argument("data", type=Path, help="folder with the packed sets")
    parser.add_argument("models", nargs="+", type=Path, help="files of train.py")
    parser.add_argument("--sets", nargs="+", default=["towns", "weathers", "roads"], help="sets; default: towns, weathers, roads")
    parser.add_argument("--all", action="store_true", help="count active indicators also where the network takes them for inactive")
    options = parser.parse_args()
    torch.set_num_threads(1)
    table: List[Tuple[str, str, List[str]]] = []
    try:
        train = load(options.data, "train")
        guess = np.array(
            [np.median(train.values[is_active, i]) if is_active.any() else INACTIVE[i] for i, is_active in enumerate(train.active.T)],
            np.float32)
        for name in options.sets:
            packed = load(options.data, name)
            for model in options.models:
                outputs = predict(load_network(model), packed.images)
                values, active = indicators_of(outputs)
                estimates = outputs[:, :INDICATORS] * SCALE if options.all else values
                table.append((name, model.stem, row(estimates, active, packed, options.all)))
            table.append((name, "constant guess", row(np.tile(guess, (len(packed), 1)), None, packed)))
    except OSError as problem:
        print(f"evaluate.py: {problem}", file=sys.stderr)
        return 1
    print("| set | network | " + " | ".join(GROUPS) + " | wrong |")
    print("|---" * (len(GROUPS) + 3) + "|")
    for name, model, cells in table:
        print(f"| {name} | {model} | " + " | ".join(cells) + " |")
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
