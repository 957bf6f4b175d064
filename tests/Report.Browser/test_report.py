"""What the report shows and what its controls do. What is expected comes from labels.jsonl."""

import math

import pytest
from selenium.webdriver.common.action_chains import ActionChains
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

FRAME = 5
CONTROLS = (
    "#play, #slider, #speed, #plot, #plot-name, #bars, #thumbs, #kinds button, #classes button, #paint, #opacity, #text, #farthest, "
    "#smallest, #mostOccluded, #mostTruncated, #leastSeen, #clear, #help-open"
)
GROUND_TOLERANCE_METRES = 0.05  # Positions in the page have two decimals, headings of the ego two.


def area(box):
    return (box[2] - box[0]) * (box[3] - box[1])


def nearest(frame, kind="car"):
    return min((item for item in frame["objects"] if item["class"] == kind), key=lambda item: item["distanceMetres"])


def posts(frame):
    """The ids of signs and lights whose faces or heads are objects of their own; they are not drawn at first."""
    parts = (
        lambda item: sum(other["parent"] == item["id"] for other in frame["objects"])
        if item["knownParts"] is None
        else item["knownParts"]
    )
    return {
        item["id"]
        for item in frame["objects"]
        if item["parent"] is None and item["class"] in ("sign", "trafficLight") and parts(item) > 0
    }


def drawn(frame):
    return [item for item in frame["objects"] if item["id"] not in posts(frame)]


def test_controls_are_visible_without_scrolling(open_page):
    page = open_page("town")
    boxes = page.script(
        "return [...document.querySelectorAll(arguments[0])].map(e => { const b = e.getBoundingClientRect(); return [e.id || e.textContent, b.top, b.bottom, b.left, b.right]; })",
        CONTROLS,
    )
    assert len(boxes) > 15
    assert [box for box in boxes if box[1] < 0 or box[2] > 720 or box[3] < 0 or box[4] > 1280] == []


def test_phone_has_no_sideways_scrolling(driver, open_page):
    from page import resize

    page = open_page("town")
    resize(driver, 390, 844)
    assert page.script("return document.documentElement.scrollWidth") <= 390


def test_each_object_has_its_box(open_page, labels):
    page = open_page("town", f"#{FRAME}")
    frame = labels("town")[FRAME]
    boxes = page.script(
        "return [...document.querySelectorAll('rect.box')].map(e => [Number(e.dataset.object), +e.getAttribute('x'), +e.getAttribute('y'), +e.getAttribute('width'), +e.getAttribute('height')])"
    )
    expected = {item["id"]: item["box2d"] for item in drawn(frame)}
    assert {box[0] for box in boxes} == set(expected)
    for number, x, y, width, height in boxes:
        left, top, right, bottom = expected[number]
        assert (x, y, x + width, y + height) == pytest.approx(
            (left, top, right, bottom), abs=0.11
        )  # Two numbers of one decimal.


def test_each_layer_is_drawn_by_its_switch(open_page, labels):
    page = open_page("town", f"#{FRAME}")
    frame = labels("town")[FRAME]
    joints = sum(joint["pixel"] is not None for item in frame["objects"] for joint in item.get("joints") or [])
    lines = len(frame["lanes"]["markings"] or frame["lanes"]["boundaries"])
    assert page.count(".line") >= lines > 0
    assert page.count(".joint") == joints
    for label, selector, expected in (
        ("visible box", ".visible", sum(item["box2dVisible"] is not None for item in drawn(frame))),
        ("amodal box", ".amodal", len(drawn(frame))),
        ("3D box", ".edges", len(drawn(frame))),
    ):
        assert page.count(selector) == 0
        page.switch("kinds", label)
        assert page.count(selector) == expected > 0
    for label, selector in (("lane lines", ".line"), ("joints", ".joint")):
        page.switch("kinds", label)
        assert page.count(selector) == 0


def test_some_frame_shows_joints(open_page, labels):
    frame = next(frame for frame in labels("town") if any(item.get("joints") for item in frame["objects"]))
    page = open_page("town", f"#frame={frame['frame']}")
    assert page.count(".joint") > 0


