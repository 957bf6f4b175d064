"""What drives in drive.py: a trained network."""
from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, Protocol

import numpy as np
import torch

from actions import POLICY_OUTPUTS, STEERING_SCALE, extras_of
from network import Network, as_input, indicators_of, load_network
from pack import shrink


class Driver(Protocol):
    """Drives by images. action: as DrivingEnv takes it."""

    action: str

    def answer(self, image: np.ndarray, frame: Dict[str, Any]) -> np.ndarray:
        """The answer to a frame."""


class IndicatorDriver:
    """Estimates the indicators; the game's controller drives by them."""

    action = "indicators"

    def __init__(self, network: Network) -> None:
        self._network = network

    @torch.no_grad()
    def answer(self, image: np.ndarray, frame: Dict[str, Any]) -> np.ndarray:
        """Thirteen indicators, as in torcsEquivalent."""
        return indicators_of(self._network(as_input(shrink(image)[None])).numpy())[0][0]


class PolicyDriver:
    """A policy learnt from recorded actions: steering and pedals from image, speed and route command."""

    action = "controls"

    def __init__(self, network: Network) -> None:
        self._network = network

    @torch.no_grad()
    def answer(self, image: np.ndarray, frame: Dict[str, Any]) -> np.ndarray:
        """Steering, throttle and brake."""
        extras = torch.from_numpy(extras_of(frame["speedMetresPerSecond"], frame["route"])[None])
        steering, pedal = self._network(as_input(shrink(image)[None]), extras).numpy()[0]
        return np.array(
            [np.clip(steering * STEERING_SCALE, -1, 1), np.clip(pedal, 0, 1), np.clip(-pedal, 0, 1)], np.float32
        )


def load_driver(file: Path) -> Driver:
    """The driver of a file that train.py or imitate.py wrote."""
    network = load_network(file)
    return PolicyDriver(network) if network.out.out_features == POLICY_OUTPUTS else IndicatorDriver(network)
