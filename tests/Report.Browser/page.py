"""A report in a headless browser."""

import contextlib

from selenium import webdriver
from selenium.webdriver.chrome.service import Service
from selenium.webdriver.common.by import By
from selenium.webdriver.common.keys import Keys
from selenium.webdriver.support.ui import WebDriverWait

PATIENCE_SECONDS = 60  # A page is ready in a second; a busy machine may take long.


class Page:
    """The page of a session. Positions and counts are read from what the browser shows."""

    def __init__(self, driver, address: str, fragment: str = ""):
        self.driver = driver
        driver.get("about:blank")
        driver.get(address + fragment)
        self.wait(lambda: self.script("return byId('position').textContent !== ''"))

    def wait(self, condition):
        WebDriverWait(self.driver, PATIENCE_SECONDS, poll_frequency=0.05).until(lambda _: condition())

    def script(self, text, *arguments):
        return self.driver.execute_script(text, *arguments)

    def find(self, selector):
        return self.driver.find_element(By.CSS_SELECTOR, selector)

    def count(self, selector):
        return len(self.driver.find_elements(By.CSS_SELECTOR, selector))

    def text(self, selector):
        return self.find(selector).text

    def press(self, *keys):
        self.find("body").send_keys(*keys)

    def frame(self):
        """Number of the frame that is shown."""
        return int(self.script("return byId('position').textContent.split(/[ ,]/)[1]"))

    def go_to(self, frame):
        self.script("location.hash = arguments[0]", f"frame={frame}")
        self.wait(lambda: self.frame() == frame)

    def switch(self, group, label):
        """Clicks the switch whose label begins with a text."""
        next(
            button
            for button in self.driver.find_elements(By.CSS_SELECTOR, f"#{group} button")
            if button.text.startswith(label)
        ).click()

    def marks(self):
        """All that is drawn on the picture and on the ground."""
        return self.script("return byId('marks').innerHTML + byId('ground').innerHTML")

    def rasters(self):
        """The maps and points that are drawn on the frame that is shown; None while they are read."""
        index, kinds = self.script("return (byId('stage').dataset.rasters ?? '-1:').split(':')")
        return kinds if int(index) == self.script("return state.index") else None

    def show_layers(self, *names):
        """Shows these layers and no others, and waits until they are drawn."""
        self.script("state.shown = new Set(arguments[0]); refilter()", names)
        wanted = [name for name in ("mask", "depth", "points") if name in names]
        self.wait(lambda: self.rasters() == ",".join(wanted))

    def type_into(self, name, text):
        field = self.find(f"#{name}")
        field.send_keys(Keys.CONTROL, "a")
        field.send_keys(text or Keys.DELETE)
        self.script("document.activeElement.blur()")

    def console(self):
        return [entry["message"] for entry in self.driver.get_log("browser")]


@contextlib.contextmanager
def browser():
    options = webdriver.ChromeOptions()
    for argument in ("--headless=new", "--no-sandbox", "--disable-gpu", "--disable-dev-shm-usage"):
        options.add_argument(argument)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    driver = webdriver.Chrome(options=options, service=Service("/usr/bin/chromedriver"))
    try:
        yield driver
    finally:
        driver.quit()


def resize(driver, width, height):
    """Sets the size of what the page sees of the window."""
    driver.execute_cdp_cmd(
        "Emulation.setDeviceMetricsOverride",
        {"width": width, "height": height, "deviceScaleFactor": 1, "mobile": width < 500},
    )
