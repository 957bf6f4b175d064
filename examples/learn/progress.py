"""What a drive has finished, so that it can go on after a stop, and need not be driven again when it is complete."""
from __future__ import annotations

import base64
import hashlib
import json
import os
from pathlib import Path
from typing import Any, Dict, List, Optional, Tuple

import cv2
import numpy as np


class Progress:
    """A file with the model and the options of a drive, and then each town that is done: its figures, and its image for the film strip."""

    def __init__(self, file: Path, model: Path, options: Dict[str, Any]) -> None:
        """Reads what a drive of the same model with the same options has left; otherwise there is nothing."""
        self._file = file
        self.drive = {"sha256": hashlib.sha256(model.read_bytes()).hexdigest(), "options": options}
        self.done: List[Tuple[Dict[str, Any], Optional[np.ndarray]]] = []
        lines = file.read_text(encoding="utf-8").split("\n")[:-1] if file.exists() else []
        if lines and json.loads(lines[0]) == self.drive:
            self.done = [self._parse(json.loads(line)) for line in lines[1:]]

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
        image = None if text is None else cv2.imdecode(np.frombuffer(base64.b64decode(text), np.uint8), cv2.IMREAD_COLOR)
        return line["figures"], image
