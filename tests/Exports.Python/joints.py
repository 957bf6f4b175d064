"""Evaluates coco-keypoints against itself by COCO's definition and reads JTA's rows, both beside the labels of the session.

Called by run-joints with the folder that holds session, coco-keypoints and jta.
"""

import json
import math
import os
import sys

from oks import average_precision

JOINTS = 22

# Positions and pixels have four and three decimals: 0.5e-4 m at 2 m with a focal length of 650 px is 0.02 px.
PROJECTED_PIXELS = 0.05


def json_of(*path):
    with open(os.path.join(*path), encoding="utf-8") as file:
        return json.load(file)


def labels_of(folder):
    with open(os.path.join(folder, "session", "labels.jsonl"), encoding="utf-8") as lines:
        return [json.loads(line) for line in lines]


def check_evaluator():
    """One nose, area 10000, k = 0.052: a detection 5.2 px away has exp(-0.5) = 0.607, above 3 of 10 thresholds."""
    truth = {
        "image_id": 1,
        "keypoints": [100, 100, 2] + [0, 0, 0] * 16,
        "num_keypoints": 1,
        "area": 10000,
        "iscrowd": 0,
        "bbox": [0, 0, 100, 100],
    }
    near = {"image_id": 1, "keypoints": [105.2, 100, 2] + [0, 0, 0] * 16, "score": 1}
    assert abs(average_precision([near], [truth]) - 0.3) < 1e-9

    # A wrong detection with a better score halves the precision.
    wrong = {**near, "keypoints": [500, 500, 2] + [0, 0, 0] * 16, "score": 2}
    exact = {**near, "keypoints": truth["keypoints"]}
    assert abs(average_precision([wrong, exact], [truth]) - 0.5) < 1e-9
    assert average_precision([], [truth]) == 0


def check_coco(folder):
    coco = json_of(folder, "coco-keypoints", "annotations", "person_keypoints_train.json")
    annotations = coco["annotations"]
    people = [each for each in annotations if each["num_keypoints"] > 0]
    assert len(people) > 20, f"only {len(people)} people"
    detections = [{"image_id": each["image_id"], "keypoints": each["keypoints"], "score": 1} for each in people]
    for area in ("all", "medium", "large"):
        found = average_precision(detections, annotations, area)
        print(f"coco-keypoints, {len(people)} people, AP of the truth against itself, {area}: {found}")
        assert found is None or found == 1

    # The evaluation sees an error: one person in four is left out, and left and right are exchanged.
    fewer = [each for number, each in enumerate(detections) if number % 4]
    assert 0.7 < average_precision(fewer, annotations) < 0.8
    swapped = []
    for each in detections:
        points = [each["keypoints"][3 * n : 3 * n + 3] for n in range(17)]
        order = [0] + [n + 1 if n % 2 else n - 1 for n in range(1, 17)]
        swapped.append({**each, "keypoints": [value for n in order for value in points[n]]})
    assert average_precision(swapped, annotations) < 0.9

    # Each joint of the body is where the session has it.
    by_id = {}
    for label in labels_of(folder):
        for item in label["objects"]:
            if "joints" in item:
                by_id[(label["frame"], item["id"])] = {joint["joint"]: joint for joint in item["joints"]}
    names = coco["categories"][0]["keypoints"]
    frames = {
        image["id"]: int(os.path.splitext(os.path.basename(image["file_name"]))[0].split("_")[-1])
        for image in coco["images"]
    }
    compared = 0
    for each in people:
        joints = by_id[(frames[each["image_id"]], each["track_id"])]
        for number, name in enumerate(names):
            side, _, part = name.partition("_")
            joint = joints.get(f"{side}_{part}")
            if joint and joint["visibility"] != "outside":
                x, y, flag = each["keypoints"][3 * number : 3 * number + 3]
                assert math.dist((x, y), joint["pixel"]) < 0.01, (each["id"], name)
                assert flag == (2 if joint["visibility"] == "visible" else 1), (each["id"], name)
                compared += 1
    assert compared > 200, compared


def check_jta(folder):
    labels = labels_of(folder)
    rows = []
    for place in sorted({label["place"] for label in labels}):
        mine = [label for label in labels if label["place"] == place]
        for number, label in enumerate(mine, 1):
            assert os.path.exists(os.path.join(folder, "jta", "frames", "train", f"seq_{place}", f"{number}.png"))
        rows += [
            [mine[frame - 1]["frame"], *row]
            for frame, *row in json_of(folder, "jta", "annotations", "train", f"seq_{place}.json")
        ]
    camera = json_of(folder, "jta", "cameras", "train", "seq_0.json")
    expected = {
        (label["frame"], item["id"], number): joint
        for label in labels
        for item in label["objects"]
        for number, joint in enumerate(item.get("joints", []))
        if joint["pixel"] is not None
    }
    assert len(rows) == len(expected) > 20 * JOINTS
    for frame, person, number, x2, y2, x3, y3, z3, occluded, own in rows:
        joint = expected.pop((frame, person, number))
        projected = camera["fx"] * x3 / z3 + camera["cx"], camera["fy"] * y3 / z3 + camera["cy"]
        assert z3 > 0 and math.dist(projected, (x2, y2)) < PROJECTED_PIXELS * max(1, 2 / z3), (frame, person, number)
        assert math.dist((x2, y2), joint["pixel"]) < 0.01
        assert occluded == (joint["visibility"] in ("occluded", "unknown")) and own == (
            joint["visibility"] == "selfOccluded"
        )
    print(f"jta: {len(rows)} rows agree with the session")


check_evaluator()
check_coco(sys.argv[1])
check_jta(sys.argv[1])
