"""Long sessions out of a short one: its frames again and again, with numbers and times that go on."""

import json
import os
import shutil


def repeat(source, target, frames):
    """Makes a session of some number of frames; its pictures, masks and scenes are hard links where nothing in them counts frames."""
    shutil.rmtree(target, ignore_errors=True)
    with open(os.path.join(source, "labels.jsonl"), encoding="utf-8") as file:
        labels = [json.loads(line) for line in file]
    with open(os.path.join(source, "session.json"), encoding="utf-8") as file:
        session = json.load(file)
    folders = [name for name in ("frames", "masks", "scenes") if os.path.isdir(os.path.join(source, name))]
    for name in folders:
        os.makedirs(os.path.join(target, name))
    span = 2 * labels[-1]["gameFrame"] - labels[-2]["gameFrame"] - labels[0]["gameFrame"]
    seconds = 2 * labels[-1]["timeSeconds"] - labels[-2]["timeSeconds"] - labels[0]["timeSeconds"]
    texts = [template(label) for label in labels]
    with open(os.path.join(target, "labels.jsonl"), "w", encoding="utf-8") as file:
        for frame in range(frames):
            turn, place = divmod(frame, len(labels))
            label = labels[place]
            file.write(texts[place] % (
                frame, label["gameFrame"] + turn * span, round(label["timeSeconds"] + turn * seconds, 6), frame, frame))
            for name in folders:
                extension = ".json" if name == "scenes" else os.path.splitext(label["image"])[1] if name == "frames" else ".png"
                link = os.path.join(source, name, f"{place:08d}{extension}"), os.path.join(target, name, f"{frame:08d}{extension}")
                os.link(*link)
    session["counters"]["captured"] = frames
    with open(os.path.join(target, "session.json"), "w", encoding="utf-8") as file:
        json.dump(session, file, indent=2)


def remove(*paths):
    for path in paths:
        if os.path.isdir(path):
            shutil.rmtree(path)
        elif os.path.exists(path):
            os.remove(path)


def template(label):
    """The line of a label with places for frame, game frame, time, image and mask."""
    extension = os.path.splitext(label["image"])[1]
    changed = dict(label, frame=-1, gameFrame=-2, timeSeconds=-3, image="IMAGE")
    changed["mask"] = "MASK" if label["mask"] else None
    text = json.dumps(changed, separators=(",", ":")).replace("%", "%%")
    text = text.replace('"frame":-1,"gameFrame":-2,"timeSeconds":-3,', '"frame":%d,"gameFrame":%d,"timeSeconds":%s,', 1)
    text = text.replace('"IMAGE"', f'"frames/%08d{extension}"', 1)
    return (text.replace('"MASK"', '"masks/%08d.png"', 1) if label["mask"] else text + "%.0s") + "\n"
