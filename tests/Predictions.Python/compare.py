"""Compares the figures in a report with those of the oracle and, where it is installed, of pycocotools."""

import json
import pathlib
import re
import sys

from oracle import Evaluation

TOLERANCE = 1e-5  # The report has six decimals.

truth, results = (json.loads(pathlib.Path(path).read_text()) for path in sys.argv[1:3])
page = pathlib.Path(sys.argv[3]).read_text()
report = json.loads(
    re.search(r'<script type="application/json" id="predictions">(.*?)</script>', page, re.DOTALL).group(1)
)


def difference(name, ours, theirs):
    if (ours is None) != (theirs is None):
        sys.exit(f"{sys.argv[3]}: {name} is {ours}, not {theirs}")
    worst = 0 if ours is None else abs(ours - theirs)
    if worst > TOLERANCE:
        sys.exit(f"{sys.argv[3]}: {name} is {ours}, not {theirs}")
    return worst


evaluation = Evaluation(truth, results)
worst = max(difference(name, report["figures"][name], value) for name, value in evaluation.summary().items())
for category, shown in zip(truth["categories"], report["classes"], strict=True):
    worst = max(worst, difference(category["name"], shown["ap"], evaluation.average_precision(category["id"])))

try:
    from pycocotools.coco import COCO
    from pycocotools.cocoeval import COCOeval
except ImportError:
    reference = "pycocotools is not installed"
else:
    ground = COCO(sys.argv[1])
    judge = COCOeval(ground, ground.loadRes(sys.argv[2]), "bbox")
    judge.evaluate()
    judge.accumulate()
    judge.summarize()
    figures = {name: None if value == -1 else value for name, value in zip(report["figures"], judge.stats, strict=True)}
    worst = max(
        [worst]
        + [difference(f"{name} of pycocotools", report["figures"][name], value) for name, value in figures.items()]
    )
    reference = "pycocotools too"
print(f"{pathlib.Path(sys.argv[3]).name}: AP {report['figures']['AP']}, largest difference {worst:.1e} ({reference})")
