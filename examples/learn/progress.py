"""What a drive has finished, so that it can continue after a stop, and need not be driven again when it is complete."""
from __future__ import annotations

import base64
import hashlib
import json
import os
from pathlib import Path
from typing import Any, Dict, List, Optional, Tuple

import cv2
import numpy as np


class ProgressError(Exception):
    """The file is not one of this drive."""


class Progress:
    """A file with the model and the options of a drive, and then each town that is done: its figures, and its image for the film strip."""

    def __init__(self, file: Path, model: Path, options: Dict[str, Any], roads: Optional[Path] = None) -> None:
        """Reads what a drive of the same model with the same options, on the same road network, has left.

        Raises ProgressError if the file is of another drive, or damaged.
        """
        self._file = file
        self.drive = {
            "sha256": _digest(model),
            "options": options,
            "roadsSha256": None if roads is None else _digest(roads),
        }
        self.done: List[Tuple[Dict[str, Any], Optional[np.ndarray]]] = []
        if not file.exists():
            return
        remedy = f"Choose another file for the figures with --out, or delete {file} to start over."
        try:
            former, *towns = [json.loads(line) for line in file.read_text(encoding="utf-8").split("\n")[:-1]]
            done = [self._parse(line) for line in towns]
            differing = [
                name
                for key, name in (("sha256", "model"), ("roadsSha256", "road network"))
                if former[key] != self.drive[key]
            ]
            differing += [
                f"--{name.replace('_', '-')}" for name in options if former["options"].get(name) != options[name]
            ]
        except (ValueError, KeyError, TypeError, AttributeError, cv2.error) as problem:
            raise ProgressError(f"{file} is damaged, or of another version. {remedy}") from problem
        if differing:
            raise ProgressError(f"{file} belongs to a drive with another {', another '.join(differing)}. {remedy}")
        self.done = done

    def add(self, figures: Dict[str, Any], image: Optional[np.ndarray]) -> None:
        """Adds a town; the file then has it, or is as it was."""
        self.done.append((figures, image))
        part = self._file.with_suffix(".part")
        lines = [self.drive, *({"figures": each, "image": self._text_of(shown)} for each, shown in self.done)]
        part.write_text("".join(json.dumps(line) + "\n" for line in lines), encoding="utf-8")
        os.replace(part, self._file)

    @staticmethod
    def _text_of(image: Optional[np.ndarray]) -> Optional[str]:
        return None if image is None else base64.b64encode(cv2.imencode(".png", image)[1]).decode()

    @staticmethod
    def _parse(line: Dict[str, Any]) -> Tuple[Dict[str, Any], Optional[np.ndarray]]:
        text = line["image"]
        image = (
            None if text is None else cv2.imdecode(np.frombuffer(base64.b64decode(text), np.uint8), cv2.IMREAD_COLOR)
        )
        return line["figures"], image


def _digest(file: Path) -> str:
    return hashlib.sha256(file.read_bytes()).hexdigest()