def test_class_switch_hides_the_class(open_page, labels):
    page = open_page("town", f"#{FRAME}")
    frame = labels("town")[FRAME]
    page.switch("classes", "car")
    assert page.count("rect.box") == sum(item["class"] != "car" for item in drawn(frame)) < len(drawn(frame))


@pytest.mark.parametrize(
    "name, text, passes",
    [
        ("farthest", "30", lambda item: item["distanceMetres"] <= 30),
        ("smallest", "12", lambda item: item["box2d"][3] - item["box2d"][1] >= 12),
        ("mostOccluded", "25", lambda item: (item["occludedFraction"] or 0) <= 0.25),
        ("mostTruncated", "10", lambda item: item["truncatedFraction"] <= 0.1),
        ("leastSeen", "120", lambda item: area(item["box2d"]) * (1 - (item["occludedFraction"] or 0)) >= 120),
        (
            "text",
            "car",
            lambda item: "car" in f"{item['id']} {item['class']} {item['model']} {item['name'] or ''}".lower(),
        ),
    ],
)
def test_filter_counts_what_passes(open_page, labels, name, text, passes):
    page = open_page("town", f"#{FRAME}")
    page.type_into(name, text)
    frames = labels("town")
    passed = [sum(map(passes, frame["objects"])) for frame in frames]
    all_labels = sum(len(frame["objects"]) for frame in frames)
    assert 0 < sum(passed) < all_labels
    assert (
        page.text("#matches")
        == f"{sum(passed)} of {all_labels} labels in {sum(count > 0 for count in passed)} of {len(frames)} frames"
    )
    assert page.count("rect.box") == sum(map(passes, drawn(frames[FRAME])))
    page.find("#clear").click()
    assert page.count("rect.box") == len(drawn(frames[FRAME]))


def test_pointing_and_clicking_shows_the_object(driver, open_page, labels):
    page = open_page("town", f"#{FRAME}")
    item = nearest(labels("town")[FRAME])
    page.script(
        "document.querySelector(`.footprint[data-object='${arguments[0]}']`).dispatchEvent(new Event('pointerenter'))",
        item["id"],
    )
    assert f"Object ID\n{item['id']}" in page.text("#details") and item["model"] in page.text("#details")
    page.script(
        "document.querySelector(`rect.box[data-object='${arguments[0]}']`).dispatchEvent(new Event('click'))",
        item["id"],
    )
    assert page.count(".chosen") == 2
    seen = [frame["frame"] for frame in labels("town") if any(other["id"] == item["id"] for other in frame["objects"])]
    assert 1 <= page.count("#crops button") <= 8
    page.find("#crops button").click()
    page.wait(lambda: page.frame() == seen[0])
    page.find("#follow").click()
    assert page.count(".chosen") == 0 and page.count("#crops button") == 0


def test_ground_has_objects_where_they_are(open_page, labels):
    page = open_page("town", f"#{FRAME}")
    frame = labels("town")[FRAME]
    ego = frame["ego"]
    places = page.script(
        "return [...document.querySelectorAll('.footprint')].map(e => [Number(e.dataset.object), ...e.getAttribute('transform').match(/-?[0-9.]+(e-?[0-9]+)?/g).map(Number)])"
    )
    ids = {item["id"] for item in frame["objects"]}
    hidden = posts(frame)
    assert {place[0] for place in places} == {
        item["id"] for item in frame["objects"] if item["id"] not in hidden and item["parent"] not in ids - hidden
    }
    for number, x, y, turn in places:
        box = next(item for item in frame["objects"] if item["id"] == number)["box3d"]
        away = [a - b for a, b in zip(box["centre"][:2], ego["position"][:2])]
        # The flat direction of the ego, from its axes instead of its heading.
        ahead = [part / math.hypot(*ego["forward"][:2]) for part in ego["forward"][:2]]
        expected = (away[0] * ahead[1] - away[1] * ahead[0], -(away[0] * ahead[0] + away[1] * ahead[1]))
        assert (x, y) == pytest.approx(expected, abs=GROUND_TOLERANCE_METRES)
        facing = math.atan2(ego["forward"][1], ego["forward"][0]) - math.atan2(box["forward"][1], box["forward"][0])
        assert math.remainder(math.radians(turn) - facing, 2 * math.pi) == pytest.approx(0, abs=math.radians(1))


