"""The network: 13 indicators, or an action, from the middle of an image of 140x70 pixels."""
from __future__ import annotations

from pathlib import Path
from typing import Tuple

import numpy as np
import torch
from torch import nn

INDICATORS = 13

SCALE = np.array([0.1, 2, 2, 2, 20, 20, 2, 2, 2, 2, 20, 20, 20], np.float32)
"""What the network counts as 1: radians, metres, and metres to vehicles."""

INACTIVE = np.array([0, -7, 3.5, 7, 75, 75, -9.5, -5.5, 5.5, 9.5, 75, 75, 75], np.float32)
"""The values that stand for inactive indicators (docs/bridge.md)."""


WIDTH = 116
"""Width of what the network sees, pixels. The images are wider, so that training can turn the view."""

MOST_TURN = 12
"""Most pixels by which a view can be turned to either side."""


class NetworkError(Exception):
    """A file is not a network of train.py or imitate.py."""


class Network(nn.Module):
    """Convolutions over the image, then two linear layers, which also take the further inputs.

    forward: images (n, 3, 70, 116), float32, 0 to 1, and further inputs (n, extras) give (n, outputs).
    """

    def __init__(self, outputs: int, extras: int = 0) -> None:
        super().__init__()

        def block(before: int, after: int, size: int, stride: int) -> Tuple[nn.Module, ...]:
            return (
                nn.Conv2d(before, after, size, stride, size // 2, bias=False),
                nn.BatchNorm2d(after),
                nn.ReLU(inplace=True),
            )

        self.seen = nn.Sequential(
            *block(3, 24, 5, 2),
            *block(24, 32, 3, 2),
            *block(32, 48, 3, 2),
            *block(48, 64, 3, 1),
            *block(64, 64, 3, 2),
            nn.Flatten(),
        )
        self.hidden = nn.Sequential(nn.Linear(64 * 5 * 8 + extras, 256), nn.ReLU(inplace=True), nn.Dropout(0.3))
        self.out = nn.Linear(256, outputs)
        self.extras = extras

    def forward(self, images: torch.Tensor, extras: torch.Tensor | None = None) -> torch.Tensor:
        seen = self.seen(images)
        return self.out(self.hidden(seen if extras is None else torch.cat((seen, extras), 1)))


def load_network(file: Path) -> Network:
    """The network of a file that train.py or imitate.py wrote. Raises NetworkError, and OSError."""
    try:
        saved = torch.load(file)
        network = Network(saved["outputs"], saved["extras"])
        network.load_state_dict(saved["network"])
    except OSError:
        raise
    except Exception as problem:  # Unpickling a damaged file may raise anything.
        raise NetworkError(f"{file} is not a network of train.py or imitate.py, or is damaged.") from problem
    return network.eval()


def as_input(images: np.ndarray, turns: np.ndarray | None = None) -> torch.Tensor:
    """Images (n, 70, 140, 3), uint8, as input of the network: their middle, or what the camera sees turned to the right by pixels (n,)."""
    begins = np.full(len(images), MOST_TURN) if turns is None else MOST_TURN + turns
    seen = np.stack([image[:, begin : begin + WIDTH] for image, begin in zip(images, begins)])
    return torch.from_numpy(seen).permute(0, 3, 1, 2).float().div_(255)


def indicators_of(outputs: np.ndarray) -> Tuple[np.ndarray, np.ndarray]:
    """The indicators (n, 13) that outputs (n, 26) stand for, as in torcsEquivalent, and which are active."""
    active = outputs[:, INDICATORS:] > 0
    return np.where(active, outputs[:, :INDICATORS] * SCALE, INACTIVE), active


@torch.no_grad()
def predict(network: Network, images: np.ndarray, extras: np.ndarray | None = None) -> np.ndarray:
    """The outputs for images (n, 70, 140, 3) and further inputs (n, extras)."""
    network.eval()
    parts = [slice(at, at + 256) for at in range(0, len(images), 256)]
    return np.concatenate(
        [
            network(as_input(images[part]), None if extras is None else torch.from_numpy(extras[part])).numpy()
            for part in parts
        ]
    )
