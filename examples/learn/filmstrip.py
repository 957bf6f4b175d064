"""A film strip of a drive: what the network saw, and the lane that it estimated."""
from __future__ import annotations

from pathlib import Path
from typing import Any, Dict, List, Optional

import cv2
import numpy as np

from network import INACTIVE

FOCAL_PIXELS, HEIGHT_METRES, AHEAD_METRES = 225.2, 0.63, 2.0
"""The camera of a session of 280x210: focal length, height above the ground, and its place before the middle of the car."""

ESTIMATED, TRUE = (80, 255, 80), (255, 255, 255)
COLUMNS = 5


class FilmStrip:
    """Images with the true markings of the ego lane (white) and those that the network estimates (green)."""

    def __init__(self) -> None:
        self._images: List[np.ndarray] = []

    def add(self, image: np.ndarray, frame: Dict[str, Any], answer: Optional[np.ndarray]) -> None:
        """Adds a frame, with the indicators that answered it if it was answered by such."""
        drawn = image.copy()
        true, own = np.array(frame["torcsEquivalent"]), np.array(frame["indicators"])
        # The width of the lane is in the ratio of the two.
        scale = own[8] / true[8] if abs(true[8]) > 0.01 else 1.0
        for values, colour in ((true, TRUE), (answer, ESTIMATED)):
            if values is not None and values[7] > INACTIVE[7]:
                for marking in values[7:9]:
                    self._draw(drawn, marking * scale, values[0], colour)
        self._images.append(drawn)

    def write(self, file: Path) -> None:
        """Writes all images as one, in rows; nothing if there are none."""
        if not self._images:
            return
        while len(self._images) % COLUMNS:
            self._images.append(np.zeros_like(self._images[0]))
        rows = [np.hstack(self._images[at:at + COLUMNS]) for at in range(0, len(self._images), COLUMNS)]
        cv2.imwrite(str(file), cv2.cvtColor(np.vstack(rows), cv2.COLOR_RGB2BGR))

    @staticmethod
    def _draw(image: np.ndarray, marking: float, angle: float, colour: Any) -> None:
        height, width = image.shape[:2]
        ahead = np.array([3.0, 6.0, 10.0, 15.0])
        across = marking - (ahead + AHEAD_METRES) * np.tan(angle)
        points = np.stack((width / 2 + FOCAL_PIXELS * across / ahead, height / 2 + FOCAL_PIXELS * HEIGHT_METRES / ahead), 1)
        cv2.polylines(image, [points.round().astype(np.int32)], False, colour, 1, cv2.LINE_AA)
