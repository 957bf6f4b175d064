"""Ten states of the viewer against stored pictures of what it draws."""

import base64
import os
import pathlib

import pytest

REFERENCES = pathlib.Path(__file__).parent / "screens"

# Another Chromium smooths edges differently, by a few levels of the few pixels along lines. The states differ from each other by at least
# three times as much. Letters, whose font depends on the machine, are hidden.
MOST_MEAN_DIFFERENCE = 0.3  # of 255 levels, over all pixels and channels
LEAST_BETWEEN_STATES = 3 * MOST_MEAN_DIFFERENCE
SCALE = 0.5  # A stored picture is small, and single pixels count less.

STYLE = "const style = new CSSStyleSheet(); style.replaceSync(arguments[0]); document.adoptedStyleSheets = [style]"
NO_LETTERS = "svg text { visibility: hidden }"
NO_PHOTOGRAPH = "#image { visibility: hidden }"  # Keeps the stored pictures small; one state has it.

STATES = {
    "boxes": ("town", 5, ["box"], ""),
    "all-boxes": ("town", 5, ["box", "visible", "amodal", "edges"], ""),
    "joints-and-lanes": ("town", 16, ["lanes", "joints"], ""),
    "mask-by-instance": (
        "town",
        5,
        ["mask"],
        "byId('opacity').value = 100; byId('opacity').dispatchEvent(new Event('input'))",
    ),
    "mask-by-class": (
        "town",
        5,
        ["mask"],
        "byId('paint').value = 'class'; byId('paint').dispatchEvent(new Event('change'))",
    ),
    "depth": ("town", 16, ["depth"], ""),
    "points": ("rig", 0, ["points"], ""),
    "filtered": ("town", 5, ["edges"], "state.hidden.add('pedestrian'); state.farthest = 40; refilter()"),
    "followed": ("town", 5, ["box"], "chooseNext(-1)"),
    "zoomed": ("town", 5, ["box", "edges", "lanes"], "zoomBy(3)"),
}


def screenshot(page, name):
    """The picture and the ground, without letters, as PNG in base64."""
    page.script(STYLE, NO_LETTERS if name == "boxes" else NO_LETTERS + NO_PHOTOGRAPH)
    page.script("return new Promise(done => requestAnimationFrame(() => requestAnimationFrame(done)))")
    left, top, width, height = page.script(
        "const b = document.querySelector('.sight').getBoundingClientRect(); return [b.left, b.top, b.width, b.height]"
    )
    clip = {"x": left, "y": top, "width": width, "height": height, "scale": SCALE}
    return page.driver.execute_cdp_cmd("Page.captureScreenshot", {"format": "png", "clip": clip})["data"]


def difference(page, one, other):
    """Mean difference of two pictures, in levels."""
    return page.script(
        """
        const pixels = [];
        for (const data of arguments) {
          const bitmap = await createImageBitmap(new Blob([Uint8Array.from(atob(data), character => character.charCodeAt(0))]));
          const canvas = new OffscreenCanvas(bitmap.width, bitmap.height);
          canvas.getContext("2d").drawImage(bitmap, 0, 0);
          pixels.push(canvas.getContext("2d").getImageData(0, 0, bitmap.width, bitmap.height).data);
        }
        if (pixels[0].length !== pixels[1].length) return 255;
        let sum = 0;
        for (let i = 0; i < pixels[0].length; i++) sum += Math.abs(pixels[0][i] - pixels[1][i]);
        return sum / pixels[0].length * 4 / 3;
    """,
        one,
        other,
    )


def stored(name):
    return base64.b64encode((REFERENCES / f"{name}.png").read_bytes()).decode()


@pytest.mark.parametrize("name", STATES)
def test_state_looks_as_stored(view, name):
    session, frame, layers, script = STATES[name]
    page = view(session, f"#frame={frame}")
    page.show_layers(*layers)
    page.script(script)
    page.wait(
        lambda: page.script(
            "return !byId('raster-mask').hasAttribute('href') || drawnRasters.get('mask').key.endsWith(state.paint)"
        )
    )
    taken = screenshot(page, name)
    if "REPORT_SCREENS" in os.environ:
        pathlib.Path(os.environ["REPORT_SCREENS"], f"{name}.png").write_bytes(base64.b64decode(taken))
    found = difference(page, taken, stored(name))
    assert found < MOST_MEAN_DIFFERENCE, f"{name}: {found:.2f}"


def test_stored_states_differ_from_each_other(view):
    page = view("town")
    names = [name for name in STATES if STATES[name][0] == "town"]
    pairs = [(one, other) for index, one in enumerate(names) for other in names[:index]]
    assert [pair for pair in pairs if difference(page, stored(pair[0]), stored(pair[1])) < LEAST_BETWEEN_STATES] == []
