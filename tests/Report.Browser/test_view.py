"""What the viewer serves and shows. What is expected comes from the session's files."""

import http.client
import json
import math
import shutil
import struct
import urllib.error
import urllib.parse
import urllib.request

import pytest
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys

from conftest import SESSIONS
from hostile import ATTACK
from page import Page, resize
from png import grey
from serving import viewer
from test_report import CONTROLS, FRAME, area, drawn

# Points are stored in single precision, and the labels that place them have four decimals.
RANGE_METRES = 0.001
GROUND_METRES = 0.05
POINT_PIXELS = 0.05


def status(address, **headers):
    try:
        with urllib.request.urlopen(urllib.request.Request(address, headers=headers)) as response:
            return response.status
    except urllib.error.HTTPError as error:
        return error.code


def test_only_the_token_opens_the_viewer(served):
    address = served["town"]
    root, token = address.split("/")[2], address.split("/")[3]
    assert status(address) == 200
    for path in ("", "0/", token[:-1] + "/0/", "x" * len(token) + "/0/", token.upper() + "/0/", "favicon.ico"):
        assert status(f"http://{root}/{path}") == 404, path


def test_other_hosts_are_refused(served):
    for host in ("evil.example", "127.0.0.1.evil.example", "localhost:1", ""):
        assert status(served["town"], Host=host) in (400, 403), host
    port = urllib.parse.urlsplit(served["town"]).port
    assert status(served["town"], Host=f"localhost:{port}") == 200


@pytest.mark.parametrize(
    "path",
    [
        "session.json",
        "labels.jsonl",
        "image/../labels.jsonl",
        "image/..%2f..%2fsession.json",
        "image/frames%2f00000000.png",
        "image/-1",
        "image/20",
        "image/99999999999",
        "image/0/0",
        "../9/",
        "frame/",
        "frame/x",
        "classes/0",
    ],
)
def test_nothing_but_the_resources_is_served(served, path):
    connection = http.client.HTTPConnection(*urllib.parse.urlsplit(served["town"]).netloc.split(":"))
    connection.request("GET", urllib.parse.urlsplit(served["town"]).path + path)
    assert connection.getresponse().status == 404


def test_only_reading_is_possible(served):
    for method in ("POST", "PUT", "DELETE", "OPTIONS"):
        assert status_of(method, served["town"]) == 405


def status_of(method, address):
    try:
        with urllib.request.urlopen(urllib.request.Request(address, method=method)) as response:
            return response.status
    except urllib.error.HTTPError as error:
        return error.code


def test_answers_are_not_kept_and_run_nothing(served):
    for path in ("", "state", "frame/0", "image/0"):
        with urllib.request.urlopen(served["town"] + path) as response:
            headers = response.headers
        assert headers["Cache-Control"] == "no-store" and headers["X-Content-Type-Options"] == "nosniff"
        assert headers["Content-Security-Policy"].startswith("default-src 'none'")
        assert "unsafe" not in headers["Content-Security-Policy"]


def test_controls_are_visible_without_scrolling(view):
    page = view("town")
    boxes = page.script(
        "return [...document.querySelectorAll(arguments[0])].map(e => { const b = e.getBoundingClientRect(); return [e.id || e.textContent, b.top, b.bottom, b.left, b.right]; })",
        CONTROLS,
    )
    assert len(boxes) > 25
    assert [box for box in boxes if box[1] < 0 or box[2] > 720 or box[3] < 0 or box[4] > 1280] == []


def test_tools_have_no_sideways_scrolling(view):
    page = view("town")
    assert page.script("return byId('raster-options').hidden") is False
    assert page.script("return byId('tools').scrollWidth - byId('tools').clientWidth") == 0


def test_phone_has_no_sideways_scrolling(driver, view):
    page = view("rig")
    resize(driver, 390, 844)
    assert page.script("return document.documentElement.scrollWidth") <= 390


def test_each_frame_is_asked_for_by_number(view, labels):
    page = view("long", "#frame=700")
    frame = labels("long")[700]
    assert page.frame() == 700
    assert page.count("rect.box") == len(drawn(frame))
    asked = page.script(
        "return performance.getEntriesByType('resource').map(entry => new URL(entry.name).pathname.split('/').slice(-2).join('/'))"
    )
    frames = {int(path.split("/")[1]) for path in asked if path.startswith("frame/")}
    assert 700 in frames and len(frames) < 20


def test_page_asks_only_its_own_server(view, served):
    page = view("town")
    page.show_layers("box", "mask", "depth")
    page.press("n")
    addresses = page.script("return performance.getEntriesByType('resource').map(entry => entry.name)")
    assert len(addresses) > 5
    assert [address for address in addresses if not address.startswith(served["town"])] == []


