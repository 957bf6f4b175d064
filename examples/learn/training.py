"""The training loop: resumable, epoch by epoch."""
from __future__ import annotations

import argparse
import json
import os
import time
import zipfile
from pathlib import Path
from typing import Any, Callable, Dict, List

import torch

from arguments import model_file, positive
from network import Network
from packed import Packed

BATCH = 64
RATE = 1.5e-3

CHANGES_NOTHING = ("data", "model", "threads")
"""Options that do not change what is learnt; of the data, a digest counts."""


class TrainingError(Exception):
    """The state file is not one of this training."""


def add_options(parser: argparse.ArgumentParser, epochs: int) -> None:
    """Adds the options of a training."""
    parser.add_argument("data", type=Path, help="folder with the packed sets")
    parser.add_argument(
        "model",
        type=model_file,
        help="file to write, such as full.pt; the lines of its epochs go to full.jsonl, and what continuing needs to full.state, which "
        "another training with this name refuses",
    )
    parser.add_argument("--epochs", type=positive, default=epochs, help=f"epochs; default: {epochs}")
    parser.add_argument("--seed", type=int, default=1, help="seed of weights, order and variations; default: 1")
    parser.add_argument("--threads", type=positive, default=os.cpu_count() or 1, help="processors to use; default: all")


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
    packed: Packed,
    validation: Packed,
    loss_of: Callable[[torch.Tensor, torch.Generator], torch.Tensor],
    errors_on: Callable[[Network, Packed], Dict[str, float]],
    options: argparse.Namespace,
) -> None:
    """Trains on packed and writes the model. Continues after the last epoch that is in the model's state file, with the same result as if
    it had not been stopped; raises TrainingError if the file is of another training.

    loss_of: the loss of a batch of frames. errors_on: the errors on validation, for the log.
    """
    count = len(packed)
    steps = (count + BATCH - 1) // BATCH
    optimiser = torch.optim.AdamW(network.parameters(), RATE, weight_decay=5e-3)
    schedule = torch.optim.lr_scheduler.OneCycleLR(optimiser, RATE, total_steps=steps * options.epochs, pct_start=0.15)
    parts = {"network": network, "optimiser": optimiser, "schedule": schedule}
    state_file, log_file = options.model.with_suffix(".state"), options.model.with_suffix(".jsonl")
    training = {
        **{name: value for name, value in vars(options).items() if name not in CHANGES_NOTHING},
        "data": [packed.digest(), validation.digest()],
    }
    lines = _restored(state_file, training, parts) if state_file.exists() else []
    for epoch in range(len(lines), options.epochs):
        watch, total = time.monotonic(), 0.0
        random = torch.Generator().manual_seed(options.seed * 1000 + epoch)
        order = torch.randperm(count, generator=random)
        network.train()
        for at in range(0, count, BATCH):
            batch = order[at : at + BATCH]
            loss = loss_of(batch, random)
            optimiser.zero_grad()
            loss.backward()
            optimiser.step()
            schedule.step()
            total += float(loss) * len(batch)
        lines.append(
            json.dumps(
                {
                    "epoch": epoch + 1,
                    "seconds": round(time.monotonic() - watch, 1),
                    "loss": total / count,
                    **errors_on(network, validation),
                }
            )
        )
        print(lines[-1], flush=True)
        replace(log_file, lambda file: file.write_text("\n".join(lines) + "\n", encoding="utf-8"))
        replace(
            state_file,
            lambda file: torch.save(
                {
                    "training": training,
                    "lines": lines,
                    "random": torch.get_rng_state(),
                    **{name: part.state_dict() for name, part in parts.items()},
                },
                file,
            ),
        )
    replace(
        options.model,
        lambda file: torch.save(
            {"network": network.state_dict(), "outputs": network.out.out_features, "extras": network.extras}, file
        ),
    )


def _restored(file: Path, training: Dict[str, Any], parts: Dict[str, Any]) -> List[str]:
    """Puts everything into the state after the last epoch; returns the lines of the epochs."""
    remedy = f"Choose another name for the model, or delete {file} to start over."
    try:
        with zipfile.ZipFile(file) as archive:
            if archive.testzip() is not None:
                raise zipfile.BadZipFile
        state = torch.load(file)
        former = state["training"]
        if former == training:
            for name, part in parts.items():
                part.load_state_dict(state[name])
            torch.set_rng_state(state["random"])
            return list(state["lines"])
    except OSError:
        raise
    except Exception as problem:  # Unpickling a damaged file may raise anything.
        raise TrainingError(f"{file} is damaged, or of another version. {remedy}") from problem
    differing = [name for name in {**former, **training} if former.get(name) != training.get(name)]
    raise TrainingError(
        f"{file} belongs to a training run with {', '.join(_shown(name, former.get(name)) for name in differing)}. {remedy}"
    )


def _shown(name: str, value: Any) -> str:
    if name == "data":
        return "other data"
    return f"no --{name}" if value is None else f"--{name} {value}"


def replace(file: Path, write: Callable[[Path], Any]) -> None:
    """Writes a file under another name, and gives it its own when it is whole."""
    part = file.with_name(file.name + ".part")
    write(part)
    os.replace(part, file)