def test_posts_are_drawn_only_if_asked_for(open_page, labels):
    frame = next(frame for frame in labels("town") if posts(frame))
    page = open_page("town", f"#{frame['frame']}")
    ids = {item["id"] for item in frame["objects"]}
    marked = lambda mark: set(
        page.script("return [...document.querySelectorAll(arguments[0])].map(e => Number(e.dataset.object))", mark)
    )
    assert marked("rect.box") == ids - posts(frame)
    page.switch("kinds", "posts of signs and lights")
    assert marked("rect.box") == ids
    assert marked(".footprint") == {item["id"] for item in frame["objects"] if item["parent"] not in ids}
    page.press("o")
    assert marked("rect.box") == ids - posts(frame)
    page.script("choose(arguments[0])", min(posts(frame)))
    assert marked("rect.box") == ids - posts(frame) | {min(posts(frame))}


def test_address_shows_the_same_again(open_page, labels):
    page = open_page("town", f"#{FRAME}")
    page.switch("classes", "truck")
    page.switch("kinds", "3D box")
    page.type_into("farthest", "60")
    page.press("n")
    marks, address = page.marks(), page.script("return location.hash")
    assert f"frame={FRAME}" in address and "object=" in address and "hide=truck" in address
    again = open_page("town", address)
    assert again.marks() == marks
    assert again.script("return byId('farthest').value") == "60"


def test_nonsense_in_the_address_is_ignored(open_page):
    page = open_page("town", "#frame=x&object=&show=%00&hide=constructor&farthest=NaN&plot=__proto__")
    assert page.frame() == 0


def test_keys_do_what_the_help_says(open_page, labels):
    page = open_page("town")
    last = len(labels("town")) - 1
    for key, frame in (
        (Keys.ARROW_RIGHT, 1),
        (Keys.ARROW_LEFT, 0),
        (Keys.ARROW_LEFT, last),
        (Keys.HOME, 0),
        (Keys.PAGE_DOWN, 10),
        (Keys.END, last),
    ):
        page.press(key)
        page.wait(lambda: page.frame() == frame)
    for key, layer in (
        ("b", "box"),
        ("v", "visible"),
        ("a", "amodal"),
        ("d", "edges"),
        ("l", "lanes"),
        ("j", "joints"),
        ("o", "posts"),
        ("k", "mask"),
        ("t", "depth"),
        ("r", "points"),
    ):
        before = page.script("return state.shown.has(arguments[0])", layer)
        page.press(key)
        assert page.script("return state.shown.has(arguments[0])", layer) != before
    page.press(Keys.HOME)
    page.wait(lambda: page.frame() == 0)
    page.press("n")
    order = sorted(labels("town")[0]["objects"], key=lambda item: item["distanceMetres"])  # The posts are shown now.
    assert f"Object ID\n{order[0]['id']}" in page.text("#details")
    page.press("p")
    assert f"Object ID\n{order[-1]['id']}" in page.text("#details")
    page.press(Keys.ESCAPE)
    assert page.text("#details") == ""
    page.press("+")
    width = page.script("return byId('overlay').viewBox.baseVal.width")
    assert width == pytest.approx(320 / 1.5)
    page.press("0")
    assert page.script("return byId('overlay').viewBox.baseVal.width") == 320
    page.press("/")
    assert page.script("return document.activeElement.id") == "text"
    page.find("#text").send_keys(Keys.ESCAPE)
    page.press("?")
    assert page.find("#help").is_displayed()
    described = page.script("return [...byId('keys').querySelectorAll('tbody th')].map(e => e.textContent)")
    assert len(described) == page.script("return Object.keys(keys).length")
    page.press(Keys.ESCAPE)
    page.wait(lambda: not page.find("#help").is_displayed())


