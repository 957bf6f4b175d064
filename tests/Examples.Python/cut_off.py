"""A game that closes the bridge in the middle of its first frame: cut_off.py BYTES, less than 0 from its end. It prints its port, and serves one client."""

import json
import socket
import struct
import sys

# An empty picture of one pixel has a header of 33 bytes; this one breaks off before any of its colours.
PICTURE = b"\x89PNG\r\n\x1a\n" + struct.pack(">I4sIIBBBBBI", 13, b"IHDR", 1, 1, 8, 2, 0, 0, 0, 0)
INDICATORS = [0, -7, 3.5, 7, 75, 75, -9.5, -2, 2, 9.5, 75, 75, 75]
HELLO = json.dumps({"type": "hello", "version": 1}).encode()
HEADER = json.dumps(
    {
        "type": "frame",
        "frame": 0,
        "speedMetresPerSecond": 0,
        "lanesKnown": True,
        "indicators": INDICATORS,
        "torcsEquivalent": INDICATORS,
    }
).encode()
MESSAGE = struct.pack(">II", len(HEADER), len(PICTURE) + 100) + HEADER + PICTURE

with socket.create_server(("127.0.0.1", 0)) as listener:
    listener.settimeout(60)
    print(listener.getsockname()[1], flush=True)
    client, _ = listener.accept()
    with client:
        client.sendall(struct.pack(">II", len(HELLO), 0) + HELLO)
        client.sendall(MESSAGE[: int(sys.argv[1])])
