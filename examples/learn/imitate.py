"""Trains a policy on recorded actions: imitate.py DATA MODEL. Run again, it continues after the last epoch.

The policy sees the image, the speed and the route command, and answers with steering and pedal, as the recorded controller did outside
junctions. The model's .jsonl has, for each epoch, the mean absolute errors of both on the last sessions, which it does not learn from.
"""
from __future__ import annotations

import argparse
import sys
from typing import Dict

import numpy as np
import torch
from torch import nn

from actions import EXTRAS, POLICY_OUTPUTS, ROUTES, STEERING_SCALE, extras_of
from arguments import positive
from commands import STOPPED
from network import Network, as_input, predict
from packed import Packed, PackedError, load
from training import TrainingError, add_options, fit, varied

SPEED_NOISE = 0.1


def controlled(recorded: Packed) -> Packed:
    """The frames of recorded drives in which the controller drove."""
    return recorded.where(recorded.by_controller & ~np.isnan(recorded.controls).any(1))


def inputs_of(packed: Packed) -> np.ndarray:
    """The further inputs of the frames."""
    return np.stack(
        [
            extras_of(speed, None if np.isnan(route) else ROUTES[int(route)])
            for speed, route in zip(packed.speed, packed.route)
        ]
    )


def targets_of(packed: Packed) -> np.ndarray:
    """What the policy has to give for the frames: steering and pedal."""
    return np.stack((packed.controls[:, 0] / STEERING_SCALE, packed.controls[:, 1] - packed.controls[:, 2]), 1)


def errors_on(network: Network, packed: Packed) -> Dict[str, float]:
    """The errors on some frames."""
    return errors_of(predict(network, packed.images, inputs_of(packed)), packed)


def errors_of(outputs: np.ndarray, packed: Packed) -> Dict[str, float]:
    """The mean absolute errors of outputs, of each frame (n, 2) or the same for all (2,)."""
    wrong = np.abs(outputs - targets_of(packed)).mean(0)
    return {"steering": float(wrong[0] * STEERING_SCALE), "pedal": float(wrong[1])}


def train(options: argparse.Namespace) -> None:
    """Trains the policy of a command line."""
    options.model.parent.mkdir(parents=True, exist_ok=True)
    recorded = load(options.data, "drives")
    driven = controlled(recorded)
    is_held_out = driven.frames[:, 0] > recorded.frames[:, 0].max() - options.validation
    packed, validation = driven.where(~is_held_out), driven.where(is_held_out)
    if len(packed) == 0 or len(validation) == 0:
        raise PackedError(
            f"The set drives has {int(recorded.frames[:, 0].max()) + 1} drives, too few to hold out {options.validation} and to learn from "
            "others; record more, or give another --validation."
        )
    extras, targets = torch.from_numpy(inputs_of(packed)), torch.from_numpy(targets_of(packed))
    torch.manual_seed(options.seed)
    network = Network(POLICY_OUTPUTS, EXTRAS)

    def loss_of(batch: torch.Tensor, random: torch.Generator) -> torch.Tensor:
        further = extras[batch]
        further[:, 0] *= 1 + SPEED_NOISE * torch.randn(len(batch), generator=random)
        return nn.functional.l1_loss(
            network(varied(as_input(packed.images[batch.numpy()]), random), further), targets[batch]
        )

    fit(network, packed, validation, loss_of, errors_on, options)


def main() -> int:
    """Runs the command line."""
    parser = argparse.ArgumentParser(
        description="Trains a policy on recorded actions. Run again, it continues after the last epoch."
    )
    add_options(parser, epochs=12)
    parser.add_argument(
        "--validation",
        type=positive,
        default=2,
        help="number of recorded drives to hold out for the curves, the last ones; default: 2, so that it learns from 18 of 20",
    )
    options = parser.parse_args()
    torch.set_num_threads(options.threads)
    try:
        train(options)
    except (OSError, PackedError, TrainingError) as problem:
        print(f"imitate.py: {problem}", file=sys.stderr)
        return 1
    except KeyboardInterrupt:
        print("imitate.py: stopped; run the same command again to continue.", file=sys.stderr)
        return STOPPED
    return 0


if __name__ == "__main__":
    raise SystemExit(main())
