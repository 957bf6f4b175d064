"""Drives the served game by the rule of the example and judges it: check.py PORT."""

import io
import os
import socket
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "examples"))
from drive_loop import keep_lane, receive, send
from drive_model import decode

FRAMES = 200
# Half the width of the car, as on a road of TORCS: the simulated cars are 2 m wide at most, and lanes 5.4 m.
HALF_CAR = 1.0 * 4 / 5.4
ML, MR = 7, 8


def drive(stream):
    way, before, frames_in_lane = 0, None, 0
    for _ in range(FRAMES):
        state, png = receive(stream)
        assert state["type"] == "frame" and len(state["indicators"]) == 13 and png[:8] == b"\x89PNG\r\n\x1a\n"
        send(stream, type="controls", frame=state["frame"], **keep_lane(state))
        if before is not None:
            assert state["frame"] > before["frame"] and state["timeSeconds"] > before["timeSeconds"]
            way += sum((a - b) ** 2 for a, b in zip(state["position"], before["position"])) ** 0.5
        before = state
        markings = state["torcsEquivalent"]
        if state["lanesKnown"] and markings[MR] < 5.5:
            frames_in_lane += 1
            assert markings[ML] < -HALF_CAR and markings[MR] > HALF_CAR, f"out of the lane: {state}"
    # At 8 m/s and 10 frames a second it is 0.8 m a frame, less the start and places where it has to slow down.
    assert way > 0.4 * FRAMES, f"only {way:.0f} m in {FRAMES} frames"
    assert frames_in_lane > FRAMES / 2, f"in a lane in only {frames_in_lane} of {FRAMES} frames"
    print(f"{way:.0f} m in {FRAMES} frames, {frames_in_lane} of them in a known lane")


def compare_pictures(stream):
    _, png = receive(stream)
    picture = decode(png)
    try:
        from PIL import Image
    except ImportError:
        return
    expected = Image.open(io.BytesIO(png)).convert("RGB").tobytes()
    assert b"".join(bytes(row) for row in picture) == expected


def step(stream):
    send(stream, type="pause", paused=True)
    before = None
    while True:
        send(stream, type="requestFrame")
        state, _ = receive(stream)
        if before is not None and state["timeSeconds"] == before["timeSeconds"]:
            break
        before = state
    for _ in range(5):
        # Frames that were asked for while the world was still going on may be on the way.
        send(stream, type="controls", **keep_lane(state))
        send(stream, type="step", seconds=0.5)
        stood = state
        while state["timeSeconds"] == stood["timeSeconds"]:
            state, _ = receive(stream)
        # To the end of the tick, of which the simulated game has 60 a second.
        assert 0.499 < state["timeSeconds"] - stood["timeSeconds"] < 0.5 + 1 / 60, (stood, state)
    send(stream, type="pause", paused=False)


with socket.create_connection(("127.0.0.1", int(sys.argv[1]))).makefile("rwb") as game:
    send(game, type="hello", version=1)
    hello, _ = receive(game)
    assert hello == {"type": "hello", "version": 1}, hello
    drive(game)
    compare_pictures(game)
    step(game)
