"""Trains a network for the indicators: train.py DATA MODEL [--labels KIND]. Run again, it continues after the last epoch.

The model's .jsonl has a line for each epoch: seconds, loss, and on the validation set the mean absolute errors of the angle (rad) and of
the markings of the ego lane (m), and the fraction of indicators whose activity is wrong.
"""
from __future__ import annotations

import argparse
import sys
from typing import Dict, Tuple

import numpy as np
import torch
from torch import nn

from arguments import positive
from commands import STOPPED
from network import INDICATORS, MOST_TURN, SCALE, Network, as_input, indicators_of, predict
from packed import Packed, PackedError, load
from training import TrainingError, add_options, fit, varied

ACTIVITY_WEIGHT = 0.3

MARKINGS = [1, 2, 3, 6, 7, 8, 9]
"""The indicators that are distances to markings."""

PIXELS_PER_RADIAN = 112.6
AHEAD_METRES = 2.0
"""The camera of a session, in images of half its size: focal length, and distance to the middle of the car."""

MIRRORED = [0, 3, 2, 1, 5, 4, 9, 8, 7, 6, 12, 11, 10]
"""The indicator that each becomes in a mirror."""

MIRROR_SIGNS = np.array([-1, -1, -1, -1, 1, 1, -1, -1, -1, -1, 1, 1, 1], np.float32)


def labels_of(packed: Packed, kind: str) -> Tuple[np.ndarray, np.ndarray]:
    """Values and activity of each frame: as they are (true), of the frame before (shifted), or left and right exchanged (mirrored)."""
    if kind == "shifted":
        before = np.arange(len(packed)) - 1
        before[np.r_[True, packed.frames[1:, 0] != packed.frames[:-1, 0]]] += 1
        return packed.values[before], packed.active[before]
    if kind == "mirrored":
        return packed.values[:, MIRRORED] * MIRROR_SIGNS, packed.active[:, MIRRORED]
    return packed.values, packed.active


def turned(values: np.ndarray, width: np.ndarray, radians: np.ndarray, sign: float) -> np.ndarray:
    """The values (n, 13) of views turned to the right about the camera, which is AHEAD_METRES before the middle of the car."""
    result = values.copy()
    result[:, 0] += sign * radians
    result[:, MARKINGS] += (sign * AHEAD_METRES * radians * 4 / np.nan_to_num(width, nan=4.0))[:, None]
    return result


def loss_of(outputs: torch.Tensor, values: torch.Tensor, active: torch.Tensor) -> torch.Tensor:
    """Errors of active indicators, and of what is active."""
    errors = nn.functional.smooth_l1_loss(outputs[:, :INDICATORS], values, reduction="none", beta=0.1)
    activity = nn.functional.binary_cross_entropy_with_logits(outputs[:, INDICATORS:], active)
    return (errors * active).sum() / active.sum().clamp(min=1) + ACTIVITY_WEIGHT * activity


def errors_on(network: Network, packed: Packed) -> Dict[str, float]:
    """The errors on a set, as in the log."""
    values, active = indicators_of(predict(network, packed.images))
    wrong = np.abs(values - packed.values)
    lane = wrong[:, 7:9] * packed.width[:, None] / 4
    return {
        "angle": float(wrong[:, 0][packed.active[:, 0] & active[:, 0]].mean()),
        "lane": float(lane[packed.active[:, 7:9] & active[:, 7:9]].mean()),
        "activity": float((active != packed.active).mean()),
    }


def train(options: argparse.Namespace) -> None:
    """Trains the network of a command line."""
    options.model.parent.mkdir(parents=True, exist_ok=True)
    packed, validation = load(options.data, options.set).first(options.sessions), load(options.data, "validation")
    values, active = labels_of(packed, options.labels)
    wanted = torch.from_numpy(active.astype(np.float32))
    torch.manual_seed(options.seed)
    network = Network(2 * INDICATORS)

    def loss_of_batch(batch: torch.Tensor, random: torch.Generator) -> torch.Tensor:
        rows = batch.numpy()
        turns = torch.randint(-MOST_TURN, MOST_TURN + 1, (len(rows),), generator=random).numpy()
        sign = -1.0 if options.labels == "mirrored" else 1.0
        targets = turned(values[rows], packed.width[rows], turns / PIXELS_PER_RADIAN, sign) / SCALE
        images = varied(as_input(packed.images[rows], turns), random)
        return loss_of(network(images), torch.from_numpy(targets.astype(np.float32)), wanted[batch])

    fit(network, packed, validation, loss_of_batch, errors_on, options)


def main() -> int:
    """Runs the command line."""
    parser = argparse.ArgumentParser(
        description="Trains a network for the indicators. Run again, it continues after the last epoch."
    )
    add_options(parser, epochs=32)
    parser.add_argument("--set", default="train", help="set to learn from; default: train")
    parser.add_argument("--sessions", type=positive, help="use only the first sessions of the set")
    parser.add_argument(
        "--labels", choices=("true", "shifted", "mirrored"), default="true", help="labels to learn; default: true"
    )
    options = parser.parse_args()
    torch.set_num_threads(options.threads)
    try:
        train(options)
    except (OSError, PackedError, TrainingError) as problem:
        print(f"train.py: {problem}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("train.py: stopped; run the same command again to continue.", file=sys.stderr)
        return STOPPED
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
