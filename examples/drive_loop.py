"""Drives over the live bridge by the lane indicators: drive_loop.py [PORT [SECONDS]]. docs/bridge.md has the protocol."""
import json, socket, struct, sys, time

def receive(stream):
    sizes = struct.unpack(">II", stream.read(8) or sys.exit("The game has closed the bridge."))
    got, png = json.loads(text := stream.read(sizes[0])), stream.read(sizes[1])
    return (got, png) if got["type"] != "error" and got.get("version", 1) == 1 else sys.exit(f"The game refuses: {got.get('reason', text)}")

def send(stream, **message):
    stream.write(struct.pack(">II", len(header := json.dumps(message).encode()), 0) + header)
    stream.flush()

def keep_lane(state):
    _, L, M, R, _, _, _, ML, MR, _, _, ahead, _ = state["torcsEquivalent"]
    centre = (ML + MR) / 2 if MR - ML < 5.5 else (R + M) / 2 if R < 7 else (L + M) / 2
    steering, too_fast = (state["indicators"][0] - centre / 8) / 0.8, state["speedMetresPerSecond"] - min(8, max(0, ahead - 10))
    return {"steering": steering * state["lanesKnown"], "throttle": max(0, -0.3 * too_fast), "brake": max(0, 0.2 * too_fast)}

if __name__ == "__main__":
    port, seconds = (sys.argv[1:] + ["4567", "60"][len(sys.argv) - 1:])[:2]
    try:
        stream = socket.create_connection(("127.0.0.1", int(port)), timeout=60).makefile("rwb")
        send(stream, type="hello", version=1)
        hello, end = receive(stream), time.monotonic() + float(seconds)
        while time.monotonic() < end:
            state, picture_png = receive(stream)
            send(stream, type="controls", frame=state["frame"], **keep_lane(state))
            print(f"\rframe {state['frame']}, {state['speedMetresPerSecond']:.1f} m/s ", end="", flush=True)
    except (OSError, ValueError, KeyError, TypeError, struct.error) as problem:
        sys.exit(f"The bridge failed: {problem!r}")
