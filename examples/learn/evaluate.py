"""Evaluates networks on sets that they have not seen: evaluate.py DATA MODEL... prints tables in Markdown.

Mean absolute errors where an indicator is active and the network takes it for active; metres are those of the road. `wrong` is the fraction
of indicators that the network takes for the wrong one of active and inactive. The constant guess is the median of the training set, and
counts wherever an indicator is active. With --all, the networks count there too, by the value that they have even for what they take for
inactive.

Policies have a table of their own: mean absolute errors of steering (1 is full lock) and pedal on the set `unseen`, where the recorded
controller drove; the constant guess is the median of the set `drives`.
"""
from __future__ import annotations

import argparse
import sys
from pathlib import Path
from typing import Dict, List, Mapping, Optional

import numpy as np
import torch

from gtaharvest import INDICATOR_NAMES

import imitate
from actions import POLICY_OUTPUTS
from network import INACTIVE, INDICATORS, SCALE, Network, NetworkError, indicators_of, load_network, predict
from packed import Packed, PackedError, load

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


def indicator_table(networks: Mapping[Path, Network], data: Path, sets: List[str], counts_all: bool) -> List[List[str]]:
    """The errors of networks for indicators, by their files, and of the constant guess on each set; the first row has the headings."""
    train = load(data, "train")
    guess = np.array(
        [
            np.median(train.values[is_active, i]) if is_active.any() else INACTIVE[i]
            for i, is_active in enumerate(train.active.T)
        ],
        np.float32,
    )
    table = [["set", "network", *GROUPS, "wrong"]]
    for name in sets:
        packed = load(data, name)
        for file, network in networks.items():
            outputs = predict(network, packed.images)
            values, active = indicators_of(outputs)
            estimates = outputs[:, :INDICATORS] * SCALE if counts_all else values
            table.append([name, file.stem, *row(estimates, active, packed, counts_all)])
        table.append([name, "constant guess", *row(np.tile(guess, (len(packed), 1)), None, packed)])
    return table


def policy_table(policies: Mapping[Path, Network], data: Path) -> List[List[str]]:
    """The errors of policies, by their files, and of the constant guess on unseen drives; the first row has the headings."""
    guess = np.median(imitate.targets_of(imitate.controlled(load(data, "drives"))), axis=0)
    unseen = imitate.controlled(load(data, "unseen"))
    errors = [(file.stem, imitate.errors_on(policy, unseen)) for file, policy in policies.items()]
    errors.append(("constant guess", imitate.errors_of(guess, unseen)))
    return [
        ["set", "network", "steering", "pedal"],
        *(["unseen", name, f"{each['steering']:.4f}", f"{each['pedal']:.3f}"] for name, each in errors),
    ]


def markdown(table: List[List[str]]) -> str:
    """A table as Markdown."""
    headings, *rows = ["| " + " | ".join(cells) + " |" for cells in table]
    return "\n".join([headings, "|---" * len(table[0]) + "|", *rows])


def main() -> int:
    """Runs the command line."""
    parser = argparse.ArgumentParser(
        description="Evaluates networks on sets that they have not seen; prints tables in Markdown."
    )
    parser.add_argument("data", type=Path, help="folder with the packed sets")
    parser.add_argument("models", nargs="+", type=Path, help="files of train.py and imitate.py")
    parser.add_argument(
        "--sets",
        nargs="+",
        default=["towns", "weathers", "roads"],
        help="sets for networks of train.py; default: towns, weathers, roads. Policies are evaluated on the set unseen",
    )
    parser.add_argument(
        "--all",
        action="store_true",
        help="count active indicators also where the network takes them for inactive, as the constant guess always does",
    )
    options = parser.parse_args()
    torch.set_num_threads(1)
    try:
        networks = {file: load_network(file) for file in options.models}
        policies = {file: network for file, network in networks.items() if network.out.out_features == POLICY_OUTPUTS}
        others = {file: network for file, network in networks.items() if file not in policies}
        tables = [indicator_table(others, options.data, options.sets, options.all)] if others else []
        tables += [policy_table(policies, options.data)] if policies else []
    except (NetworkError, OSError, PackedError) as problem:
        print(f"evaluate.py: {problem}", file=sys.stderr)
        return 1
    print("\n\n".join(markdown(table) for table in tables))
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
