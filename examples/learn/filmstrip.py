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


def picture_of(image: np.ndarray, frame: Dict[str, Any], answer: Optional[np.ndarray]) -> np.ndarray:
    """A frame with the true markings of the ego lane (white) and, if indicators answered it, those that they give (green)."""
    drawn = image.copy()
    true, own = np.array(frame["torcsEquivalent"]), np.array(frame["indicators"])
    # The width of the lane is in the ratio of the two.
    scale = own[8] / true[8] if abs(true[8]) > 0.01 else 1.0
    for values, colour in ((true, TRUE), (answer, ESTIMATED)):
        if values is not None and values[7] > INACTIVE[7]:
            for marking in values[7:9]:
                _draw(drawn, marking * scale, values[0], colour)
    return drawn


def write(file: Path, pictures: List[np.ndarray]) -> None:
    """Writes pictures as one, in rows; nothing if there are none. Raises OSError."""
    if not pictures:
        return
    blanks = [np.zeros_like(pictures[0])] * (-len(pictures) % COLUMNS)
    shown = [*pictures, *blanks]
    rows = [np.hstack(shown[at : at + COLUMNS]) for at in range(0, len(shown), COLUMNS)]
    if not cv2.imwrite(str(file), cv2.cvtColor(np.vstack(rows), cv2.COLOR_RGB2BGR)):
        raise OSError(f"{file} cannot be written.")


def _draw(image: np.ndarray, marking: float, angle: float, colour: Any) -> None:
    height, width = image.shape[:2]
    ahead = np.array([3.0, 6.0, 10.0, 15.0])
    across = marking - (ahead + AHEAD_METRES) * np.tan(angle)
    points = np.stack((width / 2 + FOCAL_PIXELS * across / ahead, height / 2 + FOCAL_PIXELS * HEIGHT_METRES / ahead), 1)
    cv2.polylines(image, [points.round().astype(np.int32)], False, colour, 1, cv2.LINE_AA)
