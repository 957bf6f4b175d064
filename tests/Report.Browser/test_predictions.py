"""What the report shows of predictions. What is expected comes from the COCO export and the predictions that predict.py made of it."""

import json

import pytest

from conftest import SESSIONS


@pytest.fixture(scope="module")
def expected():
    """Found, missed and false boxes of each frame."""
    truth = json.loads((SESSIONS / "town-coco/annotations/instances_train.json").read_text())
    frames = {image["id"]: {"matched": [], "missed": [], "false": 0} for image in truth["images"]}
    for number, item in enumerate(item for item in truth["annotations"] if not item["iscrowd"]):
        kind = "matched" if number % 3 == 1 else "missed"
        frames[item["image_id"]][kind].append([round(value) for value in item["bbox"]])
        frames[item["image_id"]]["false"] += number % 3 == 2
    return frames


PIXELS = 1  # Both sides are rounded to whole pixels.


def boxes(page, kind):
    return sorted(
        page.script(
            "return [...document.querySelectorAll(`.prediction.${arguments[0]}`)].map(e => "
            "['x', 'y', 'width', 'height'].map(side => Math.round(e.getAttribute(side))))",
            kind,
        )
    )


def near(shown, wanted):
    return len(shown) == len(wanted) and all(
        abs(one - other) <= PIXELS for box, target in zip(shown, sorted(wanted)) for one, other in zip(box, target)
    )


def test_found_missed_and_false_boxes_are_told_apart(open_page, expected):
    page = open_page("predicted", "#5")
    frame = expected[5]
    assert near(boxes(page, "matched"), frame["matched"])
    assert near(boxes(page, "missed"), frame["missed"])
    assert page.count(".prediction.false") == frame["false"]
    assert page.text("#outcomes-here") == (
        f"This frame: {len(frame['matched'])} matched, {len(frame['missed'])} missed, {frame['false']} false."
    )
    styles = page.script(
        "return ['matched', 'missed', 'false'].map(kind => { const s = getComputedStyle(document.querySelector(`.prediction.${kind}`)); "
        "return [s.stroke, s.strokeDasharray]; })"
    )
    assert len({stroke for stroke, _ in styles}) == len({dashes for _, dashes in styles}) == 3


def test_switch_and_key_hide_predictions(open_page):
    page = open_page("predicted", "#5")
    drawn = page.count(".prediction")
    assert drawn > 0
    page.press("x")
    assert page.count(".prediction") == 0
    page.switch("kinds", "predictions")
    assert page.count(".prediction") == drawn


def test_frames_with_the_most_errors_come_first(open_page, expected):
    page = open_page("predicted")
    errors = {number: len(frame["missed"]) + frame["false"] for number, frame in expected.items()}
    order = sorted((number for number in errors if errors[number]), key=lambda number: (-errors[number], number))
    links = page.script(
        "return [...document.querySelectorAll('.worst a')].map(a => Number(a.textContent.split(' ')[1]))"
    )
    assert links == order
    page.script("document.querySelectorAll('.worst a')[1].click()")
    page.wait(lambda: page.frame() == order[1])
    page.press("w")
    page.wait(lambda: page.frame() == order[2])


def test_counts_of_classes_add_up(open_page, expected):
    page = open_page("predicted")
    cells = page.script(
        "return [...document.querySelector('#by-class tbody').lastElementChild.children].map(cell => cell.textContent)"
    )
    totals = [sum(len(frame[kind]) for frame in expected.values()) for kind in ("matched", "missed")]
    assert cells[:3] == ["all", *map(str, totals)]
    assert cells[4] == str(sum(frame["false"] for frame in expected.values()))
    assert page.count("#evaluation figure svg[aria-label]") == page.count("#evaluation figure") > 0


def test_hidden_class_hides_its_predictions(open_page):
    page = open_page("predicted", "#5")
    before = page.count(".prediction")
    page.switch("classes", "car")
    assert page.count(".prediction") < before


def test_controls_stay_visible_with_predictions(open_page):
    page = open_page("predicted")
    below = page.script(
        "return [...document.querySelectorAll('#kinds button, #next-worst, #classes button, #text, #mostOccluded')]"
        ".filter(e => e.getBoundingClientRect().bottom > innerHeight).map(e => e.id || e.textContent)"
    )
    assert below == []


def test_report_without_predictions_has_none(open_page):
    page = open_page("town")
    assert page.count(".prediction") == 0
    assert not page.find("#evaluation").is_displayed()
