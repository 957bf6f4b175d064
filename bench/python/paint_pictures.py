"""Draws the pictures of docs/paint.md: paint_pictures.py SESSION TABLE FRAME FOLDER. It needs nothing but Python.

SESSION: a session of 800x600 pixels with PNG images. TABLE: measured in it by harvester roads paint. FRAME: the number of a frame on a
road that is about straight. The stripes are found here once more, in the simplest form, so that each step can be drawn.
"""

import json
import math
import pathlib
import struct
import sys
import zlib

NEAR, FAR, SIDE = 4, 26, 10
ACROSS, ALONG = 20, 12
CELL, FLANK = 0.025, 3
ROW = 0.5
CYAN, RED, WHITE, YELLOW, BLACK = (0, 220, 220), (255, 40, 40), (255, 255, 255), (255, 210, 0), (0, 0, 0)


class Picture:
    def __init__(self, width, height):
        self.width, self.height = width, height
        self.rows = [bytearray(3 * width) for _ in range(height)]

    @staticmethod
    def read(path):
        data, at, parts = path.read_bytes(), 8, []
        while at < len(data):
            length, kind = struct.unpack(">I4s", data[at : at + 8])
            if kind == b"IHDR":
                width, height, bits, colour = struct.unpack(">IIBB", data[at + 8 : at + 18])
                assert (bits, colour) == (8, 2)
            elif kind == b"IDAT":
                parts.append(data[at + 8 : at + 8 + length])
            at += 12 + length
        picture, raw, above = Picture(width, height), zlib.decompress(b"".join(parts)), bytes(3 * width)
        for y in range(height):
            method, line = raw[y * (3 * width + 1)], bytearray(raw[y * (3 * width + 1) + 1 : (y + 1) * (3 * width + 1)])
            for i in range(3 * width if method else 0):
                a, b, c = (line[i - 3] if i > 2 else 0), above[i], (above[i - 3] if i > 2 else 0)
                paeth = min((a, b, c), key=lambda value: abs(a + b - c - value))
                line[i] = (line[i] + (0, a, b, (a + b) // 2, paeth)[method]) & 255
            picture.rows[y] = above = line
        return picture

    def write(self, path):
        """Writes 32 levels of each colour, which are as many as one sees, and a third of the file."""
        level = bytes(min(255, (value + 4) // 8 * 8) for value in range(256))
        raw = b"".join(b"\0" + row.translate(level) for row in self.rows)
        head = struct.pack(">IIBBBBB", self.width, self.height, 8, 2, 0, 0, 0)
        parts = [(b"IHDR", head), (b"IDAT", zlib.compress(raw, 9)), (b"IEND", b"")]
        chunks = [
            struct.pack(">I", len(body)) + name + body + struct.pack(">I", zlib.crc32(name + body))
            for name, body in parts
        ]
        path.write_bytes(b"\x89PNG\r\n\x1a\n" + b"".join(chunks))

    def at(self, x, y):
        return tuple(self.rows[int(y)][3 * int(x) : 3 * int(x) + 3])

    def put(self, x, y, colour):
        if 0 <= x < self.width and 0 <= y < self.height:
            self.rows[int(y)][3 * int(x) : 3 * int(x) + 3] = bytes(colour)

    def line(self, a, b, colour, thick=1):
        steps = max(1, int(max(abs(b[0] - a[0]), abs(b[1] - a[1]))))
        for i in range(steps + 1):
            x, y = a[0] + (b[0] - a[0]) * i / steps, a[1] + (b[1] - a[1]) * i / steps
            for k in range(thick * thick):
                self.put(x + k % thick, y + k // thick, colour)

    def halved(self):
        half = Picture(self.width // 2, self.height // 2)
        for y in range(half.height):
            upper, lower = self.rows[2 * y], self.rows[2 * y + 1]
            for i in range(3 * half.width):
                k = 6 * (i // 3) + i % 3
                half.rows[y][i] = (upper[k] + upper[k + 3] + lower[k] + lower[k + 3]) // 4
        return half


class View:
    """The camera of a frame, and the road before it as a chain of straight links."""

    def __init__(self, label, links):
        self.camera = label["camera"]
        self.eye = self.camera["position"]
        ahead = [link for link in links if self.is_ahead(link)]
        self.links = sorted(ahead, key=lambda link: min(self.ends(link)))

    def local(self, place):
        apart = [place[i] - self.eye[i] for i in range(3)]
        return [sum(apart[i] * self.camera[axis][i] for i in range(3)) for axis in ("right", "forward", "up")]

    def ends(self, link):
        """How far before the camera a link begins and ends."""
        return self.local(link["from"])[1], self.local(link["to"])[1]

    def is_ahead(self, link):
        sides = [abs(self.local(link[end])[0]) for end in ("from", "to")]
        return max(self.ends(link)) > 2 and min(self.ends(link)) < FAR + 5 and min(sides) < SIDE

    def pixel(self, place):
        right, forward, up = self.local(place)
        camera = self.camera
        return (
            (camera["cx"] + camera["fx"] * right / forward, camera["cy"] - camera["fy"] * up / forward)
            if forward > 1
            else None
        )

    def on_link(self, link, station, offset):
        a, b = link["from"], link["to"]
        length = math.hypot(b[0] - a[0], b[1] - a[1])
        x, y = (b[0] - a[0]) / length, (b[1] - a[1]) / length
        height = a[2] + (b[2] - a[2]) * station / length
        return (a[0] + x * station + y * offset, a[1] + y * station - x * offset, height)

    def place(self, distance, offset):
        """The place at a distance before the camera, beside the road's line."""
        link = next((link for link in self.links if max(self.ends(link)) >= distance), self.links[-1])
        a, b = self.ends(link)
        length = math.dist(link["from"][:2], link["to"][:2])
        return self.on_link(link, length * (distance - a) / (b - a), offset if b > a else -offset)


def stripes(profile):
    """Rising and falling edges of similar strength, 6 to 36 cm apart, as pairs of cells."""
    edges = [0.0] * len(profile)
    for i in range(FLANK, len(profile) - FLANK):
        edges[i] = (sum(profile[i : i + FLANK]) - sum(profile[i - FLANK : i])) / FLANK
    least = 0.12 * sum(profile) / len(profile)
    peaks = [
        i
        for i in range(1, len(edges) - 1)
        if abs(edges[i]) >= least and abs(edges[i - 1]) <= abs(edges[i]) > abs(edges[i + 1])
    ]
    pairs = zip(peaks, peaks[1:])
    return [
        (a, b)
        for a, b in pairs
        if edges[a] > 0 > edges[b] and 0.06 <= (b - a) * CELL <= 0.36 and 0.4 < -edges[a] / edges[b] < 2.5
    ]


def read_table(path):
    links = []
    for line in path.read_text().splitlines():
        fields = line.split(",")
        if fields[0] == "link":
            numbers = [float(field) for field in fields[2:8]]
            links.append({"from": numbers[:3], "to": numbers[3:], "lines": []})
        elif fields[0] == "line":
            links[-1]["lines"].append(fields)
    return links


def is_painted(fields, station):
    if fields[6] != "dashed" or not fields[9]:
        return True
    length, period, phase = (float(field) for field in fields[9:12])
    return (station - phase) % period <= length


def main(session, table, frame, folder):
    label = json.loads(session.joinpath("labels.jsonl").read_text().splitlines()[frame])
    image = Picture.read(session / label["image"])
    view = View(label, read_table(table))

    rows = image.halved()
    for distance in range(NEAR, FAR, 2):
        ends = [view.pixel(view.place(distance, side)) for side in (-SIDE, SIDE)]
        rows.line(*[(x / 2, y / 2) for x, y in ends], CYAN)
    rows.write(folder / "paint-rows.png")

    def seen(distance, offset):
        x, y = view.pixel(view.place(distance, offset)) or (-1, -1)
        return image.at(x, y) if 0 <= x < image.width and 0 <= y < image.height else None

    above = Picture(2 * SIDE * ACROSS, (FAR - NEAR) * ALONG)
    for y in range(above.height):
        for x in range(above.width):
            above.put(x, y, seen(FAR - y / ALONG, x / ACROSS - SIDE) or BLACK)
    profile_at = 9
    graph = Picture(above.width, above.height + 110)
    graph.rows[: above.height] = [bytearray(row) for row in above.rows]
    graph.line((0, (FAR - profile_at) * ALONG), (above.width, (FAR - profile_at) * ALONG), CYAN)
    last = None
    for i in range(int(2 * SIDE / CELL)):
        colour = seen(profile_at, i * CELL - SIDE)
        point = colour and (i * CELL * ACROSS, graph.height - 1 - (colour[0] + colour[1]) / 2 * 100 / 255)
        if point and last:
            graph.line(last, point, CYAN)
        last = point
    graph.write(folder / "paint-profile.png")

    for k in range(int((FAR - NEAR) / ROW)):
        distance = NEAR + (k + 0.5) * ROW
        colours = [seen(distance, i * CELL - SIDE) for i in range(int(2 * SIDE / CELL))]
        first = next(i for i, colour in enumerate(colours) if colour)
        known = colours[first : first + sum(colour is not None for colour in colours)]
        for a, b in stripes([(colour[0] + colour[1]) / 2 for colour in known]):
            x, y = (first + (a + b) / 2) * CELL * ACROSS, (FAR - distance) * ALONG
            above.line((x - 1, y - 2), (x - 1, y + 2), RED, thick=2)
    above.write(folder / "paint-stripes.png")

    lines = image.halved()
    for link in view.links:
        for fields in link["lines"]:
            start, end, from_offset, to_offset = (float(field) for field in fields[2:6])
            count = max(1, int((end - start) / 0.1))
            for i in range(count):
                station = start + (end - start) * i / count
                offset = from_offset + (to_offset - from_offset) * i / count
                ends = [view.pixel(view.on_link(link, station + more, offset)) for more in (0, 0.1)]
                if all(ends) and is_painted(fields, station):
                    lines.line(*[(x / 2, y / 2) for x, y in ends], RED if fields[7] == "white" else CYAN, thick=2)
    lines.write(folder / "paint-lines.png")


if __name__ == "__main__":
    main(pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), int(sys.argv[3]), pathlib.Path(sys.argv[4]))
