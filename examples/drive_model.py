"""Drives the car by a model instead of the ground truth: drive_model.py MODEL.py [--host H] [--port N] [--seconds S] [--token WORD]

MODEL.py defines predict(image), which returns DeepDriving's 13 indicators, scaled to a TORCS road, in the order of docs/bridge.md.
The controller on the game's side drives by them. The image is a numpy array of height x width x 3 bytes. Without numpy it is a list of
rows, each of them bytes in the order red, green, blue.
"""
import argparse
import importlib.util
import socket
import struct
import time
import zlib

from drive_loop import receive, send


SUB, UP = 1, 2
MOST_SILENCE = 60  # Seconds without a byte from the game.


def load(path):
    spec = importlib.util.spec_from_file_location("model", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module.predict


def decode(png):
    """Decodes a PNG as the bridge sends it: 8-bit RGB, not interlaced, each line filtered with Sub or Up."""
    at, compressed = 8, b""
    while at < len(png):
        length, kind = struct.unpack(">I4s", png[at : at + 8])
        chunk = png[at + 8 : at + 8 + length]
        if kind == b"IHDR":
            width, height = struct.unpack(">II", chunk[:8])
        elif kind == b"IDAT":
            compressed += chunk
        at += length + 12
    data, stride = zlib.decompress(compressed), width * 3
    lines = [data[row * (stride + 1) : (row + 1) * (stride + 1)] for row in range(height)]
    if any(line[0] not in (SUB, UP) for line in lines):
        raise ValueError(
            "the image has a line that is filtered with neither Sub nor Up; images of the bridge have none"
        )
    try:
        import numpy
    except ImportError:
        return decode_slowly(lines, stride)
    picture = numpy.zeros((height, stride), numpy.uint8)
    for row, line in enumerate(lines):
        differences = numpy.frombuffer(line, numpy.uint8, offset=1)
        if line[0] == SUB:
            picture[row] = numpy.cumsum(differences.reshape(width, 3), axis=0, dtype=numpy.uint8).reshape(stride)
        else:
            picture[row] = differences + picture[row - 1] if row else differences
    return picture.reshape(height, width, 3)


def decode_slowly(lines, stride):
    above, picture = bytes(stride), []
    for line in lines:
        current = bytearray(line[1:])
        for at in range(stride):
            before = above[at] if line[0] == UP else current[at - 3] if at >= 3 else 0
            current[at] = (current[at] + before) & 255
        above = bytes(current)
        picture.append(above)
    return picture


def look(stream):
    """Returns the number of the next frame and its image. Errors of the model are left to the model."""
    try:
        state, png = receive(stream)
        return state["frame"], decode(png)
    except (ValueError, KeyError, TypeError, struct.error, zlib.error) as problem:
        raise ConnectionError(f"malformed frame: {problem!r}") from problem


def greet(stream, token):
    """Exchanges hellos."""
    send(stream, type="hello", version=1, **({"token": token} if token else {}))
    try:
        receive(stream)
    except (ValueError, KeyError, TypeError, struct.error) as problem:
        raise ConnectionError(f"malformed hello: {problem!r}") from problem


def drive(predict, host, port, seconds, token):
    end = time.monotonic() + seconds
    with socket.create_connection((host, port), timeout=MOST_SILENCE).makefile("rwb") as stream:
        greet(stream, token)
        while time.monotonic() < end:
            frame, picture = look(stream)
            send(stream, type="indicators", frame=frame, values=[float(value) for value in predict(picture)])


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description="Drives the car by a model over the live bridge.")
    parser.add_argument("model", help="a file with a function predict(image) that returns 13 indicators")
    parser.add_argument("--host", default="127.0.0.1", help="the machine on which the game runs")
    parser.add_argument("--port", type=int, default=4567)
    parser.add_argument("--seconds", type=float, default=60)
    parser.add_argument("--token", help="the token of the bridge")
    options = parser.parse_args()
    predict = load(options.model)
    try:
        drive(predict, options.host, options.port, options.seconds, options.token)
    except OSError as problem:
        raise SystemExit(f"The bridge failed: {problem}")