def test_next_match_skips_other_frames(open_page, labels):
    page = open_page("town", "#frame=0")
    model_frames = {}
    for frame in labels("town"):
        for item in frame["objects"]:
            model_frames.setdefault(item["model"], set()).add(frame["frame"])
    model, frames = next(
        (model, frames)
        for model, frames in sorted(model_frames.items())
        if min(frames) > 0 and not any(model in other and model != other for other in model_frames)
    )
    page.type_into("text", model)
    page.press("m")
    page.wait(lambda: page.frame() == min(frames))


def test_play_goes_through_the_frames(open_page):
    page = open_page("town")
    page.find("#play").click()
    assert page.find("#play").get_attribute("aria-label") == "Pause"
    page.wait(lambda: page.frame() >= 3)
    page.find("#play").click()
    stopped = page.frame()
    assert page.find("#play").get_attribute("aria-label") == "Play"
    page.press(Keys.ARROW_RIGHT)
    page.wait(lambda: page.frame() == stopped + 1)


def test_plot_has_the_values_of_the_labels(open_page, labels):
    page = open_page("town", f"#{FRAME}")
    frames = labels("town")
    page.script("byId('plot-name').value = 'angle'; byId('plot-name').dispatchEvent(new Event('change'))")
    assert "angle" in page.text("#plot-name option:checked")
    values = [frame["lanes"]["indicators"]["angle"] for frame in frames if frame["lanes"]["valid"]["angle"]]
    least, greatest = page.text("#plot-range").split(" to ")
    assert (float(least), float(greatest)) == pytest.approx((min(values), max(values)), abs=0.005001)
    plot = page.find("#plot")
    ActionChains(page.driver).move_to_element_with_offset(plot, plot.size["width"] // 2 - 1, 0).click().perform()
    page.wait(lambda: page.frame() == len(frames) - 1)


def test_bars_show_when_a_class_appears(open_page, labels):
    page = open_page("town")
    frames = labels("town")
    names = page.script("return Object.keys(data.classes)")
    # One column for each frame: its middle row of pixels in the row of each class.
    drawn = page.script(
        """
        const canvas = byId("bars"), context = canvas.getContext("2d");
        return Object.keys(data.classes).map((_, row) => Array.from({ length: canvas.width }, (_, x) => context.getImageData(x, row * barHeight + 1, 1, 1).data[3] > 0));
    """
    )
    for name, row in zip(names, drawn):
        assert row == [any(item["class"] == name for item in frame["objects"]) for frame in frames], name


def test_key_goes_to_the_next_event(open_page, labels):
    page = open_page("town")
    frames = labels("town")
    moved = next(index for index in range(1, len(frames)) if frames[index]["place"] != frames[index - 1]["place"])
    assert moved > 0
    for _ in range(page.script("return data.events.length")):
        page.press("e")
        if page.frame() == moved:
            break
    page.wait(lambda: page.frame() == moved)
    assert "new place" in page.text("#message")


def test_small_pictures_lead_to_their_frames(open_page, labels):
    page = open_page("town")
    page.wait(
        lambda: page.script("return [...document.querySelectorAll('#thumbs canvas')].every(canvas => canvas.width > 1)")
    )
    frames = page.script("return [...byId('thumbs').children].map(button => Number(button.dataset.index))")
    assert len(frames) > 5 and frames == sorted(set(frames))
    page.driver.find_elements(By.CSS_SELECTOR, "#thumbs button")[3].click()
    page.wait(lambda: page.frame() == frames[3])


def test_picture_is_described_in_words(open_page, labels):
    page = open_page("town", f"#{FRAME}")
    whole = [item for item in labels("town")[FRAME]["objects"] if item["parent"] is None]
    words = page.find("#image").get_attribute("aria-label")
    assert words.startswith(f"Frame {FRAME}: ")
    assert f"{sum(item['class'] == 'car' for item in whole)} car" in words
    assert f"at {min(item['distanceMetres'] for item in whole):.0f} m" in words


def test_wheel_zooms_about_the_pointer(open_page):
    page = open_page("town")
    before = page.script(
        "const m = byId('overlay').getScreenCTM().inverse(); const p = new DOMPoint(200, 200).matrixTransform(m); return [p.x, p.y]"
    )
    page.script(
        "byId('overlay').dispatchEvent(new WheelEvent('wheel', {clientX: 200, clientY: 200, deltaY: -300, cancelable: true}))"
    )
    after = page.script(
        "const m = byId('overlay').getScreenCTM().inverse(); const p = new DOMPoint(200, 200).matrixTransform(m); return [p.x, p.y]"
    )
    assert page.script("return byId('overlay').viewBox.baseVal.width") == 160
    assert after == pytest.approx(before, abs=1e-3)


def test_views_of_a_rig_are_side_by_side(open_page, labels):
    page = open_page("rig", "#frame=0")
    frames = labels("rig")
    names = [frame["view"] for frame in frames if frame["moment"] == 0]
    assert [button.text for button in page.driver.find_elements(By.CSS_SELECTOR, "#views button")] == names and len(
        names
    ) == 6
    page.driver.find_elements(By.CSS_SELECTOR, "#views button")[3].click()
    page.wait(lambda: page.frame() == 3)
    assert names[3] in page.text("#position")


def test_dark_and_light_style_differ(driver, open_page):
    page = open_page("town")
    colours = []
    for scheme in ("dark", "light"):
        driver.execute_cdp_cmd(
            "Emulation.setEmulatedMedia", {"features": [{"name": "prefers-color-scheme", "value": scheme}]}
        )
        colours.append(page.script("return getComputedStyle(document.body).backgroundColor"))
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})
    assert colours[0] != colours[1]


