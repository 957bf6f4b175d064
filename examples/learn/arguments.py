"""Kinds of arguments of the command lines."""
from __future__ import annotations

import argparse
import math
from pathlib import Path


def positive(text: str) -> int:
    """A whole number of at least 1."""
    try:
        number = int(text)
    except ValueError:
        number = 0
    if number < 1:
        raise argparse.ArgumentTypeError(f"'{text}' is not a whole number of at least 1")
    return number


def positive_real(text: str) -> float:
    """A finite number greater than 0."""
    try:
        number = float(text)
    except ValueError:
        number = math.nan
    if not 0 < number < math.inf:
        raise argparse.ArgumentTypeError(f"'{text}' is not a number greater than 0")
    return number


def model_file(text: str) -> Path:
    """A file of a network, *.pt: what else belongs to it has the same name with other suffixes."""
    file = Path(text)
    if file.suffix != ".pt" or file.is_dir():
        raise argparse.ArgumentTypeError(f"'{text}' is not the name of a file that ends with .pt")
    return file


def output_image(text: str) -> Path:
    """An image file to write, in a folder that exists."""
    file = output_file(text)
    if file.suffix.lower() not in (".png", ".jpg", ".jpeg"):
        raise argparse.ArgumentTypeError(f"'{text}' does not end with .png or .jpg")
    return file


def output_file(text: str) -> Path:
    """A file to write, in a folder that exists."""
    file = Path(text)
    if not file.parent.is_dir() or file.is_dir():
        raise argparse.ArgumentTypeError(
            f"'{text}' is no file that can be written, because its folder does not exist or it is a folder"
        )
    return file
