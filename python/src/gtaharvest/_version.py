"""The version of the package: that of the project, in build/Version.props. The wheel has a file with the number alone in place of this."""

import re
from importlib import metadata
from pathlib import Path


def _find() -> str:
    try:
        properties = (Path(__file__).resolve().parents[3] / "build/Version.props").read_text(encoding="utf-8")
    except OSError:
        return metadata.version("gtaharvest")
    found = re.search(r"<Version>(.*)</Version>", properties)
    return found.group(1) if found else metadata.version("gtaharvest")


__version__ = _find()
