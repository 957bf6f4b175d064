"""From a harvest to the falling loss of a first small detector: tutorial.py SESSION [--harvester COMMAND]. Needs torch.

If the folder SESSION does not exist, the simulated game is harvested into it first. docs/python.md explains the steps.
"""

import argparse
import shlex
import subprocess
import sys
from pathlib import Path

import torch
from gtaharvest import Selection, SessionError
from gtaharvest.torch_dataset import DetectionDataset, collate
from torch import nn
from torch.nn import functional
from torch.utils.data import DataLoader, Subset

CLASSES = ("car", "truck", "bus")
STRIDE = 8


def harvest(folder, command, frames):
    """1. Harvest. The simulated game needs no GTA V; the same seed gives the same session."""
    subprocess.run(
        [
            *shlex.split(command),
            "harvest",
            "--out",
            str(folder),
            "--frames",
            str(frames),
            "--seed",
            "11",
            "--size",
            "280x210",
            "--traffic",
            "2",
            "--no-scenes",
            "--no-report",
            "--quiet",
        ],
        check=True,
    )


def mirror_half(image, target):
    """Mirrors every second image or so, so that the network sees more."""
    if torch.rand(()) < 0.5:
        width = image.shape[2]
        image = image.flip(2)
        for name in ("boxes", "ignore"):
            x_min, y_min, x_max, y_max = target[name].T
            target[name] = torch.stack([width - x_max, y_min, width - x_min, y_max], dim=1)
    return image, target


class Detector(nn.Module):
    """3. A network that gives each cell of 8x8 pixels a score for the centre of a vehicle, and the width and height of its box."""

    def __init__(self):
        super().__init__()
        layers, channels = [], 3
        for width, stride in ((16, 2), (32, 2), (48, 2), (48, 1)):
            layers += [nn.Conv2d(channels, width, 3, stride, 1), nn.BatchNorm2d(width), nn.ReLU()]
            channels = width
        self.body = nn.Sequential(*layers)
        self.head = nn.Conv2d(channels, 3, 3, padding=1)
        # At first, every cell scores 2 %: nearly all are background.
        nn.init.constant_(self.head.bias[:1].detach(), -4)

    def forward(self, images):
        output = self.head(self.body(images - 0.5))
        return output[:, 0], output[:, 1:]


def loss_of(scores, sizes, targets):
    """4. The loss: focal loss of the scores, and L1 of the logarithms of the sizes at the centres."""
    wanted, weight = torch.zeros_like(scores), torch.ones_like(scores)
    size_loss = scores.new_zeros(())
    rows, columns = scores.shape[1:]
    for number, target in enumerate(targets):
        # A region that may show an unlabelled object is neither object nor background.
        for x_min, y_min, x_max, y_max in (target["ignore"] / STRIDE).tolist():
            weight[number, int(y_min) : int(y_max) + 1, int(x_min) : int(x_max) + 1] = 0
        boxes = target["boxes"]
        centres = ((boxes[:, :2] + boxes[:, 2:]) / 2 / STRIDE).long()
        column, row = centres[:, 0].clamp(0, columns - 1), centres[:, 1].clamp(0, rows - 1)
        wanted[number, row, column] = 1
        weight[number, row, column] = 1
        logarithms = (boxes[:, 2:] - boxes[:, :2]).clamp(min=1).div(STRIDE).log()
        size_loss = size_loss + (sizes[number, :, row, column].T - logarithms).abs().sum()
    likelihood = functional.binary_cross_entropy_with_logits(scores, wanted, reduction="none")
    hardness = (scores.sigmoid() - wanted).abs() ** 2
    return ((weight * hardness * likelihood).sum() + 0.1 * size_loss) / wanted.sum().clamp(min=1)


def main():
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("session", type=Path)
    arguments.add_argument(
        "--harvester", default="harvester", metavar="COMMAND", help="how to start harvester (default: harvester)"
    )
    arguments.add_argument("--frames", type=int, default=240)
    arguments.add_argument("--epochs", type=int, default=8)
    arguments.add_argument("--workers", type=int, default=2)
    options = arguments.parse_args()
    if not options.session.exists():
        harvest(options.session, options.harvester, options.frames)

    # 2. Read it. Objects that are mostly hidden or tiny are ignored in training, not background.
    wanted = Selection(min_visible_fraction=0.3, min_side_pixels=4)
    data = DetectionDataset(options.session, CLASSES, wanted)
    mirrored = DetectionDataset(options.session, CLASSES, wanted, transform=mirror_half)
    # Neighbouring frames look alike, so the frames held out are the last ones.
    split = len(data) * 5 // 6
    torch.manual_seed(1)
    workers = {"num_workers": options.workers, "persistent_workers": options.workers > 0, "collate_fn": collate}
    training = DataLoader(Subset(mirrored, range(split)), batch_size=8, shuffle=True, **workers)
    held_out = DataLoader(Subset(data, range(split, len(data))), batch_size=8, **workers)

    detector = Detector()
    optimiser = torch.optim.Adam(detector.parameters(), lr=3e-3)
    for epoch in range(1, options.epochs + 1):
        sums = {}
        for name, loader in (("training", training), ("held out", held_out)):
            detector.train(loader is training)
            sums[name] = 0.0
            for images, targets in loader:
                with torch.set_grad_enabled(loader is training):
                    loss = loss_of(*detector(images), targets)
                if loader is training:
                    optimiser.zero_grad()
                    loss.backward()
                    optimiser.step()
                sums[name] += loss.item() / len(loader)
        print(f"epoch {epoch}: " + ", ".join(f"{name} loss {value:.4f}" for name, value in sums.items()), flush=True)


if __name__ == "__main__":
    try:
        main()
    except (SessionError, OSError, subprocess.CalledProcessError) as problem:
        sys.exit(f"{problem}")
