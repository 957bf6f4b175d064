"""The channels of a recorded drive in an MCAP file, against the label lines of its session."""

import json
import os

import numpy as np

import mcap

TOPICS = ("/drive/action", "/drive/indicators", "/drive/tick", "/imu")

# The ego's pose in a message is a quaternion of the label's axes, which have nine decimals.
ROUNDING = 1e-6


def controls_of(message, field):
    return (
        {name: getattr(getattr(message, field), name) for name in ("steering", "throttle", "brake")}
        if message.HasField(field)
        else None
    )


def turned(quaternion, vector):
    """A vector turned by a quaternion."""
    w, x, y, z = (getattr(quaternion, name) for name in "wxyz")
    matrix = np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )
    return matrix @ vector


def check_action(message, drive):
    assert message.driver == drive["driver"] and message.disturbed == drive["disturbed"]
    assert (message.route or None) == drive["route"]
    assert controls_of(message, "controls") == drive["controls"] and controls_of(message, "applied") == drive["applied"]
    for field, name in (("answer_seconds", "answerSeconds"), ("route_metres", "routeMetres")):
        assert (getattr(message, field) if message.HasField(field) else None) == drive[name]
    assert message.speed == drive["speed"]
    target = drive["target"] or {"speed": None, "rightMetres": None}
    assert (message.target_speed if message.HasField("target_speed") else None) == target["speed"]
    assert (-message.target_left if message.HasField("target_left") else None) == target["rightMetres"]


def check_imu(message, tick, ego, pose):
    """In the world, the vectors are those of the label along the axes of the label; ego and pose are those at the tick."""
    assert message.frame_id == "ego"
    for vector, name in ((message.linear_acceleration, "acceleration"), (message.angular_velocity, "angularRate")):
        labelled = sum(np.array(ego[axis]) * part for axis, part in zip(("right", "forward", "up"), tick[name]))
        assert np.allclose(turned(pose.rotation, np.array([vector.x, vector.y, vector.z])), labelled, atol=ROUNDING)


def read(session, path, plain):
    """Checks a recorded drive and its MCAP file, and that the file of a harvest has no such channels."""
    with open(os.path.join(session, "labels.jsonl"), encoding="utf-8") as lines:
        labels = [json.loads(line) for line in lines]
    messages = mcap.read(path)
    assert not set(TOPICS) & set(mcap.read(plain)) and set(TOPICS) < set(messages)
    drives = [label["drive"] for label in labels]
    ticks = [tick for drive in drives for tick in drive["ticks"]]
    answered = [label for label in labels if label["drive"]["indicators"] is not None]
    assert len(ticks) > len(labels) and answered and any(drive["disturbed"] for drive in drives)

    for topic, rows in (("/drive/action", labels), ("/drive/indicators", answered), ("/drive/tick", ticks)):
        assert [time for time, _ in messages[topic]] == [round(row["timeSeconds"] * 1e9) for row in rows]
    for label, (time, message) in zip(labels, messages["/drive/action"]):
        assert message.timestamp.ToNanoseconds() == time
        check_action(message, label["drive"])
    for label, (_, message) in zip(answered, messages["/drive/indicators"]):
        named = [
            getattr(message, field.name)
            for field in message.DESCRIPTOR.fields
            if field.name not in ("timestamp", "speed")
        ]
        assert named == label["drive"]["indicators"]
    for tick, (_, message) in zip(ticks, messages["/drive/tick"]):
        assert (message.driver, message.speed) == (tick["driver"], tick["speed"]) and controls_of(
            message, "applied"
        ) == tick["applied"]

    known = [tick for tick in ticks if tick["acceleration"] and tick["angularRate"]]
    assert [time for time, _ in messages["/imu"]] == [round(tick["timeSeconds"] * 1e9) for tick in known]
    imu = dict(messages["/imu"])
    poses = {
        time: next(item for item in message.transforms if item.child_frame_id == "ego")
        for time, message in messages["/tf"]
    }
    for drive, label in zip(drives, labels[1:]):
        time = round(label["timeSeconds"] * 1e9)
        check_imu(imu[time], drive["ticks"][-1], label["ego"], poses[time])
    return f"mcap_drive: {len(labels)} actions and {len(known)} inertial measurements as in the session"
