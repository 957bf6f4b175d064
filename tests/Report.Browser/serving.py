"""A viewer that runs beside the tests."""

import contextlib
import os
import subprocess

HARVESTER = os.environ["REPORT_HARVESTER"].split()


@contextlib.contextmanager
def viewer(*sessions):
    """Serves sessions; gives the address, with the token."""
    process = subprocess.Popen([*HARVESTER, "view", *map(str, sessions)], stdout=subprocess.PIPE, text=True)
    try:
        address = process.stdout.readline().strip()
        assert address.startswith("http://127.0.0.1:"), address
        yield address
    finally:
        process.terminate()
        process.wait(timeout=60)
        process.stdout.close()
