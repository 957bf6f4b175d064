"""Images and masks, and what is wrong with them."""

from __future__ import annotations

import struct
import zlib
import conftest
import gtaharvest
import numpy as np
import pytest
from conftest import HEIGHT, WIDTH, HandmadeSession
from gtaharvest import open_session, png


def test_images_are_red_green_blue_and_masks_have_16_bits(handmade: HandmadeSession) -> None:
    frame = open_session(handmade.write())[2]
    assert frame.image().dtype == np.uint8 and frame.mask().dtype == np.uint16
    np.testing.assert_array_equal(frame.image(), conftest.image(2))
    np.testing.assert_array_equal(frame.mask(), conftest.mask())
    assert (frame.mask() == 7).sum() == 36


def test_class_maps_have_8_bits(handmade: HandmadeSession) -> None:
    classes = (np.arange(HEIGHT * WIDTH).reshape(HEIGHT, WIDTH) % len(gtaharvest.SEMANTIC_CLASS_NAMES)).astype(np.uint8)
    handmade.lines[1]["classMap"] = {"file": "classes/1.png", "method": "exact", "raysCast": 0, "interpolatedPixels": 0}
    folder = handmade.write()
    (folder / "classes").mkdir()
    (folder / "classes/1.png").write_bytes(png.encode(classes))
    frame = open_session(folder)[1]
    assert frame.class_map().dtype == np.uint8
    np.testing.assert_array_equal(frame.class_map(), classes)
    assert gtaharvest.SEMANTIC_CLASS_NAMES[1] == "road" and gtaharvest.SEMANTIC_CLASS_NAMES[20] == "other"
    with pytest.raises(gtaharvest.MissingPictureError, match="line 1: the frame has no class map"):
        open_session(folder)[0].class_map()
    (folder / "classes/1.png").write_bytes(png.encode(classes.astype(np.uint16)))
    with pytest.raises(gtaharvest.PictureError, match="8 bits"):
        open_session(folder)[1].class_map()


