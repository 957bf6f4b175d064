"""The detection evaluation of nuScenes by its published definition, and the truth of an export evaluated against itself.

Boxes match by the distance of their centres on the ground, at most 0.5, 1, 2 and 4 m. The average precision is the mean over recalls above
0.1 of what the precision exceeds 0.1 by, normalised. True boxes without points, and boxes beyond the range of their class, do not count.
"""

import json
import os

import numpy as np

import nuscenes

THRESHOLDS_METRES = (0.5, 1, 2, 4)
MIN_RECALL = MIN_PRECISION = 0.1
MAX_BOXES = 500
# Exports have four decimals of a metre and nine of a quaternion.
ROUNDING = 1e-6
DETECTIONS = {
    "vehicle.car": ("car", 50),
    "vehicle.truck": ("truck", 50),
    "vehicle.bus.bendy": ("bus", 50),
    "vehicle.bus.rigid": ("bus", 50),
    "vehicle.trailer": ("trailer", 50),
    "vehicle.construction": ("construction_vehicle", 50),
    "human.pedestrian.adult": ("pedestrian", 40),
    "human.pedestrian.child": ("pedestrian", 40),
    "human.pedestrian.construction_worker": ("pedestrian", 40),
    "human.pedestrian.police_officer": ("pedestrian", 40),
    "vehicle.motorcycle": ("motorcycle", 40),
    "vehicle.bicycle": ("bicycle", 40),
    "movable_object.trafficcone": ("traffic_cone", 30),
    "movable_object.barrier": ("barrier", 30),
}
RANGES = dict(DETECTIONS.values())


class Database:
    """The tables of an export, read as the devkit does: the keyframe of each channel, boxes with their class, velocities."""

    def __init__(self, root, split=None):
        self.tables = nuscenes.load(root)
        with open(os.path.join(root, nuscenes.VERSION, "splits.json"), encoding="utf-8") as file:
            splits = json.load(file)
        scenes = {name for names in splits.values() for name in names} if split is None else set(splits[split])
        self.samples = [
            token
            for token, sample in self.tables["sample"].items()
            if self.tables["scene"][sample["scene_token"]]["name"] in scenes
        ]
        self.ego = {}
        for data in self.tables["sample_data"].values():
            sensor = self.tables["calibrated_sensor"][data["calibrated_sensor_token"]]["sensor_token"]
            if data["is_key_frame"] and self.tables["sensor"][sensor]["channel"] == "LIDAR_TOP":
                self.ego[data["sample_token"]] = np.array(
                    self.tables["ego_pose"][data["ego_pose_token"]]["translation"]
                )
        assert set(self.samples) <= set(self.ego), "each sample needs a keyframe of LIDAR_TOP"
        self.annotations = {token: [] for token in self.samples}
        for annotation in self.tables["sample_annotation"].values():
            if annotation["sample_token"] in self.annotations:
                self.annotations[annotation["sample_token"]].append(annotation)

    def class_of(self, annotation):
        category = self.tables["instance"][annotation["instance_token"]]["category_token"]
        return DETECTIONS.get(self.tables["category"][category]["name"], (None, 0))[0]

    def is_in_range(self, sample, name, translation):
        return np.linalg.norm(np.array(translation)[:2] - self.ego[sample][:2]) < RANGES[name]

    def truth(self):
        """The true boxes that count, by sample."""
        return {
            sample: [
                dict(annotation, detection_name=self.class_of(annotation))
                for annotation in annotations
                if self.class_of(annotation)
                and annotation["num_lidar_pts"] + annotation["num_radar_pts"] > 0
                and self.is_in_range(sample, self.class_of(annotation), annotation["translation"])
            ]
            for sample, annotations in self.annotations.items()
        }

    def velocity(self, annotation):
        """Of the centre, from the annotations before and after; NaN without any within 1.5 s on a side."""
        table = self.tables["sample_annotation"]
        first, last = (table[annotation[side]] if annotation[side] else annotation for side in ("prev", "next"))
        seconds = 1e-6 * (
            self.tables["sample"][last["sample_token"]]["timestamp"]
            - self.tables["sample"][first["sample_token"]]["timestamp"]
        )
        limit = 3 if annotation["prev"] and annotation["next"] else 1.5
        if first is last or seconds > limit:
            return [np.nan, np.nan]
        return list((np.array(last["translation"]) - np.array(first["translation"]))[:2] / seconds)


