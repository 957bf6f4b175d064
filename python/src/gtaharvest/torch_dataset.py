"""Sessions as a dataset of PyTorch. Needs torch."""

from __future__ import annotations

import bisect
import itertools
import os
from typing import Any, Callable, Dict, Optional, Sequence, Tuple, Union

import numpy as np
import torch
from torch.utils.data import Dataset

from .frame import View
from .selection import Selection, check_classes
from .session import Session, open_session

_FIELDS = {"cuboid": "box2d", "amodal": "box2d_amodal", "visible": "box2d_visible", "whole": "box2d_whole"}

Sample = Tuple[torch.Tensor, Dict[str, torch.Tensor]]


class DetectionDataset(Dataset[Any]):
    """Images with their boxes, in the form that torchvision's detectors take.

    An item is (image, target). image: (3, height, width), float32, 0 to 1. target: `boxes` (n, 4), float32, xMin, yMin, xMax, yMax in
    pixels; `labels` (n,), int64, the index of the class in `classes` plus 1 (0 is background); `ids` (n,); `ignore` (m, 4), regions that
    are neither object nor background; `frame`, the number of the frame.

    Can be used by several workers: each process opens the files for itself.
    """

    def __init__(
        self,
        sessions: Union[Session, str, os.PathLike[str], Sequence[Union[Session, str, os.PathLike[str]]]],
        classes: Optional[Sequence[str]] = None,
        selection: Selection = Selection(),
        boxes: str = "cuboid",
        transform: Optional[Callable[[torch.Tensor, Dict[str, torch.Tensor]], Any]] = None,
    ) -> None:
        """sessions: one or several, opened or by folder. classes: those to detect; the ones of the first session by default.
        selection: a further filter; objects that do not pass it become `ignore` regions, as do undetermined ones.
        boxes: `cuboid` (box2d), `amodal` (box2dAmodal), `visible` (box2dVisible, which needs masks) or `whole` (box2dWhole, which
        needs amodal masks). transform: applied to each item.
        """
        several = [sessions] if isinstance(sessions, (Session, str, os.PathLike)) else list(sessions)
        if not several:
            raise ValueError("Give at least one session.")
        if boxes not in _FIELDS:
            raise ValueError(f"Unknown kind of box '{boxes}'; kinds are {', '.join(_FIELDS)}.")
        check_classes(classes)
        self.sessions = [each if isinstance(each, Session) else open_session(each) for each in several]
        self.classes = tuple(classes if classes is not None else self.sessions[0].classes)
        self._selection = selection
        self._field = _FIELDS[boxes]
        self._transform = transform
        self._ends = list(itertools.accumulate(map(len, self.sessions)))

    def __len__(self) -> int:
        return self._ends[-1]

    def view(self, position: int) -> View:
        """The view of an item."""
        if not -len(self) <= position < len(self):
            raise IndexError(f"The dataset has {len(self)} frames; there is none at {position}.")
        position %= len(self)
        session = bisect.bisect_right(self._ends, position)
        return self.sessions[session][position - (self._ends[session - 1] if session else 0)].view

    def __getitem__(self, position: int) -> Any:
        view = self.view(position)
        image = torch.from_numpy(np.ascontiguousarray(view.image().transpose(2, 0, 1))).float().div_(255)
        target = self._target(view)
        return (image, target) if self._transform is None else self._transform(image, target)

    def _target(self, view: View) -> Dict[str, torch.Tensor]:
        number_of = {name: number + 1 for number, name in enumerate(self.classes)}
        known = [item for item in view.objects if item.class_name in number_of]
        taken = [item for item in known if self._selection.takes(item) and getattr(item, self._field) is not None]
        ids = {item.id for item in taken}
        ignored = [item.box2d for item in known if item.id not in ids]
        ignored += [region.box2d for region in view.ignore_regions if region.class_name in number_of]
        return {
            "boxes": torch.tensor([getattr(item, self._field) for item in taken], dtype=torch.float32).reshape(-1, 4),
            "labels": torch.tensor([number_of[item.class_name] for item in taken], dtype=torch.int64),
            "ids": torch.tensor([item.id for item in taken], dtype=torch.int64),
            "ignore": torch.tensor(ignored, dtype=torch.float32).reshape(-1, 4),
            "frame": torch.tensor(view.frame),
        }


def collate(samples: Sequence[Sample]) -> Tuple[torch.Tensor, Tuple[Dict[str, torch.Tensor], ...]]:
    """The collate_fn of a DataLoader: images of one size as one tensor, targets as a tuple."""
    images, targets = zip(*samples)
    return torch.stack(images), targets
