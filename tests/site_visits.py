"""Visits to a built page in a browser, with the network off."""

import os
import shutil
from contextlib import contextmanager

import pytest
from playwright.sync_api import sync_playwright

# The contrast of an element's text with the ground that it stands on (WCAG 2, relative luminance).
CONTRAST = """element => {
  const numbers = (colour) => colour.match(/[0-9.]+/g).map(Number);
  const light = ([r, g, b]) => [r, g, b].map((c) => c / 255)
    .map((c) => c <= 0.03928 ? c / 12.92 : ((c + 0.055) / 1.055) ** 2.4)
    .reduce((sum, c, i) => sum + c * [0.2126, 0.7152, 0.0722][i], 0);
  let ground = element;
  while (numbers(getComputedStyle(ground).backgroundColor)[3] === 0) ground = ground.parentElement;
  const both = [getComputedStyle(element).color, getComputedStyle(ground).backgroundColor];
  const [low, high] = both.map((c) => light(numbers(c))).sort((a, b) => a - b);
  return (high + 0.05) / (low + 0.05);
}"""


@contextmanager
def open_browser():
    """A Chromium; without one the test is skipped, or fails where all is to be tested."""
    names = ("chromium", "chromium-browser", "google-chrome")
    path = os.environ.get("BROWSER_PATH") or next(filter(None, map(shutil.which, names)), None)
    if path is None:
        message = f"no browser is installed ({', '.join(names)})"
        pytest.fail(message) if "CI" in os.environ else pytest.skip(message)
    with sync_playwright() as playwright:
        # Machines without a graphics card draw 3D in software, which Chromium wants to be asked for.
        arguments = ["--no-sandbox", "--enable-unsafe-swiftshader"]
        browser = playwright.chromium.launch(executable_path=path, args=arguments)
        yield browser
        browser.close()


class Visit:
    """A page that was opened offline, and what happened meanwhile."""

    def __init__(self, browser, file, *, theme="light", width=1280, query="", without=None, **context):
        self.requests, self.complaints = [], []
        self.context = browser.new_context(
            offline=True,
            color_scheme=theme,
            reduced_motion="reduce",  # else the theme glides to what is scrolled to
            viewport={"width": width, "height": 844},
            **context,
        )
        self.page = self.context.new_page()
        self.page.on("request", lambda request: self.requests.append(request.url))
        self.page.on("pageerror", lambda error: self.complaints.append(str(error)))
        self.page.on("console", self._hear)
        if without:
            self.page.route(f"**/{without}*", lambda route: route.abort())
        self.page.goto(file.as_uri() + query)

    def _hear(self, message):
        if message.type == "error":
            self.complaints.append(message.text)

    def __enter__(self):
        return self

    def __exit__(self, *error):
        self.context.close()

    def draw_figures(self):
        """Scroll to each figure; return how many traces each shows."""
        traces = []
        for box in self.page.locator(".plotly-figure").all():
            box.scroll_into_view_if_needed()
            box.locator(".main-svg").first.wait_for()
            traces.append(box.locator(".plotly-live").evaluate("live => live.data.length"))
        return traces