def submission(database):
    """The truth as a result: the annotated boxes that have points, each as sure as any other."""
    results = {}
    for sample, annotations in database.annotations.items():
        results[sample] = []
        for annotation in annotations:
            name = database.class_of(annotation)
            if name and annotation["num_lidar_pts"] > 0:
                attributes = [database.tables["attribute"][token]["name"] for token in annotation["attribute_tokens"]]
                results[sample].append(
                    {
                        "sample_token": sample,
                        "translation": annotation["translation"],
                        "size": annotation["size"],
                        "rotation": annotation["rotation"],
                        "velocity": database.velocity(annotation),
                        "detection_name": name,
                        "detection_score": 1.0,
                        "attribute_name": attributes[0] if attributes else "",
                    }
                )
    return {
        "meta": {"use_camera": True, "use_lidar": True, "use_radar": False, "use_map": False, "use_external": False},
        "results": results,
    }


def average_precision(truth, results, name, threshold):
    """The average precision of a class, and the matched pairs."""
    positives = sum(box["detection_name"] == name for boxes in truth.values() for box in boxes)
    predictions = [box for boxes in results.values() for box in boxes if box["detection_name"] == name]
    predictions.sort(key=lambda box: -box["detection_score"])
    taken, hits, pairs = set(), [], []
    for box in predictions:
        nearest, candidate = np.inf, None
        for index, other in enumerate(truth[box["sample_token"]]):
            if other["detection_name"] == name and (box["sample_token"], index) not in taken:
                distance = np.linalg.norm(np.array(box["translation"])[:2] - np.array(other["translation"])[:2])
                if distance < nearest:
                    nearest, candidate = distance, index
        hits.append(nearest < threshold)
        if hits[-1]:
            taken.add((box["sample_token"], candidate))
            pairs.append((box, truth[box["sample_token"]][candidate]))
    if not any(hits):
        return 0.0, pairs
    right = np.cumsum(hits)
    precision, recall = right / np.arange(1, len(hits) + 1), right / positives
    curve = np.interp(np.linspace(0, 1, 101), recall, precision, right=0)
    above = curve[round(100 * MIN_RECALL) + 1 :] - MIN_PRECISION
    return float(np.mean(np.maximum(above, 0)) / (1 - MIN_PRECISION)), pairs


def evaluate(database, result):
    """The average precision of each class that is present, by threshold."""
    assert set(result["results"]) == set(database.samples), "a result has each sample"
    assert all(len(boxes) <= MAX_BOXES for boxes in result["results"].values())
    results = {
        sample: [box for box in boxes if database.is_in_range(sample, box["detection_name"], box["translation"])]
        for sample, boxes in result["results"].items()
    }
    truth = database.truth()
    names = sorted({box["detection_name"] for boxes in truth.values() for box in boxes})
    return {
        name: [average_precision(truth, results, name, threshold) for threshold in THRESHOLDS_METRES] for name in names
    }


def check_errors(pairs):
    """Matched boxes are the same: in place, size and direction."""
    for box, other in pairs:
        assert np.allclose(box["translation"], other["translation"], atol=ROUNDING)
        assert np.allclose(box["size"], other["size"], atol=ROUNDING) and min(box["size"]) > 0
        assert abs(abs(np.dot(box["rotation"], other["rotation"])) - 1) < ROUNDING
    assert len({id(other) for _, other in pairs}) == len(pairs)


def check_that_errors_count(database, result):
    """Boxes that are moved by 0.75 m match at 1 m and not at 0.5 m; without the half of the boxes, the precision ends at half the recall."""
    moved = {
        sample: [dict(box, translation=[box["translation"][0] + 0.75, *box["translation"][1:]]) for box in boxes]
        for sample, boxes in result["results"].items()
    }
    sparse = json.loads(json.dumps(result))
    kept = 0
    for boxes in sparse["results"].values():
        for box in list(boxes):
            kept += 1
            if kept % 2:
                boxes.remove(box)
    name, _ = max(
        ((name, sum(len(pairs) for _, pairs in found)) for name, found in evaluate(database, result).items()),
        key=lambda item: item[1],
    )
    by_threshold = [precision for precision, _ in evaluate(database, dict(result, results=moved))[name]]
    assert by_threshold[0] < 0.9 < by_threshold[3], by_threshold
    assert 0.2 < evaluate(database, sparse)[name][3][0] < 0.7


def read(root):
    database = Database(root)
    result = submission(database)
    found = evaluate(database, result)
    assert found, "no box counts"
    for name, by_threshold in found.items():
        for (precision, pairs), threshold in zip(by_threshold, THRESHOLDS_METRES):
            assert abs(precision - 1) < ROUNDING, f"{name} at {threshold} m: {precision}"
            check_errors(pairs)
    check_that_errors_count(database, result)
    boxes = {name: len(by_threshold[0][1]) for name, by_threshold in found.items()}
    return f"nuscenes detection: AP 1.0 at 0.5, 1, 2 and 4 m for {', '.join(f'{name} ({count})' for name, count in boxes.items())}"


if __name__ == "__main__":
    import sys

    print(read(sys.argv[1]))
