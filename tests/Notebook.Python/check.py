"""Runs a notebook in the current folder and compares its outputs with those that are stored: check.py [--command] NOTEBOOK [--write]."""

import base64
import os
import pathlib
import re
import sys

import nbformat
import numpy
from gtaharvest import png
from nbconvert.preprocessors import ExecutePreprocessor

MOST_BYTES = 300_000
LETTER_LEVELS = (
    1.0  # Mean difference of 255 levels: letters are drawn by OpenCV, whose versions smooth them differently.
)
TIMEOUT_SECONDS = 600


def command(notebook):
    """The command that makes the session, from the first code block of the notebook's texts."""
    texts = "\n".join(cell.source for cell in notebook.cells if cell.cell_type == "markdown")
    return re.search(r"^harvester harvest .*$", texts, re.MULTILINE).group(0)


def outputs(notebook):
    """What each code cell prints or draws."""
    return [cell.outputs for cell in notebook.cells if cell.cell_type == "code"]


def is_same(old, new):
    """Whether two lists of outputs have the same texts and pictures."""
    texts = [
        [
            (output.output_type, output.get("name"), output.get("text"), output.get("data", {}).get("text/plain"))
            for output in cell
        ]
        for cell in (old, new)
    ]
    pictures = [
        [
            png.decode(base64.b64decode(output.data["image/png"])).astype(int)
            for output in cell
            if "image/png" in output.get("data", {})
        ]
        for cell in (old, new)
    ]
    return (
        texts[0] == texts[1]
        and len(pictures[0]) == len(pictures[1])
        and all(
            one.shape == other.shape and numpy.abs(one - other).mean() <= LETTER_LEVELS for one, other in zip(*pictures)
        )
    )


def tidy(notebook):
    """Drops what says where and when the notebook was run."""
    for cell in notebook.cells:
        cell.metadata = {}
    notebook.metadata = {
        "kernelspec": {"display_name": "Python 3", "language": "python", "name": "python3"},
        "language_info": {"name": "python"},
    }


def main(arguments):
    if arguments[0] == "--command":
        print(command(nbformat.read(arguments[1], as_version=4)))
        return
    path = pathlib.Path(arguments[0])
    stored = nbformat.read(path, as_version=4)
    made = nbformat.read(path, as_version=4)
    ExecutePreprocessor(timeout=TIMEOUT_SECONDS, kernel_name="python3").preprocess(
        made, {"metadata": {"path": os.getcwd()}}
    )
    tidy(made)
    text = nbformat.writes(made) + "\n"
    problems = []
    if len(text.encode()) > MOST_BYTES:
        problems.append(f"it has {len(text.encode())} bytes, more than {MOST_BYTES}")
    if os.getcwd() in text or str(path.parents[2]) in text:
        problems.append("it has a path of this machine")
    if "--write" in arguments:
        path.write_text(text, encoding="utf-8")
    elif cells := [
        number for number, (old, new) in enumerate(zip(outputs(stored), outputs(made))) if not is_same(old, new)
    ]:
        problems.append(
            f"the outputs of the code cells {cells} differ from what is stored; tests/Notebook.Python/run --write stores them"
        )
    if problems:
        sys.exit(f"{path.name}: {'; '.join(problems)}.")
    print(f"{path.name}: {sum(len(cell) for cell in outputs(made))} outputs as stored, {len(text.encode())} bytes.")


main(sys.argv[1:])
