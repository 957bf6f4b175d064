"""Makes predictions out of a ground truth: shifted, dropped, doubled and false ones, with scores that collide."""

import json
import pathlib
import random
import sys

seed, coco, kitti, name = int(sys.argv[1]), pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3]), sys.argv[4]
KITTI_TYPES = ["Car", "Van", "Truck", "Pedestrian", "Person_sitting", "Cyclist", "Tram", "Misc"]


def noisy(chance, boxes, classes, width, height):
    """Predictions for an image, from (class, left, top, width, height)."""
    for kind, left, top, wide, high in boxes:
        if chance.random() < 0.15:
            continue
        for _ in range(1 + (chance.random() < 0.2)):
            amount = chance.choice([0, 0, 0.03, 0.1, 0.25])
            shifted = [
                left + chance.gauss(0, amount * wide),
                top + chance.gauss(0, amount * high),
                wide * max(0.1, chance.gauss(1, amount)),
                high * max(0.1, chance.gauss(1, amount)),
            ]
            yield chance.choice([kind] * 9 + classes), [round(value, 2) for value in shifted], round(
                chance.betavariate(4, 2), 2
            )
    for _ in range(chance.randrange(4)):
        wide, high = chance.uniform(4, width / 3), chance.uniform(4, height / 3)
        box = [chance.uniform(0, width - wide), chance.uniform(0, height - high), wide, high]
        yield chance.choice(classes), [round(value, 2) for value in box], round(chance.betavariate(2, 4), 2)
    if chance.random() < 0.05:
        # More than COCO's limit of 100 of one class.
        for _ in range(120):
            yield classes[0], [chance.uniform(0, width), chance.uniform(0, height), 20, 15], round(
                chance.random() / 4, 2
            )


chance = random.Random(seed)
truth = json.loads((coco / "annotations/instances_train.json").read_text())
classes = [category["id"] for category in truth["categories"]]
results = []
for image in truth["images"]:
    boxes = [(item["category_id"], *item["bbox"]) for item in truth["annotations"] if item["image_id"] == image["id"]]
    for kind, box, score in noisy(chance, boxes, classes, image["width"], image["height"]):
        results.append({"image_id": image["id"], "category_id": kind, "bbox": box, "score": score})
chance.shuffle(results)
pathlib.Path(f"{name}-coco.json").write_text(json.dumps(results))

# The same for KITTI's files, and those files as COCO would have them.
folder = pathlib.Path(f"{name}-kitti")
folder.mkdir()
images, annotations, results = [], [], []
size = truth["images"][0]
for path in sorted((kitti / "training/label_2").iterdir()):
    number = int(path.stem)
    images.append({"id": number})
    boxes = []
    for line in path.read_text().splitlines():
        words = line.split(" ")
        left, top, right, bottom = map(float, words[4:8])
        box = [left, top, right - left, bottom - top]
        crowd = words[0] == "DontCare"
        for category in range(len(KITTI_TYPES)) if crowd else [KITTI_TYPES.index(words[0])]:
            annotations.append(
                {
                    "id": len(annotations) + 1,
                    "image_id": number,
                    "category_id": category,
                    "bbox": box,
                    "area": box[2] * box[3],
                    "iscrowd": int(crowd),
                }
            )
        if not crowd:
            boxes.append((KITTI_TYPES.index(words[0]), *box))
    lines = []
    for kind, (left, top, wide, high), score in noisy(
        chance, boxes, list(range(len(KITTI_TYPES))), size["width"], size["height"]
    ):
        sides = [round(left, 2), round(top, 2), round(left + wide, 2), round(top + high, 2)]
        lines.append(
            f"{KITTI_TYPES[kind]} -1 -1 -10 {' '.join(map(str, sides))} -1 -1 -1 -1000 -1000 -1000 -10 {score}\n"
        )
        results.append(
            {
                "image_id": number,
                "category_id": kind,
                "bbox": [sides[0], sides[1], sides[2] - sides[0], sides[3] - sides[1]],
                "score": score,
            }
        )
    (folder / path.name).write_text("".join(lines))
categories = [{"id": index, "name": kind} for index, kind in enumerate(KITTI_TYPES)]
pathlib.Path(f"{name}-kitti-truth.json").write_text(
    json.dumps({"images": images, "annotations": annotations, "categories": categories})
)
pathlib.Path(f"{name}-kitti-results.json").write_text(json.dumps(results))