def test_high_contrast_leaves_no_grey(driver, open_page):
    page = open_page("town")
    script = "return [...document.querySelectorAll('dt, .hint, h2, small')].map(e => getComputedStyle(e).color)"
    assert len(set(page.script(script))) > 0
    for scheme, ink in (("light", "rgb(0, 0, 0)"), ("dark", "rgb(255, 255, 255)")):
        features = [{"name": "prefers-contrast", "value": "more"}, {"name": "prefers-color-scheme", "value": scheme}]
        driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": features})
        assert set(page.script(script)) == {ink}
    driver.execute_cdp_cmd("Emulation.setEmulatedMedia", {"features": []})


def test_every_control_has_a_name(open_page):
    page = open_page("town")
    page.press("n")
    nameless = page.script(
        "return [...document.querySelectorAll('button, input, select')].filter(e => !(e.getAttribute('aria-label') || e.labels?.length || e.textContent.trim())).map(e => e.outerHTML)"
    )
    assert nameless == []


def test_hostile_names_are_text(open_page):
    page = open_page("hostile")
    page.press("n")
    assert "onerror" in page.text("#details") and "onerror" in page.text("#caption")
    for key in (Keys.ARROW_RIGHT, "n", "?"):
        page.press(key)
    assert page.script("return window.hacked === undefined")
    assert page.count("img[src=x]") == 0


def test_page_asks_for_nothing_else(open_page):
    page = open_page("town")
    page.press("n")
    addresses = page.script("return performance.getEntriesByType('resource').map(entry => entry.name)")
    assert [address for address in addresses if not address.startswith("data:")] == []


def test_thousand_frames_are_small(driver, open_page, labels):
    from conftest import SESSIONS

    assert (SESSIONS / "long" / "report.html").stat().st_size < 15e6
    page = open_page("long")
    assert page.script("return data.frames.length") == 1000
    for frame in range(0, 1000, 50):
        page.go_to(frame)
    driver.execute_cdp_cmd("Performance.enable", {})
    driver.execute_cdp_cmd("HeapProfiler.collectGarbage", {})
    metrics = {
        entry["name"]: entry["value"] for entry in driver.execute_cdp_cmd("Performance.getMetrics", {})["metrics"]
    }
    assert metrics["JSHeapUsedSize"] < 200e6
