"""Reads MOTChallenge as TrackEval does, and evaluates trackers by CLEAR MOT and identity."""

import configparser
import csv
import os

from assignment import greatest

CLASSES = range(1, 14)
PEDESTRIAN = 1
# Person on vehicle, static person, distractor, reflection: what a tracker finds there is not counted.
IGNORED = (2, 7, 8, 12)
MATCH = 0.5


def overlap(a, b):
    width = min(a[0] + a[2], b[0] + b[2]) - max(a[0], b[0])
    height = min(a[1] + a[3], b[1] + b[3]) - max(a[1], b[1])
    shared = max(width, 0) * max(height, 0)
    return shared / (a[2] * a[3] + b[2] * b[3] - shared)


def sequences_of(root, split):
    """Names and lengths of the sequences of a split."""
    with open(os.path.join(root, "seqmaps", f"MOT17-{split}.txt"), encoding="utf-8") as file:
        names = [row[0] for number, row in enumerate(csv.reader(file)) if number > 0]
    for name in names:
        info = configparser.ConfigParser()
        info.read(os.path.join(root, f"MOT17-{split}", name, "seqinfo.ini"))
        yield name, info["Sequence"]


def rows_of(path, length):
    """For each frame, a list of (id, box, flag, class, visibility); ids are unique in a frame."""
    frames = [[] for _ in range(length)]
    with open(path, encoding="utf-8", newline="") as file:
        for row in csv.reader(file):
            frame, number, *box, flag, kind, visible = map(float, row)
            frames[int(frame) - 1].append((int(number), box, int(flag), int(kind), visible))
    for rows in frames:
        assert len({row[0] for row in rows}) == len(rows)
        assert all(row[3] in CLASSES for row in rows)
    return frames


def prepared(truth, found):
    """The pedestrians to find, and what was found without what lies on ignored classes."""
    kept_truth, kept_found = [], []
    for rows, boxes in zip(truth, found):
        scores = [[overlap(row[1], box) for _, box in boxes] for row in rows]
        scores = [[score if score >= MATCH else 0 for score in line] for line in scores]
        pairs = greatest(scores) if rows and boxes else []
        lost = {column for row, column in pairs if scores[row][column] > 0 and rows[row][3] in IGNORED}
        kept_found.append([box for column, box in enumerate(boxes) if column not in lost])
        kept_truth.append([(row[0], row[1]) for row in rows if row[2] and row[3] == PEDESTRIAN])
    return kept_truth, kept_found


def evaluate(truth, found):
    """MOTA and IDF1 of what a tracker found: for each frame, a list of (id, box)."""
    truth, found = prepared(truth, found)
    misses = false = switches = total = 0
    last, before, together = {}, {}, {}
    for rows, boxes in zip(truth, found):
        scores = [[overlap(row, box) for _, box in boxes] for _, row in rows]
        for (number, _), line in zip(rows, scores):
            for (other, _), score in zip(boxes, line):
                if score >= MATCH:
                    together[number, other] = together.get((number, other), 0) + 1
        # A pair that goes on is kept, whatever else overlaps more.
        weights = [
            [
                (1000 * (before.get(number) == other) + score) if score >= MATCH else 0
                for (other, _), score in zip(boxes, line)
            ]
            for (number, _), line in zip(rows, scores)
        ]
        pairs = (
            [(row, column) for row, column in greatest(weights) if weights[row][column] > 0] if rows and boxes else []
        )
        matched = {rows[row][0]: boxes[column][0] for row, column in pairs}
        switches += sum(number in last and last[number] != other for number, other in matched.items())
        misses += len(rows) - len(matched)
        false += len(boxes) - len(matched)
        total += len(rows)
        before = matched
        last.update(matched)
    ids = sorted({number for rows in truth for number, _ in rows})
    others = sorted({number for boxes in found for number, _ in boxes})
    counts = [[together.get((number, other), 0) for other in others] for number in ids]
    same = sum(counts[row][column] for row, column in greatest(counts)) if ids and others else 0
    count = sum(map(len, found))
    return 1 - (misses + false + switches) / total, 2 * same / (total + count)


def read(root, labels):
    ((name, info),) = sequences_of(root, "train")
    assert int(info["seqLength"]) == len(labels)
    folder = os.path.join(root, "MOT17-train", name)
    truth = rows_of(os.path.join(folder, "gt", "gt.txt"), len(labels))
    for number, (label, rows) in enumerate(zip(labels, truth), 1):
        assert os.path.isfile(os.path.join(folder, info["imDir"], f"{number:06d}{info['imExt']}"))
        assert (int(info["imWidth"]), int(info["imHeight"])) == (label["camera"]["width"], label["camera"]["height"])
        seen = {item["id"]: item for item in label["objects"] if item["class"] == "pedestrian" and item["box2dVisible"]}
        people = {row[0]: row[1] for row in rows if row[3] == PEDESTRIAN}
        assert people.keys() == seen.keys()
        for id_of, (left, top, width, height) in people.items():
            # The first pixel is 1.
            assert [left - 1, top - 1, left - 1 + width, top - 1 + height] == seen[id_of]["box2dVisible"]
    seconds = labels[-1]["timeSeconds"] - labels[0]["timeSeconds"]
    assert abs(int(info["frameRate"]) - (len(labels) - 1) / seconds) <= 0.5

    # A perfect tracker also follows what is to be ignored.
    perfect = [[(row[0], row[1]) for row in rows if row[3] in (PEDESTRIAN, *IGNORED)] for rows in truth]
    assert sum(map(len, perfect)) > 0
    assert evaluate(truth, perfect) == (1.0, 1.0)
    half = len(perfect) // 2
    renamed = [
        [(number + 100_000 * (frame >= half), box) for number, box in boxes] for frame, boxes in enumerate(perfect)
    ]
    accuracy, identity = evaluate(truth, renamed)
    assert accuracy < 1 and identity < 1
    accuracy, _ = evaluate(truth, [[] for _ in perfect])
    assert accuracy == 0
