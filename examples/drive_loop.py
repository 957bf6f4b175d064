"""Drives over the live bridge by the lane indicators: drive_loop.py [PORT [SECONDS]]. docs/bridge.md has the protocol."""
import json, socket, struct, sys, time


def receive(stream):
    lengths = stream.read(8)
    if len(lengths) < 8:
        raise EOFError("the game has closed the bridge")
    header_length, payload_length = struct.unpack(">II", lengths)
    return json.loads(stream.read(header_length)), stream.read(payload_length)


def send(stream, **message):
    header = json.dumps(message).encode()
    stream.write(struct.pack(">II", len(header), 0) + header)
    stream.flush()


def keep_lane(state):
    angle, L, M, R, _, _, _, ML, MR, _, _, ahead, _ = state["torcsEquivalent"]
    centre = (ML + MR) / 2 if MR - ML < 5.5 else (R + M) / 2 if R < 7 else (L + M) / 2
    steering = (angle - centre / 8) / 0.8 if state["lanesKnown"] else 0
    too_fast = state["speedMetresPerSecond"] - min(8, max(0, ahead - 10))
    return {"steering": steering, "throttle": max(0, -0.3 * too_fast), "brake": max(0, 0.2 * too_fast)}


def drive(port=4567, seconds=60.0, controls=keep_lane):
    end = time.monotonic() + seconds
    with socket.create_connection(("127.0.0.1", port)).makefile("rwb") as stream:
        while time.monotonic() < end:
            state, picture_png = receive(stream)
            send(stream, type="controls", frame=state["frame"], **controls(state))


if __name__ == "__main__":
    drive(*(kind(word) for kind, word in zip((int, float), sys.argv[1:])))