def test_depth_maps_are_in_metres(handmade: HandmadeSession) -> None:
    units = (np.arange(HEIGHT * WIDTH).reshape(HEIGHT, WIDTH) * 256 // 2 % 65536).astype(np.uint16)
    handmade.lines[1]["depth"] = {
        "sparse": "depth/1.png",
        "completed": "depth-completed/1.png",
        "error": None,
        "raysCast": 3,
        "measuredPixels": 4,
    }
    folder = handmade.write()
    for name in ("depth", "depth-completed"):
        (folder / name).mkdir()
        (folder / name / "1.png").write_bytes(png.encode(units))
    frame = open_session(folder)[1]
    depth = frame.depth()
    assert depth.dtype == np.float32 and np.isnan(depth[0, 0]) and depth[0, 1] == 0.5 and depth[0, 3] == 1.5
    np.testing.assert_array_equal(frame.view.depth("completed"), depth)
    with pytest.raises(gtaharvest.MissingPictureError, match="line 2: the frame has no error depth"):
        frame.depth("error")
    with pytest.raises(gtaharvest.MissingPictureError, match="line 1: the frame has no sparse depth"):
        open_session(folder)[0].depth()
    with pytest.raises(ValueError, match="sparse, completed, error, not 'all'"):
        frame.depth("all")


def test_normals_are_unit_vectors(handmade: HandmadeSession) -> None:
    coded = np.zeros((HEIGHT, WIDTH, 3), np.uint8)
    coded[0, 0], coded[0, 1] = (128, 128, 1), (128, 38, 38)
    handmade.lines[1]["normals"] = {"file": "normals/1.png", "method": "exact", "raysCast": 0}
    folder = handmade.write()
    (folder / "normals").mkdir()
    (folder / "normals/1.png").write_bytes(png.encode(coded))
    normals = open_session(folder)[1].normals()
    assert normals.dtype == np.float32 and normals.shape == (HEIGHT, WIDTH, 3) and np.isnan(normals[1, 1]).all()
    np.testing.assert_allclose(normals[0, 0], [0, 0, -1], atol=1e-6)
    np.testing.assert_allclose(normals[0, 1], [0, -np.sqrt(0.5), -np.sqrt(0.5)], atol=1e-6)
    with pytest.raises(gtaharvest.MissingPictureError, match="line 1: the frame has no map of normals"):
        open_session(folder)[0].normals()


def test_birds_eye_maps_have_a_size_of_their_own(handmade: HandmadeSession) -> None:
    classes, seen = np.zeros((12, 12), np.uint8), np.zeros((12, 12), np.uint8)
    classes[0, 11], seen[3, 4] = 5, 255
    label = {"file": "birds-eye/1.png", "visible": "birds-eye-visible/1.png", "cells": 12, "cellMetres": 2.0}
    handmade.lines[1]["birdsEye"] = {**label, "source": "exact"}
    handmade.lines[0]["birdsEye"] = {**label, "visible": None, "source": "roads"}
    folder = handmade.write()
    for name, picture in (("birds-eye", classes), ("birds-eye-visible", seen)):
        (folder / name).mkdir()
        (folder / name / "1.png").write_bytes(png.encode(picture))
    frame = open_session(folder)[1]
    np.testing.assert_array_equal(frame.birds_eye(), classes)
    assert gtaharvest.BIRDS_EYE_CLASS_NAMES[frame.birds_eye()[0, 11]] == "vehicle" and frame.birds_eye_cell_metres == 2
    assert frame.birds_eye_visible().dtype == np.bool_ and np.argwhere(frame.birds_eye_visible()).tolist() == [[3, 4]]
    with pytest.raises(gtaharvest.MissingPictureError, match="line 1: the frame has no bird's-eye map"):
        open_session(folder)[0].birds_eye_visible()


def test_voxels_are_layers_from_below(handmade: HandmadeSession) -> None:
    classes, ids, seen = np.zeros((12, 4), np.uint8), np.zeros((12, 4), np.uint16), np.zeros((12, 4), np.uint8)
    classes[9, 2], ids[9, 2], seen[4, 0] = 11, 700, 255
    folders = {"file": "occupancy", "instances": "occupancy-instances", "visible": "occupancy-visible"}
    names = {key: f"{folder}/1.png" for key, folder in folders.items()}
    handmade.lines[1]["occupancy"] = {**names, "cells": 4, "layers": 3, "cellMetres": 0.4, "lowestMetres": -1.0}
    folder = handmade.write()
    for name, picture in zip(folders.values(), (classes, ids, seen)):
        (folder / name).mkdir()
        (folder / name / "1.png").write_bytes(png.encode(picture))
    frame = open_session(folder)[1]
    assert frame.occupancy().shape == (3, 4, 4) and np.argwhere(frame.occupancy()).tolist() == [[2, 1, 2]]
    assert frame.occupancy()[2, 1, 2] == 11 and frame.occupancy_instances()[2, 1, 2] == 700
    assert np.argwhere(frame.occupancy_visible()).tolist() == [[1, 0, 0]]
    with pytest.raises(gtaharvest.MissingPictureError, match="line 1: the frame has no voxels"):
        open_session(folder)[0].occupancy()


def test_flow_is_in_pixels_and_motion_in_metres(handmade: HandmadeSession) -> None:
    coded = np.zeros((HEIGHT, WIDTH, 3), np.uint16)
    coded[0, 0], coded[0, 1] = (32768 + 96, 32768 - 1, 1), (32768, 32768, 1)
    moved = np.zeros((HEIGHT, WIDTH, 3), np.uint16)
    moved[0, 0], moved[0, 1] = (32768, 32768, 32768), (32769, 31768, 34768)
    flags = np.zeros((HEIGHT, WIDTH), np.uint8)
    flags[0, 1] = 3
    names = ("backward", "forward", "motion", "backwardFlags", "forwardFlags")
    handmade.lines[1]["flow"] = {
        "from": 0,
        "method": "exact",
        "raysCast": 0,
        **{name: f"flow/{name}.png" for name in names},
    }
    folder = handmade.write()
    (folder / "flow").mkdir()
    for name, picture in zip(names, (coded, coded[::-1].copy(), moved, flags, flags)):
        (folder / f"flow/{name}.png").write_bytes(png.encode(picture))
    frame = open_session(folder)[1]
    flow = frame.flow()
    assert flow.dtype == np.float32 and flow.shape == (HEIGHT, WIDTH, 2) and frame.flow_from == 0
    np.testing.assert_array_equal(flow[0, :2], [[1.5, -1 / 64], [0, 0]])
    assert np.isnan(flow[1:]).all() and np.isnan(frame.flow("forward")[:-1]).all()
    motion = frame.surface_motion()
    np.testing.assert_allclose(motion[0, :2], [[0, 0, 0], [0.001, -1, 2]], atol=1e-6)
    assert np.isnan(motion[1:]).all()
    assert frame.flow_flags()[0, 1] == gtaharvest.FLOW_VALID | gtaharvest.FLOW_MOVED
    with pytest.raises(ValueError, match="kind is one of backward, forward, not 'both'"):
        frame.flow("both")
    with pytest.raises(gtaharvest.MissingPictureError, match="line 1: the frame has no flow"):
        open_session(folder)[0].flow()
    (folder / "flow/backward.png").write_bytes(png.encode(flags))
    with pytest.raises(gtaharvest.PictureError, match="16 bits for each of red, green and blue"):
        frame.flow()


def test_bmp_images(handmade: HandmadeSession) -> None:
    picture = conftest.image(0)
    handmade.lines[0]["image"] = "frames/0.bmp"
    folder = handmade.write()
    for height, rows in ((HEIGHT, picture[::-1]), (-HEIGHT, picture)):
        data = rows[..., ::-1].tobytes()
        header = struct.pack("<IIiiHHIIiiII", 40, 0, WIDTH, height, 1, 24, 0, len(data), 0, 0, 0, 0)[:4] + struct.pack(
            "<iiHHIIiiII", WIDTH, height, 1, 24, 0, len(data), 0, 0, 0, 0
        )
        (folder / "frames/0.bmp").write_bytes(b"BM" + struct.pack("<III", 54 + len(data), 0, 54) + header + data)
        np.testing.assert_array_equal(open_session(folder)[0].image(), picture)


def test_a_missing_picture_is_named(handmade: HandmadeSession) -> None:
    handmade.lines[1]["mask"] = None
    folder = handmade.write()
    (folder / "frames/00000001.png").unlink()
    frame = open_session(folder)[1]
    with pytest.raises(gtaharvest.MissingPictureError, match=r"00000001\.png.*does not exist") as missing:
        frame.image()
    assert "\n" not in str(missing.value)
    with pytest.raises(gtaharvest.MissingPictureError, match="line 2: the frame has no mask"):
        frame.mask()
    assert frame.view.mask_path is None


def test_a_damaged_picture_is_refused(handmade: HandmadeSession) -> None:
    folder = handmade.write()
    path = folder / "frames/00000000.png"
    for data in (b"", b"no picture", path.read_bytes()[:60]):
        path.write_bytes(data)
        with pytest.raises(gtaharvest.PictureError, match="cannot be decoded"):
            open_session(folder)[0].image()


def test_a_picture_of_another_size_is_refused(handmade: HandmadeSession) -> None:
    folder = handmade.write()
    (folder / "frames/00000000.png").write_bytes(png.encode(np.zeros((4, 6, 3), np.uint8)))
    with pytest.raises(gtaharvest.PictureError, match="6x4 pixels; its label says 80x60"):
        open_session(folder)[0].image()


def test_a_picture_outside_the_session_is_not_opened(handmade: HandmadeSession) -> None:
    folder = handmade.write()
    (folder.parent / "secret.png").write_bytes((folder / "frames/00000000.png").read_bytes())
    (folder / "link.png").symlink_to(folder.parent / "secret.png")
    for line, name in zip(handmade.lines, ("../secret.png", str(folder.parent / "secret.png"), "link.png")):
        line["image"] = name
    handmade.write()
    for frame in open_session(folder):
        with pytest.raises(gtaharvest.LabelError, match="outside the session"):
            frame.image()


@pytest.mark.parametrize(
    "shape, dtype", [((5, 7), np.uint8), ((5, 7), np.uint16), ((5, 7, 3), np.uint8), ((1, 1), np.uint16)]
)
def test_png_round_trip(shape: tuple[int, ...], dtype: type) -> None:
    picture = np.random.default_rng(2).integers(0, np.iinfo(dtype).max, shape, dtype=dtype, endpoint=True)
    np.testing.assert_array_equal(png.decode(png.encode(picture)), picture)


def test_png_filters_as_other_encoders_write_them() -> None:
    """All five filters, row by row, encoded here by the formulas of the specification."""
    picture = np.random.default_rng(3).integers(0, 256, (11, 6, 3)).astype(np.uint8)
    flat = picture.reshape(11, -1).astype(int)
    rows = b""
    for y, row in enumerate(flat):
        kind = y % 5
        rows += bytes([kind])
        for x, value in enumerate(row):
            a = row[x - 3] if x >= 3 else 0
            b = flat[y - 1][x] if y else 0
            c = flat[y - 1][x - 3] if y and x >= 3 else 0
            p = a + b - c
            paeth = min(((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c)))[2]
            rows += bytes([(value - (0, a, b, (a + b) // 2, paeth)[kind]) % 256])
    parts = ((b"IHDR", struct.pack(">IIBBBBB", 6, 11, 8, 2, 0, 0, 0)), (b"IDAT", zlib.compress(rows)), (b"IEND", b""))
    data = b"\x89PNG\r\n\x1a\n" + b"".join(
        struct.pack(">I", len(body)) + kind + body + struct.pack(">I", zlib.crc32(kind + body)) for kind, body in parts
    )
    np.testing.assert_array_equal(png.decode(data), picture)


def test_every_flipped_bit_of_a_png_is_noticed() -> None:
    data = png.encode(conftest.image(0)[:6, :5])
    for position in range(len(data)):
        with pytest.raises(ValueError):
            png.decode(data[:position] + bytes([data[position] ^ 0x10]) + data[position + 1 :])
