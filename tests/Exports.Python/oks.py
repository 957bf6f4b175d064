"""COCO's keypoint evaluation, written from its published definition (cocodataset.org, Keypoint Evaluation) with Python's own libraries.

Object keypoint similarity of a detection and an annotation, over the keypoints whose flag is not 0, with the distances d in pixels, the
annotation's area s^2 and k = 2 sigma:

    OKS = mean of exp(-d^2 / (2 s^2 k^2))

Average precision is the mean over the similarities 0.50, 0.55 ... 0.95 and 101 recalls. An image counts its 20 best detections.
"""

import math

SIGMAS = (
    0.026,
    0.025,
    0.025,
    0.035,
    0.035,
    0.079,
    0.079,
    0.072,
    0.072,
    0.062,
    0.062,
    0.107,
    0.107,
    0.087,
    0.087,
    0.089,
    0.089,
)
THRESHOLDS = [0.5 + 0.05 * step for step in range(10)]
RECALLS = [step / 100 for step in range(101)]
MAX_DETECTIONS = 20
AREAS = {"all": (0, 1e10), "medium": (32**2, 96**2), "large": (96**2, 1e10)}


def similarity(detection, annotation):
    """OKS; for an annotation without keypoints, distances are those from its box, grown to twice its size."""
    wanted, found = annotation["keypoints"], detection["keypoints"]
    x, y, width, height = annotation["bbox"]
    labelled = any(wanted[2::3])
    total = count = 0
    for number, sigma in enumerate(SIGMAS):
        u, v, flag = wanted[3 * number : 3 * number + 3]
        p, q = found[3 * number : 3 * number + 2]
        if labelled:
            if flag == 0:
                continue
            dx, dy = p - u, q - v
        else:
            dx = max(0, x - width - p) + max(0, p - x - 2 * width)
            dy = max(0, y - height - q) + max(0, q - y - 2 * height)
        total += math.exp(-(dx * dx + dy * dy) / (2 * (2 * sigma) ** 2 * max(annotation["area"], 1e-12)))
        count += 1
    return total / count


def matches(detections, annotations, threshold, span):
    """Of one image: (score, whether matched, whether ignored) of each detection, and the number of annotations that count."""

    def is_ignored(annotation):
        return (
            annotation["num_keypoints"] == 0
            or annotation["iscrowd"] == 1
            or not span[0] <= annotation["area"] <= span[1]
        )

    ordered = sorted(annotations, key=is_ignored)
    taken = set()
    rows = []
    for detection in sorted(detections, key=lambda each: -each["score"])[:MAX_DETECTIONS]:
        best, chosen = min(threshold, 1 - 1e-10), None
        for number, annotation in enumerate(ordered):
            if number in taken and not annotation["iscrowd"]:
                continue
            if chosen is not None and not is_ignored(ordered[chosen]) and is_ignored(annotation):
                break
            found = similarity(detection, annotation)
            if found >= best:
                best, chosen = found, number
        if chosen is None:
            rows.append((detection["score"], False, not span[0] <= detection["area"] <= span[1]))
        else:
            taken.add(chosen)
            rows.append((detection["score"], True, is_ignored(ordered[chosen])))
    return rows, sum(not is_ignored(annotation) for annotation in annotations)


def average_precision(detections, annotations, area="all"):
    """Mean over all thresholds; None if no annotation counts."""
    images = {each["image_id"] for each in annotations} | {each["image_id"] for each in detections}
    by_image = {image: ([], []) for image in images}
    for each in detections:
        xs, ys = each["keypoints"][0::3], each["keypoints"][1::3]
        by_image[each["image_id"]][0].append({**each, "area": (max(xs) - min(xs)) * (max(ys) - min(ys))})
    for each in annotations:
        by_image[each["image_id"]][1].append(each)
    precisions = []
    for threshold in THRESHOLDS:
        rows, positives = [], 0
        for image in sorted(images):
            found, counted = matches(*by_image[image], threshold, AREAS[area])
            rows += found
            positives += counted
        if positives == 0:
            return None
        curve, true, false = [], 0, 0
        for _, is_matched, is_ignored in sorted(rows, key=lambda row: -row[0]):
            if not is_ignored:
                true, false = true + is_matched, false + (not is_matched)
                curve.append((true / positives, true / (true + false)))
        best = 0
        falling = []
        for recall, precision in reversed(curve):
            best = max(best, precision)
            falling.append((recall, best))
        falling.reverse()
        precisions.append(sum(next((p for r, p in falling if r >= wanted), 0) for wanted in RECALLS) / len(RECALLS))
    return sum(precisions) / len(precisions)
