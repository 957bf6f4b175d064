"""Reads an export of EuRoC sequences with NumPy and PyYAML, and integrates the samples to the states."""

import csv
import json
import os

import numpy as np
import yaml

GRAVITY = np.array([0, 0, -9.80665])
# Samples have 9 and 7 decimals, states 4.
MAX_METRES = 0.02
MAX_SPEED = 1e-3
MAX_TURN = 1e-6


def table(*path):
    with open(os.path.join(*path), encoding="utf-8", newline="") as file:
        return [row for row in csv.reader(file) if not row[0].startswith("#")]


def matrix_of(quaternion):
    w, x, y, z = quaternion
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def exponential(vector):
    angle = np.linalg.norm(vector)
    if angle == 0:
        return np.eye(3)
    x, y, z = vector / angle
    cross = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def read(session, folder):
    """Compares a sequence with the labels, and integrates its samples from the first state."""
    with open(os.path.join(session, "labels.jsonl"), encoding="utf-8") as lines:
        labels = [json.loads(line) for line in lines]
    place = os.path.join(folder, "train", "0000", "mav0")
    states = np.array(table(place, "state_groundtruth_estimate0", "data.csv"), dtype=np.float64)
    samples = np.array(table(place, "imu0", "data.csv"), dtype=np.float64)
    images = table(place, "cam0", "data.csv")
    assert len(states) == len(images) == len(labels)
    with open(os.path.join(place, "cam0", "sensor.yaml"), encoding="utf-8") as file:
        camera = yaml.safe_load(file)
    with open(os.path.join(place, "imu0", "sensor.yaml"), encoding="utf-8") as file:
        unit = yaml.safe_load(file)
    assert abs(unit["rate_hz"] - 60) < 0.01
    to_body = np.array(camera["T_BS"]["data"]).reshape(4, 4)
    fx, fy, cx, cy = camera["intrinsics"]

    # A point of the world through state, extrinsics and intrinsics is at the pixel that the label's camera gives.
    label = labels[-1]
    seen = label["camera"]
    point = (
        np.array(seen["position"]) + 9 * np.array(seen["forward"]) + 2 * np.array(seen["right"]) + np.array(seen["up"])
    )
    body = matrix_of(states[-1, 4:8]).T @ (point - states[-1, 1:4])
    x, y, z = to_body[:3, :3].T @ (body - to_body[:3, 3])
    pixel = (fx * x / z + cx + 0.5, fy * y / z + cy + 0.5)
    assert np.allclose(pixel, (seen["cx"] + seen["fx"] * 2 / 9, seen["cy"] - seen["fy"] / 9), atol=0.05)

    rotation, velocity, position = matrix_of(states[0, 4:8]), states[0, 8:11], states[0, 1:4]
    time, worst = states[0, 0], np.zeros(3)
    later = {state[0]: state for state in states[1:]}
    for sample in samples[samples[:, 0] > time]:
        seconds, time = (sample[0] - time) / 1e9, sample[0]
        middle = rotation @ exponential(sample[1:4] * seconds / 2)
        rotation = rotation @ exponential(sample[1:4] * seconds)
        change = (middle @ sample[4:7] + GRAVITY) * seconds
        position = position + (velocity + change / 2) * seconds
        velocity = velocity + change
        if time in later:
            state = later.pop(time)
            differences = (rotation - matrix_of(state[4:8]), velocity - state[8:11], position - state[1:4])
            worst = np.maximum(worst, [np.abs(difference).max() for difference in differences])
    assert not later
    assert (worst <= [MAX_TURN, MAX_SPEED, MAX_METRES]).all(), worst
    return (
        f"euroc: {len(samples)} samples lead through {len(states)} states; "
        f"rotation {worst[0]:.1e}, velocity {worst[1]:.1e} m/s, position {worst[2]:.4f} m"
    )