def test_mask_has_the_pixels_of_the_file(view):
    page = view("town", f"#{FRAME}")
    values = page.script(
        f"return decodeGrey(await source.bytes({FRAME}, 'mask')).then(map => [map.width, ...map.values])"
    )
    rows = grey(SESSIONS / "town" / "masks" / f"{FRAME:08}.png")
    assert values[0] == len(rows[0]) and values[1:] == [value for row in rows for value in row]
    assert len(set(values[1:])) > 3


def test_depth_has_the_pixels_of_the_file(view):
    page = view("town", f"#{FRAME}")
    values = page.script(f"return decodeGrey(await source.bytes({FRAME}, 'depth')).then(map => [...map.values])")
    rows = grey(SESSIONS / "town" / "depth-completed" / f"{FRAME:08}.png")
    assert values == [value for row in rows for value in row]
    assert max(values) > 256


def painted(page, kind):
    """The colours of a layer: its width, then red, green, blue and opacity of each pixel."""
    return page.script(
        """
        const image = new Image();
        image.src = byId(`raster-${arguments[0]}`).getAttribute("href");
        await image.decode();
        const canvas = document.createElement("canvas");
        [canvas.width, canvas.height] = [image.naturalWidth, image.naturalHeight];
        canvas.getContext("2d").drawImage(image, 0, 0);
        return [canvas.width, ...canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height).data];
    """,
        kind,
    )


def test_mask_is_painted_by_instance_or_class(view, labels):
    page = view("town", f"#{FRAME}")
    page.show_layers("mask")
    ids = [value for row in grey(SESSIONS / "town" / "masks" / f"{FRAME:08}.png") for value in row]
    kinds = {item["id"]: item["class"] for item in labels("town")[FRAME]["objects"]}
    kinds[0] = None
    for paint, key in (("instance", lambda value: value), ("class", kinds.get)):
        page.script("byId('paint').value = arguments[0]; byId('paint').dispatchEvent(new Event('change'))", paint)
        page.wait(lambda: page.script("return drawnRasters.get('mask').key.endsWith(arguments[0])", paint))
        pixels = painted(page, "mask")[1:]
        colours = {}
        for index, value in enumerate(ids):
            colours.setdefault(key(value), set()).add(tuple(pixels[4 * index : 4 * index + 4]))
        assert all(len(each) == 1 for each in colours.values()), paint
        assert len(set.union(*colours.values())) == len(colours) > 2, paint
        clear = colours[key(0)].pop()
        assert clear[3] == 0


def test_opacity_fades_the_mask(view):
    page = view("town", f"#{FRAME}")
    page.show_layers("mask")
    page.script("byId('opacity').value = 20; byId('opacity').dispatchEvent(new Event('input'))")
    assert page.find("#raster-mask").get_attribute("opacity") == "0.2"
    assert "opacity=20" in page.script("return location.hash")


def test_depth_is_red_near_and_blue_far(view):
    page = view("town", f"#{FRAME}")
    page.show_layers("depth")
    pixels = painted(page, "depth")[1:]
    depths = [value / 256 for row in grey(SESSIONS / "town" / "depth-completed" / f"{FRAME:08}.png") for value in row]
    near = [index for index, depth in enumerate(depths) if 0 < depth < 8]
    far = [index for index, depth in enumerate(depths) if depth > 75]
    assert near and far
    assert all(pixels[4 * index] > 200 > pixels[4 * index + 2] for index in near)
    assert all(pixels[4 * index + 2] > 200 > pixels[4 * index] for index in far)
    assert all(pixels[4 * index + 3] == 0 for index, depth in enumerate(depths) if depth == 0)


