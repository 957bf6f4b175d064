"""Reads ASAM OpenLABEL 1.0 from its specification: what is required, what is allowed, and how data project to the image."""

import json
import os

import cv2
import numpy as np
from PIL import Image

ROOT = {
    "metadata",
    "objects",
    "actions",
    "events",
    "contexts",
    "relations",
    "tags",
    "frames",
    "frame_intervals",
    "streams",
    "coordinate_systems",
    "ontologies",
    "resources",
}
FRAME = {"objects", "actions", "events", "contexts", "relations", "frame_properties"}
OBJECT = {
    "name",
    "type",
    "object_data",
    "object_data_pointers",
    "frame_intervals",
    "coordinate_system",
    "ontology_uid",
    "resource_uid",
}
DATA = {
    "bbox",
    "rbbox",
    "cuboid",
    "poly2d",
    "poly3d",
    "num",
    "text",
    "boolean",
    "vec",
    "point2d",
    "point3d",
    "mat",
    "binary",
    "image",
    "mesh",
    "area_reference",
    "line_reference",
}


def matrix_of(transform):
    """The matrix of a rotation by a quaternion x, y, z, w, and a translation."""
    data = transform["transform_src_to_dst"]
    return rotation(data["quaternion"]), np.array(data["translation"])


def rotation(quaternion):
    axis, w = np.array(quaternion[:3]), quaternion[3]
    assert abs(axis @ axis + w * w - 1) < 1e-6
    cross = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
    return np.eye(3) + 2 * w * cross + 2 * cross @ cross


def frames_of(intervals):
    return [frame for item in intervals for frame in range(item["frame_start"], item["frame_end"] + 1)]


def read(root, labels):
    with open(os.path.join(root, "labels", "train", "0000.json"), encoding="utf-8") as file:
        document = json.load(file)
    assert set(document) == {"openlabel"}
    top = document["openlabel"]
    assert set(top) <= ROOT and top["metadata"]["schema_version"] == "1.0.0"
    systems = top["coordinate_systems"]
    for name, system in systems.items():
        assert system["type"] and (system["parent"] == "" or name in systems[system["parent"]]["children"])
    stream = top["streams"]["camera"]
    assert set(stream) <= {"type", "description", "uri", "stream_properties"} and stream["type"] == "camera"
    pinhole = stream["stream_properties"]["intrinsics_pinhole"]
    camera = np.array(pinhole["camera_matrix"], float).reshape(3, 4)
    coefficients = np.array(pinhole["distortion_coeffs"], float)
    assert camera.shape == (3, 4) and len(coefficients) == 5

    assert [int(key) for key in top["frames"]] == list(range(len(labels))) == frames_of(top["frame_intervals"])
    for key, item in top["objects"].items():
        assert set(item) <= OBJECT and item["name"] and item["type"]
        assert frames_of(item["frame_intervals"]) == [
            int(frame) for frame, data in top["frames"].items() if key in data["objects"]
        ]
    assert all(key in top["objects"] for frame in top["frames"].values() for key in frame["objects"])

    corners = 0
    for label, frame in zip(labels, top["frames"].values()):
        assert set(frame) <= FRAME
        properties = frame["frame_properties"]
        assert Image.open(os.path.join(root, properties["streams"]["camera"]["uri"])).size == (
            pinhole["width_px"],
            pinhole["height_px"],
        )
        turn, place = matrix_of(properties["transforms"]["camera_to_world"])
        seen = {
            item["id"]: item
            for item in label["objects"]
            if item["parent"] is None and not item["knownParts"] and item["box2dVisible"]
        }
        assert {str(number) for number in seen} <= set(frame["objects"])
        for number, source in seen.items():
            data = frame["objects"][str(number)]["object_data"]
            assert set(data) <= DATA and top["objects"][str(number)]["type"] == source["class"]
            x, y, width, height = data["bbox"][0]["val"]
            assert np.allclose(
                [x - width / 2, y - height / 2, x + width / 2, y + height / 2], source["box2dVisible"], atol=0.002
            )
            values = data["cuboid"][0]["val"]
            ends = np.array(np.meshgrid([-0.5, 0.5], [-0.5, 0.5], [-0.5, 0.5])).reshape(3, -1).T * values[7:]
            world = ends @ rotation(values[3:7]).T + values[:3]
            inside = (world - place) @ turn
            if (inside[:, 2] > 0.5).all():
                pixels, _ = cv2.projectPoints(inside, np.zeros(3), np.zeros(3), camera[:, :3].copy(), coefficients)
                pixels = pixels[:, 0]
                # The cuboid's corners span the box around its whole silhouette.
                assert np.allclose([*pixels.min(0), *pixels.max(0)], source["box2dAmodal"], atol=0.1)
                corners += len(pixels)
        lines = label["lanes"].get("markings") or label["lanes"]["boundaries"]
        drawn = frame["objects"]["65536"]["object_data"]["poly2d"] if lines else []
        assert len(drawn) == len(lines)
        for line, source in zip(drawn, lines):
            assert line["mode"] == "MODE_POLY2D_ABSOLUTE" and line["closed"] is False
            assert np.allclose(np.array(line["val"]).reshape(-1, 2), source["pixels"], atol=0.001)
    assert corners > 0
