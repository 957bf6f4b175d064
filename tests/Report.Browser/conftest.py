import json
import os
import pathlib

import pytest

from page import Page, browser, resize

SESSIONS = pathlib.Path(os.environ["REPORT_SESSIONS"])


@pytest.fixture(scope="session")
def driver():
    with browser() as started:
        yield started


@pytest.fixture
def open_page(driver):
    resize(driver, 1280, 720)

    def open_report(session, fragment=""):
        return Page(driver, SESSIONS / session / "report.html", fragment)

    yield open_report
    # No error of any page goes unnoticed.
    assert [entry for entry in driver.get_log("browser") if entry["level"] == "SEVERE"] == []


@pytest.fixture
def labels():
    """The labels of a session, as they are on the disk."""
    return lambda session: [json.loads(line) for line in (SESSIONS / session / "labels.jsonl").read_text().splitlines()]