@pytest.mark.parametrize("view_number", [0, 2, 5])
def test_points_have_their_range_and_place(view, labels, view_number):
    page = view("rig", f"#frame={view_number}")
    frames = labels("rig")
    frame, sweep = frames[view_number], frames[0]["lidar"][0]
    raw = (SESSIONS / "rig" / sweep["file"]).read_bytes()
    rig = json.loads((SESSIONS / "rig" / "session.json").read_text())["rig"]
    mount = next(lidar for lidar in rig["lidars"] if lidar["name"] == sweep["sensor"])["position"]
    offset = [sum(parts) for parts in zip(mount, rig.get("origin", [0, 0, 0]))]
    values = page.script(f"return [...new Float32Array(await source.bytes({view_number}, 'points'))]")
    assert len(values) == 5 * sweep["points"] > 0
    ego, camera = frame["ego"], frame["camera"]
    seen = 0
    for index in range(0, sweep["points"], 97):
        u, v, x, y, distance = values[5 * index : 5 * index + 5]
        local = struct.unpack_from("<3f", raw, 24 * index)
        assert distance == pytest.approx(sum(part * part for part in local) ** 0.5, abs=RANGE_METRES)
        on_car = [part + shift for part, shift in zip(local, offset)]
        world = [
            ego["position"][axis]
            + sum(on_car[part] * ego[name][axis] for part, name in enumerate(("right", "forward", "up")))
            for axis in range(3)
        ]
        # The level direction of the ego, from its axes instead of its heading.
        level = [part / math.hypot(*ego["forward"][:2]) for part in ego["forward"][:2]]
        from_ego = [a - b for a, b in zip(world, ego["position"])]
        ground = (from_ego[0] * level[1] - from_ego[1] * level[0], -(from_ego[0] * level[0] + from_ego[1] * level[1]))
        assert (x, y) == pytest.approx(ground, abs=GROUND_METRES)
        away = [a - b for a, b in zip(world, camera["position"])]
        right, ahead, up = (sum(a * b for a, b in zip(away, camera[name])) for name in ("right", "forward", "up"))
        pixel = (camera["cx"] + camera["fx"] * right / ahead, camera["cy"] - camera["fy"] * up / ahead)
        # Of points near the border, rounding decides.
        if ahead > 0.5 and 1 < pixel[0] < camera["width"] - 1 and 1 < pixel[1] < camera["height"] - 1:
            seen += 1
            assert (u, v) == pytest.approx(pixel, abs=POINT_PIXELS)
        elif ahead < 0 or not (-1 < pixel[0] < camera["width"] + 1 and -1 < pixel[1] < camera["height"] + 1):
            assert u is None and v is None  # NaN, which JSON does not have.
    assert seen > 10
    page.show_layers("points")
    assert page.count("#ground image") == 1 and page.find("#raster-points").get_attribute("href").startswith(
        "data:image/png"
    )


@pytest.mark.parametrize(
    "name, text, passes",
    [
        ("farthest", "30", lambda item: item["distanceMetres"] <= 30),
        ("mostTruncated", "10", lambda item: item["truncatedFraction"] <= 0.1),
        ("mostOccluded", "25", lambda item: (item["occludedFraction"] or 0) <= 0.25),
        ("leastSeen", "120", lambda item: area(item["box2d"]) * (1 - (item["occludedFraction"] or 0)) >= 120),
        (
            "text",
            "car",
            lambda item: "car" in f"{item['id']} {item['class']} {item['model']} {item['name'] or ''}".lower(),
        ),
    ],
)
def test_filters_count_the_whole_session(view, labels, name, text, passes):
    page = view("long")
    frames = labels("long")
    page.type_into(name, text)
    passed = [sum(map(passes, frame["objects"])) for frame in frames]
    every = sum(len(frame["objects"]) for frame in frames)
    assert 0 < sum(passed) < every
    assert (
        page.text("#matches")
        == f"{sum(passed)} of {every} labels in {sum(count > 0 for count in passed)} of {len(frames)} frames"
    )


def test_statistics_are_those_of_the_report(view, open_page):
    ids = ("counts", "comparison", "weathers", "hours", "indicators")
    script = "return arguments[0].map(id => byId(id).textContent)"
    assert view("town").script(script, ids) == open_page("town").script(script, ids)


def test_followed_object_is_found_in_all_frames(view, labels):
    page = view("town", f"#{FRAME}")
    page.press("n")
    number = page.script("return state.chosen")
    seen = [frame["frame"] for frame in labels("town") if any(item["id"] == number for item in frame["objects"])]
    assert page.script("return source.sightings(state.chosen).map(({ index }) => index)") == seen
    page.find("#crops button").click()
    page.wait(lambda: page.frame() == seen[0])


def test_views_of_a_rig_are_side_by_side(view, labels):
    page = view("rig", "#frame=8")
    names = [frame["view"] for frame in labels("rig") if frame["moment"] == 1]
    assert [button.text for button in page.driver.find_elements(By.CSS_SELECTOR, "#views button")] == names and len(
        names
    ) == 6


def test_address_shows_the_same_again(view):
    page = view("town", f"#{FRAME}")
    page.show_layers("box", "mask")
    page.type_into("mostTruncated", "50")
    page.press("n")
    marks, address = page.marks(), page.script("return location.hash")
    again = view("town", address)
    again.wait(lambda: again.rasters() == "mask")
    assert again.marks() == marks
    assert again.script("return byId('mostTruncated').value") == "50"


def test_frame_with_a_damaged_line_is_explained(driver, labels, tmp_path):
    session = tmp_path / "damaged"
    shutil.copytree(SESSIONS / "town", session)
    lines = (session / "labels.jsonl").read_text().splitlines(keepends=True)
    lines[3] = lines[3][:200] + "\n"
    (session / "labels.jsonl").write_text("".join(lines))
    with viewer(session) as address:
        page = Page(driver, address)
        page.wait(lambda: "1 lines cannot be read" in page.text("#note"))
        page.script("show(3)")
        page.wait(lambda: "line 4" in page.text("#message"))
        page.script("show(4)")
        page.wait(lambda: page.frame() == 4 and page.text("#message") == "")
    driver.get_log("browser")  # The refused frame is an error for the browser too.


