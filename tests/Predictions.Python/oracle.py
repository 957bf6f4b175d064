"""COCO's evaluation of boxes, written from its published definition: https://cocodataset.org/#detection-eval."""

from collections import defaultdict

RANGES = {"all": (0, 1e10), "small": (0, 32**2), "medium": (32**2, 96**2), "large": (96**2, 1e10)}
OVERLAPS = [0.5 + step * ((0.95 - 0.5) / 9) for step in range(9)] + [0.95]
RECALLS = [step * 0.01 for step in range(100)] + [1.0]


def overlap(box, truth, is_crowd):
    (x, y, w, h), (a, b, c, d) = box, truth
    across, down = min(x + w, a + c) - max(x, a), min(y + h, b + d) - max(y, b)
    if across <= 0 or down <= 0:
        return 0.0
    shared = across * down
    return shared / (w * h if is_crowd else w * h + c * d - shared)


class Evaluation:
    def __init__(self, truth, results):
        self.categories = [category["id"] for category in truth["categories"]]
        self.images = sorted(image["id"] for image in truth["images"])
        self.truth, self.results = defaultdict(list), defaultdict(list)
        for item in truth["annotations"]:
            self.truth[item["category_id"], item["image_id"]].append(item)
        for item in results:
            self.results[item["category_id"], item["image_id"]].append(item)
        for key in self.results:
            self.results[key] = sorted(self.results[key], key=lambda item: -item["score"])[:100]

    def outcomes(self, category, sizes, threshold, most):
        """Number of boxes to find, and of each prediction that counts, by falling score, whether it finds one."""
        count, found = 0, []
        for image in self.images:
            boxes = self.truth[category, image]
            is_ignored = {id(box): bool(box["iscrowd"]) or not sizes[0] <= box["area"] <= sizes[1] for box in boxes}
            wanted = [box for box in boxes if not is_ignored[id(box)]]
            others = [box for box in boxes if is_ignored[id(box)]]
            count += len(wanted)
            taken = set()
            for item in self.results[category, image][:most]:
                match = self.best(item, [box for box in wanted if id(box) not in taken], threshold)
                if match is None:
                    match = self.best(
                        item, [box for box in others if box["iscrowd"] or id(box) not in taken], threshold
                    )
                if match is not None:
                    taken.add(id(match))
                    if not is_ignored[id(match)]:
                        found.append((item["score"], True))
                elif sizes[0] <= item["bbox"][2] * item["bbox"][3] <= sizes[1]:
                    found.append((item["score"], False))
        return count, [hit for _, hit in sorted(found, key=lambda pair: -pair[0])]

    @staticmethod
    def best(item, boxes, threshold):
        best, reached = None, min(threshold, 1 - 1e-10)
        for box in boxes:
            value = overlap(item["bbox"], box["bbox"], box["iscrowd"])
            if value >= reached:  # Of equal ones, the last.
                best, reached = box, value
        return best

    def precisions(self, category, sizes, threshold):
        count, hits = self.outcomes(category, sizes, threshold, 100)
        if count == 0:
            return None
        points, seen = [], 0
        for place, hit in enumerate(hits, 1):
            seen += hit
            points.append((seen / count, seen / place))
        return [max((precision for recall, precision in points if recall >= wanted), default=0.0) for wanted in RECALLS]

    def average_precision(self, category, sizes="all", thresholds=OVERLAPS):
        curves = [self.precisions(category, RANGES[sizes], threshold) for threshold in thresholds]
        return None if curves[0] is None else sum(sum(curve) / len(curve) for curve in curves) / len(curves)

    def average_recall(self, category, sizes="all", most=100):
        recalls = []
        for threshold in OVERLAPS:
            count, hits = self.outcomes(category, RANGES[sizes], threshold, most)
            if count == 0:
                return None
            recalls.append(sum(hits) / count)
        return sum(recalls) / len(recalls)

    def mean(self, figure):
        values = [value for value in map(figure, self.categories) if value is not None]
        return sum(values) / len(values) if values else None

    def summary(self):
        """The twelve figures of COCO's summary."""
        precision, recall = self.average_precision, self.average_recall
        return {
            "AP": self.mean(precision),
            "AP50": self.mean(lambda kind: precision(kind, thresholds=[OVERLAPS[0]])),
            "AP75": self.mean(lambda kind: precision(kind, thresholds=[OVERLAPS[5]])),
            **{f"AP{sizes}": self.mean(lambda kind: precision(kind, sizes)) for sizes in ("small", "medium", "large")},
            **{f"AR{most}": self.mean(lambda kind: recall(kind, most=most)) for most in (1, 10, 100)},
            **{f"AR{sizes}": self.mean(lambda kind: recall(kind, sizes)) for sizes in ("small", "medium", "large")},
        }
