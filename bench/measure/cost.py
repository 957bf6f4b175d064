"""Runs a command and prints, as JSON, its exit code, seconds, processor time and greatest memory.

A process of its own, because the greatest memory of a child counts from the fork: it is at least that of the parent.
"""

import json
import os
import resource
import subprocess
import sys
import time

BYTES_PER_KILOBYTE = 1024  # of ru_maxrss on Linux

start = time.perf_counter()
code = subprocess.run(sys.argv[1:], stdout=subprocess.DEVNULL, check=False).returncode
seconds = time.perf_counter() - start
usage = resource.getrusage(resource.RUSAGE_CHILDREN)
print(
    json.dumps(
        {
            "code": code,
            "seconds": seconds,
            "processor_seconds": usage.ru_utime + usage.ru_stime,
            "megabytes": usage.ru_maxrss * BYTES_PER_KILOBYTE / 1e6,
        }
    )
)
