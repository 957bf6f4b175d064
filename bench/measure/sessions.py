"""Long sessions out of a short one: its frames again and again, with numbers and times that go on."""

import hashlib
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
    files = [
        FilesOfFrame(source, place, os.path.splitext(label["image"])[1], folders) for place, label in enumerate(labels)
    ]
    manifest = open(os.path.join(target, "manifest.jsonl"), "w", encoding="utf-8")
    with manifest, open(os.path.join(target, "labels.jsonl"), "w", encoding="utf-8") as file:
        for frame in range(frames):
            turn, place = divmod(frame, len(labels))
            label = labels[place]
            line = texts[place] % (
                frame,
                label["gameFrame"] + turn * span,
                round(label["timeSeconds"] + turn * seconds, 6),
                frame,
                frame,
            )
            file.write(line + "\n")
            entry = {"frame": frame, "label": digest(line.encode()), "files": files[place].link(target, frame)}
            manifest.write(checked(entry))
    session["counters"]["captured"] = frames
    with open(os.path.join(target, "session.json"), "w", encoding="utf-8") as file:
        json.dump(session, file, indent=2)
    kept = [name for name in ("scenes/roads.csv", "scenes/spaces.csv") if os.path.exists(os.path.join(source, name))]
    for name in kept:
        os.link(os.path.join(source, name), os.path.join(target, name))
    with open(os.path.join(target, "manifest.jsonl"), "a", encoding="utf-8") as manifest:
        for name in [*kept, "session.json"]:
            with open(os.path.join(target, name), "rb") as file:
                manifest.write(checked({"path": name, **digest(file.read())}))


class FilesOfFrame:
    """The picture, mask and scene of a frame, with their digests."""

    def __init__(self, source, place, image_extension, folders):
        self.files = []
        for folder in folders:
            extension = {"frames": image_extension, "masks": ".png", "scenes": ".json"}[folder]
            path = os.path.join(source, folder, f"{place:08d}{extension}")
            with open(path, "rb") as file:
                self.files.append((path, folder, extension, digest(file.read())))

    def link(self, target, frame):
        """Links the files under the number of a frame. Returns their entries in the manifest."""
        entries = []
        for path, folder, extension, content in self.files:
            name = f"{folder}/{frame:08d}{extension}"
            os.link(path, os.path.join(target, name))
            entries.append({"path": name, **content})
        return entries


def digest(content):
    return {"bytes": len(content), "sha256": hashlib.sha256(content).hexdigest()}


def checked(entry):
    """A line of the manifest, with the checksum of itself."""
    text = json.dumps(entry, separators=(",", ":"))[:-1]
    return f'{text},"check":"{hashlib.sha256(text.encode()).hexdigest()[:16]}"}}\n'


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
    for mark, place in [
        ('"frame":-1,', '"frame":%d,'),
        ('"gameFrame":-2,', '"gameFrame":%d,'),
        ('"timeSeconds":-3,', '"timeSeconds":%s,'),
    ]:
        text = text.replace(mark, place, 1)
    text = text.replace('"IMAGE"', f'"frames/%08d{extension}"', 1)
    return text.replace('"MASK"', '"masks/%08d.png"', 1) if label["mask"] else text + "%.0s"
