import json
import os
import pathlib

import pytest

from page import Page, browser, resize
from serving import viewer

SESSIONS = pathlib.Path(os.environ["REPORT_SESSIONS"])


@pytest.fixture(scope="session")
def driver():
    with browser() as started:
        yield started


@pytest.fixture
def open_page(driver):
    resize(driver, 1280, 720)

    def open_report(session, fragment=""):
        return Page(driver, (SESSIONS / session / "report.html").as_uri(), fragment)

    yield open_report
    # No error of any page goes unnoticed.
    assert [entry for entry in driver.get_log("browser") if entry["level"] == "SEVERE"] == []


@pytest.fixture(scope="session")
def served():
    """The address of each session that one viewer serves."""
    names = ["town", "rig", "hostile", "long"]
    with viewer(*(SESSIONS / name for name in names)) as address:
        yield {name: f"{address}{number}/" for number, name in enumerate(names)} | {"": address}


@pytest.fixture
def view(driver, served):
    resize(driver, 1280, 720)

    def open_view(session, fragment=""):
        page = Page(driver, served[session], fragment)
        page.wait(lambda: page.script("return source.known === source.count && Boolean(data.facts)"))
        return page

    yield open_view
    assert [entry for entry in driver.get_log("browser") if entry["level"] == "SEVERE"] == []


@pytest.fixture
def labels():
    """The labels of a session, as they are on the disk."""
    return lambda session: [json.loads(line) for line in (SESSIONS / session / "labels.jsonl").read_text().splitlines()]