def test_session_that_grows_is_followed(driver, tmp_path):
    session = tmp_path / "growing"
    shutil.copytree(SESSIONS / "town", session)
    header = json.loads((session / "session.json").read_text())
    counters = header.pop("counters")
    (session / "session.json").write_text(json.dumps(header))
    lines = (session / "labels.jsonl").read_text().splitlines(keepends=True)
    (session / "labels.jsonl").write_text("".join(lines[:7]) + lines[7][:100])
    with viewer(session) as address:
        page = Page(driver, address)
        page.wait(lambda: page.script("return source.known") == 7)
        with open(session / "labels.jsonl", "a") as labels_file:
            labels_file.write(lines[7][100:] + "".join(lines[8:]))
        page.wait(lambda: page.script("return source.known") == len(lines))
        page.press(Keys.END)
        page.wait(lambda: page.frame() == len(lines) - 1)
        (session / "session.json").write_text(json.dumps({**header, "counters": counters}))
    driver.get_log("browser")  # The viewer may end while the page still asks.


def test_chooser_leads_to_each_session(driver, served):
    driver.get(served[""])
    links = driver.find_elements(By.CSS_SELECTOR, ".sessions a")
    assert [link.find_element(By.TAG_NAME, "b").text for link in links] == ["town", "rig", "hostile", "long"]
    links[1].click()
    Page(driver, driver.current_url).wait(lambda: "rig" in driver.title)
    assert [entry for entry in driver.get_log("browser") if entry["level"] == "SEVERE"] == []


def test_hostile_names_are_text(view, labels):
    page = view("hostile", f"#{FRAME}")
    page.press("n")
    assert ATTACK in page.text("#details") and ATTACK in page.text("#caption") and ATTACK in page.text("#weathers")
    for key in (Keys.ARROW_RIGHT, "n", "e", "?"):
        page.press(key)
    assert page.script("return window.hacked === undefined")
    assert page.count("img[src=x]") == 0


def test_hostile_folder_name_is_text(driver, tmp_path):
    name = "<img src=x onerror=window.hacked=1>"
    for folder in (name, "second"):
        shutil.copytree(SESSIONS / "town", tmp_path / folder)
    with viewer(tmp_path / name, tmp_path / "second") as address:
        driver.get(address)
        assert driver.find_element(By.CSS_SELECTOR, ".sessions b").text == name
        page = Page(driver, address + "0/")
        page.wait(lambda: page.text("#title") == name)
        assert page.script("return window.hacked === undefined") and page.count("img[src=x]") == 0
    driver.get_log("browser")


def test_masks_are_shown_at_first(view, open_page):
    for page in (view("town"), open_page("town")):
        page.wait(lambda: "mask" in (page.rasters() or ""))
        assert page.script("return state.shown.has('mask')")


def test_address_without_masks_shows_none(view):
    page = view("town", "#show=box")
    page.wait(lambda: page.rasters() is not None)
    assert not page.script("return state.shown.has('mask')")


def test_report_and_viewer_have_the_same_values(view, open_page):
    script = """return ["speed", "yawRate", "acceleration", "steering", ...data.indicatorTable.map(([name]) => name)]
        .map(name => Array.from({ length: source.count }, (_, index) => source.value(name, index)))"""
    served, reported = view("town").script(script), open_page("town").script(script)
    assert served == reported
    assert all(speed > 0 for speed in served[0])


def test_plot_has_axes(view):
    page = view("town")
    values = [float(text) for text in page.text("#plot-values").split()]
    speeds = page.script(
        "return Array.from({ length: source.count }, (_, index) => source.value('speed', index) * 3.6)"
    )
    assert (values[0], values[-1]) == (round(max(speeds), 1), round(min(speeds), 1))
    assert page.text("#plot-frames").split()[:2] == ["frame", "0"] and page.text("#plot-frames").split()[-1] == "19"


def test_layer_that_is_off_is_not_struck_through(view):
    page = view("town", "#show=box")
    styles = page.script(
        """return [...document.querySelectorAll("#kinds button")].map(button => {
        const style = getComputedStyle(button); return [button.getAttribute("aria-pressed"), style.textDecorationLine, style.backgroundColor]; })"""
    )
    assert {line for _, line, _ in styles} == {"none"}
    assert not {fill for pressed, _, fill in styles if pressed == "true"} & {
        fill for pressed, _, fill in styles if pressed == "false"
    }


def test_picture_uses_the_width_of_the_window(driver, view):
    resize(driver, 1366, 768)
    page = view("town")
    resize(driver, 1366, 768)
    assert page.script("return byId('stage').getBoundingClientRect().width") > 1366 * 0.45
