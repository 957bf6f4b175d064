"""Reads a COCO panoptic dataset with stuff and evaluates it by the definition of panoptic quality (Kirillov et al., 2019)."""

import json
import os

import numpy as np
from PIL import Image

VOID = 0
STUFF = {1: 103, 2: 104, 3: 105, 4: 106, 5: 107, 6: 108, 7: 109, 8: 110, 9: 101, 10: 111}


def pixels_of(*path):
    return np.array(Image.open(os.path.join(*path))).astype(np.int64)


def segments_of(folder, annotation):
    colours = pixels_of(folder, "annotations", "panoptic_train", annotation["file_name"])
    return colours[..., 0] + 256 * colours[..., 1] + 65536 * colours[..., 2]


def quality(pairs, categories):
    """The panoptic quality of each category that occurs, over pairs of truth and prediction: segment ids and their categories."""
    found = {category: [0.0, 0, 0, 0] for category in categories}
    for (truth, true_categories), (guess, guessed_categories) in pairs:
        values, counts = np.unique(np.stack([truth.ravel(), guess.ravel()]), axis=1, return_counts=True)
        shared = {(int(a), int(b)): int(count) for (a, b), count in zip(values.T, counts)}
        true_areas = {segment: int((truth == segment).sum()) for segment in true_categories}
        guessed_areas = {segment: int((guess == segment).sum()) for segment in guessed_categories}
        matched_truth, matched_guess = set(), set()
        for (a, b), both in shared.items():
            if a == VOID or b == VOID or true_categories[a] != guessed_categories[b]:
                continue
            union = true_areas[a] + guessed_areas[b] - both - shared.get((VOID, b), 0)
            if both / union > 0.5:
                found[true_categories[a]][0] += both / union
                found[true_categories[a]][1] += 1
                matched_truth.add(a)
                matched_guess.add(b)
        for segment, category in true_categories.items():
            found[category][3] += segment not in matched_truth
        for segment, category in guessed_categories.items():
            is_void = shared.get((VOID, segment), 0) > guessed_areas[segment] / 2
            found[category][2] += segment not in matched_guess and not is_void
    return {
        category: total / (hits + wrong / 2 + missed / 2)
        for category, (total, hits, wrong, missed) in found.items()
        if hits + wrong + missed > 0
    }


def read(session, folder):
    with open(os.path.join(folder, "annotations", "panoptic_train.json"), encoding="utf-8") as file:
        dataset = json.load(file)
    with open(os.path.join(session, "labels.jsonl"), encoding="utf-8") as lines:
        labels = [json.loads(line) for line in lines]
    is_thing = {category["id"]: category["isthing"] == 1 for category in dataset["categories"]}
    truth = []
    for annotation in dataset["annotations"]:
        ids = segments_of(folder, annotation)
        label = labels[annotation["image_id"]]
        classes = pixels_of(session, label["classMap"]["file"])
        mask = pixels_of(session, label["mask"])
        categories = {segment["id"]: segment["category_id"] for segment in annotation["segments_info"]}
        assert set(np.unique(ids)) - {VOID} == set(categories)
        for value, category in STUFF.items():
            shown = (classes == value) & (mask == 0)
            assert all(categories[int(segment)] == category for segment in np.unique(ids[shown])), value
        truth.append((ids, categories))

    perfect = quality(zip(truth, truth), is_thing)
    stuff = [category for category in perfect if not is_thing[category]]
    assert len(stuff) >= 5 and len(stuff) < len(perfect)
    assert all(value == 1 for value in perfect.values())

    # Without the largest stuff segment of the first image, that category is missed once.
    ids, categories = truth[0]
    largest = max(
        (segment for segment in categories if not is_thing[categories[segment]]),
        key=lambda segment: (ids == segment).sum(),
    )
    less = (
        np.where(ids == largest, VOID, ids),
        {segment: each for segment, each in categories.items() if segment != largest},
    )
    worse = quality(zip(truth, [less, *truth[1:]]), is_thing)
    images = sum(categories[largest] in each.values() for _, each in truth)
    assert abs(worse[categories[largest]] - (images - 1) / (images - 0.5)) < 1e-9
    things = [category for category in perfect if is_thing[category]]
    print(f"panoptic: quality 1 of {len(things)} things and {len(stuff)} stuff classes in {len(truth)} frames")
