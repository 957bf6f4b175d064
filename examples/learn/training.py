"""The training loop: resumable, epoch by epoch."""
from __future__ import annotations

import argparse
import json
import os
import time
from pathlib import Path
from typing import Any, Callable, Dict

import torch

from network import Network

BATCH = 64
RATE = 1.5e-3


def add_options(parser: argparse.ArgumentParser, epochs: int) -> None:
    """Adds the options of a training."""
    parser.add_argument("data", type=Path, help="folder with the packed sets")
    parser.add_argument("model", type=Path, help="file to write, such as full.pt; the lines of its epochs go to full.jsonl")
    parser.add_argument("--epochs", type=int, default=epochs, help=f"passes over the images; default: {epochs}")
    parser.add_argument("--seed", type=int, default=1, help="seed of weights, order and variations; default: 1")
    parser.add_argument("--threads", type=int, default=os.cpu_count() or 1, help="processors to use; default: all")


def varied(images: torch.Tensor, random: torch.Generator) -> torch.Tensor:
    """Images with other brightness, contrast and colour, and noise, as other weathers and hours have."""
    count = len(images)
    colour = 0.8 + 0.4 * torch.rand(count, 3, 1, 1, generator=random)
    light = 0.6 + 0.8 * torch.rand(count, 1, 1, 1, generator=random)
    contrast = 0.7 + 0.6 * torch.rand(count, 1, 1, 1, generator=random)
    mean = images.mean((1, 2, 3), keepdim=True)
    noise = 0.02 * torch.randn(images.shape, generator=random)
    return (((images - mean) * contrast + mean) * light * colour + noise).clamp_(0, 1)


def fit(
    network: Network,
    count: int,
    loss_of: Callable[[torch.Tensor, torch.Generator], torch.Tensor],
    errors: Callable[[], Dict[str, float]],
    options: argparse.Namespace,
) -> None:
    """Trains on samples 0 to count - 1 and writes the model. Continues after the last epoch that is in the model's state file.

    loss_of: the loss of a batch of samples. errors: the errors on the validation set, for the log.
    """
    steps = (count + BATCH - 1) // BATCH
    optimiser = torch.optim.AdamW(network.parameters(), RATE, weight_decay=5e-3)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimiser, RATE, total_steps=steps * options.epochs, pct_start=0.15)
    state_file, log_file = options.model.with_suffix(".state"), options.model.with_suffix(".jsonl")
    begun = 0
    if state_file.exists():
        state: Dict[str, Any] = torch.load(state_file)
        for part, name in ((network, "network"), (optimiser, "optimiser"), (schedule, "schedule")):
            part.load_state_dict(state[name])
        begun = state["epochs"]
    lines = log_file.read_text(encoding="utf-8").splitlines()[:begun] if log_file.exists() else []
    for epoch in range(begun, options.epochs):
        watch, total = time.monotonic(), 0.0
        random = torch.Generator().manual_seed(options.seed * 1000 + epoch)
        order = torch.randperm(count, generator=random)
        network.train()
        for at in range(0, count, BATCH):
            batch = order[at:at + BATCH]
            loss = loss_of(batch, random)
            optimiser.zero_grad()
            loss.backward()
            optimiser.step()
            schedule.step()
            total += float(loss) * len(batch)
        lines.append(json.dumps(
            {"epoch": epoch + 1, "seconds": round(time.monotonic() - watch, 1), "loss": total / count, **errors()}))
        print(lines[-1], flush=True)
        replace(log_file, lambda file: file.write_text("\n".join(lines) + "\n", encoding="utf-8"))
        replace(state_file, lambda file: torch.save({
            "network": network.state_dict(), "optimiser": optimiser.state_dict(), "schedule": schedule.state_dict(),
            "epochs": epoch + 1}, file))
    replace(options.model, lambda file: torch.save(
        {"network": network.state_dict(), "outputs": network.out.out_features, "extras": network.extras}, file))


def replace(file: Path, write: Callable[[Path], Any]) -> None:
    """Writes a file under another name, and gives it its own when it is whole."""
    part = file.with_name(file.name + ".part")
    write(part)
    os.replace(part, file)
