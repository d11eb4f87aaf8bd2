"""Visits to a built page in a browser, with the network off."""

import os
from contextlib import contextmanager
from weakref import WeakKeyDictionary

import nbformat
from axe_playwright_python.base import AXE_SCRIPT
from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import expect, sync_playwright

from course_lib.figures.stills import TOY


def be_patient(browser):
    """Let what fails wait a minute for each process that wants to run: a busy machine takes so many
    times longer."""
    milliseconds = 60_000 * max((1, *getattr(os, "getloadavg", tuple)()))
    expect.set_options(timeout=milliseconds)
    for context in browser.contexts:
        context.set_default_timeout(milliseconds)


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
# A page without a background of its own stands on the browser's, which the colour "Canvas" names.
CONTRAST_ON_PAGE = f"""element => {{
  document.documentElement.style.backgroundColor = "Canvas";
  return ({CONTRAST})(element);
}}"""


@contextmanager
def open_browser():
    with sync_playwright() as playwright:
        # Machines without a graphics card draw 3D in software, which Chromium wants to be asked
        # for.
        arguments = ["--no-sandbox", "--enable-unsafe-swiftshader"]
        browser = playwright.chromium.launch(
            executable_path=os.environ["BROWSER_PATH"], args=arguments
        )
        yield browser
        browser.close()


# Windows that no visit uses, of each browser. A new one starts a process that reads the first
# page's styles and scripts afresh, which takes as long as all else; so a visit that ends leaves its
# window, emptied, to the next one.
FREE_WINDOWS = WeakKeyDictionary()


class Visit:
    """A page that was opened offline, and what happened meanwhile."""

    def __init__(
        self, browser, file, *, theme="light", width=1280, query="", without=None, **context
    ):
        self.requests, self.complaints = [], []
        look = {
            "color_scheme": theme,
            "reduced_motion": "reduce",
        }  # else the theme glides to what is scrolled to
        size = {"width": width, "height": 844}
        self.free = FREE_WINDOWS.setdefault(browser, [])
        self.is_plain = not (without or context)
        if self.is_plain and self.free:
            self.page = self.free.pop()
            self.page.emulate_media(media="null", **look)
            self.page.set_viewport_size(size)
        else:
            self.page = browser.new_context(
                offline=True, viewport=size, **look, **context
            ).new_page()
        self.context = self.page.context
        be_patient(browser)
        self.listeners = {
            "request": lambda request: self.requests.append(request.url),
            "pageerror": lambda error: self.complaints.append(str(error)),
            "console": self._hear,
        }
        for event, listener in self.listeners.items():
            self.page.on(event, listener)
        if without:
            self.page.route(f"**/{without}*", lambda route: route.abort())
        if file:
            self.page.goto(file.as_uri() + query)

    def _hear(self, message):
        if message.type == "error":
            self.complaints.append(message.text)

    def __enter__(self):
        return self

    def __exit__(self, kind, *error):
        if not self.is_plain or kind:
            self.context.close()
            return
        for event, listener in self.listeners.items():
            self.page.remove_listener(event, listener)
        self.page.unroute_all()
        if self.page.url.startswith("file:"):
            self.page.evaluate("() => { localStorage.clear(); sessionStorage.clear(); }")
        self.page.goto("about:blank")
        self.free.append(self.page)

    @contextmanager
    def at_width(self, width):
        """The window is so many pixels wide for a while."""
        before = self.page.viewport_size
        self.page.set_viewport_size({**before, "width": width})
        try:
            yield
        finally:
            self.page.set_viewport_size(before)

    def draw_figures(self):
        """Scroll to each toy; return how many there are."""
        boxes = self.page.locator(".toy-figure").all()
        self.page.evaluate(
            OPEN.replace('"details"', '"section.more > details"')
        )  # what is folded is not near
        for box in boxes:
            box.scroll_into_view_if_needed()
            box.locator(".course-toy").first.wait_for()
        return len(boxes)


# Waits so many milliseconds of the page's own time, after what is begun is drawn; then what follows
# is drawn, too. A busy machine makes it longer and changes no order: in a page timers end as they
# are due.
SETTLED = """async (milliseconds) => {
  const drawn = () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done)));
  await drawn();
  await new Promise((done) => setTimeout(done, milliseconds));
  await drawn();
}"""

# How far what stood in the window jumped while the page was loaded (CLS).
SHIFT = """new Promise((done) => new PerformanceObserver((list) => done(list.getEntries().map((e) => e.value)))
  .observe({ type: "layout-shift", buffered: true }) || setTimeout(() => done([]), 500))
  .then((values) => values.reduce((sum, value) => sum + value, 0))"""

# Opens all that is folded shut, and waits until it has come up and has been measured.
OPEN = """async () => {
  document.querySelectorAll("details").forEach((part) => (part.open = true));
  await new Promise((done) => setTimeout(done, 100));
  const running = document.getAnimations().filter(({ timeline }) => timeline === document.timeline);
  await Promise.all(running.map((animation) => animation.finished));
}"""

# Runs in the page. Text is what is read as text: no code, no formula already set.
FACTS = r"""() => {
  const formulas = [...document.querySelectorAll(".math")];
  // A formula is there if it takes room, has its letters, and words for those who do not see it.
  const letters = (f) => [...f.querySelectorAll("use")].every((u) => document.querySelector(u.getAttribute("href")));
  const wide = (f) => f.querySelector("svg").getBoundingClientRect().width > 1;
  const isSet = (f) => wide(f) && letters(f) && f.querySelector("math");
  const text = (document.querySelector("article") ?? document.querySelector("main")).cloneNode(true);
  text.querySelectorAll("pre, code, script, .math, .toy-live").forEach((e) => e.remove());
  return {
    tex: text.textContent.match(/\$[^$]*\$|\\\(|\\\[|\\begin|\\frac/g) || [],
    unset: formulas.filter((f) => f.checkVisibility() && !isSet(f)).map((f) => f.outerHTML.slice(0, 200)),
    images: [...document.querySelectorAll("img")].map((i) => [
      i.complete && i.naturalWidth > 0, (i.closest("[role=img]")?.getAttribute("aria-label") ?? i.alt).trim()]),
    groups: [...document.querySelectorAll(".toy-figure")].map((f) => f.getAttribute("aria-label")),
    wide: [...document.querySelectorAll(".toy-figure, img")].filter((e) => e.scrollWidth > e.clientWidth).length,
    width: Math.max(document.documentElement.scrollWidth, document.body.scrollWidth),
    theme: document.documentElement.dataset.theme,
  };
}"""


def assert_readable(visit, notebook, width, rules=None):
    """Assert what holds for every page, and draw its live figures: those of the notebook, if there
    is one.

    rules: as `violations` takes them.
    """
    facts = visit.page.evaluate(FACTS)
    assert not facts["tex"]
    assert not facts["unset"]
    assert facts["width"] <= width
    assert not facts["wide"]
    for loaded, alt in facts["images"]:
        assert loaded
        assert alt
        assert not alt.endswith((".png", ".svg")), "Sphinx's stand-in for missing words"
    assert all(facts["groups"])
    assert visit.draw_figures() == len(facts["groups"])
    if notebook:
        outputs = [
            o for c in nbformat.read(notebook, as_version=4).cells for o in c.get("outputs", [])
        ]
        assert len(facts["groups"]) == sum(TOY in o.get("data", {}) for o in outputs)
    assert [url for url in visit.requests if not url.startswith(("file:", "data:", "blob:"))] == []
    assert violations(visit, rules=rules) == []
    assert visit.complaints == []
    return facts


# Contrast costs axe-core milliseconds for each text, and a page has ten thousand. So it looks at
# one text of each look: the same tags, classes, colours and sizes from the text up to the page. Of
# the words in code and in formulas, which no other rule looks at, the others are taken off the
# page, and so are the strokes of formulas.
ONE_OF_EACH_LOOK = """() => {
  document.querySelectorAll(".math > svg[aria-hidden=true]").forEach((svg) => svg.replaceChildren());
  document.querySelectorAll("[data-first-of-its-look]").forEach((e) => e.removeAttribute("data-first-of-its-look"));
  const numbers = new Map(), looks = new Map([[null, 0]]), seen = new Set(), first = [], again = [];
  const look = (e) => {
    if (!looks.has(e)) {
      const s = getComputedStyle(e), names = [...e.attributes].filter(({ name }) => name !== "href" && name !== "id");
      const words = [look(e.parentElement), e.tagName, ...names.map(({ name, value }) => name + value), s.color,
        s.backgroundColor, s.backgroundImage, s.fontSize, s.fontWeight, s.opacity, s.filter, s.position, s.textShadow]
        .join();
      if (!numbers.has(words)) numbers.set(words, numbers.size + 1);
      looks.set(e, numbers.get(words));
    }
    return looks.get(e);
  };
  const hasText = (e) => e.matches("input, select, textarea")
    || [...e.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.data.trim());
  for (const e of document.querySelectorAll("body, body *")) {
    if (!hasText(e) || !e.checkVisibility({ visibilityProperty: true })) continue;
    if (!seen.has(look(e))) first.push(e);
    else if (!e.childElementCount && e.matches("article pre span, article math *")) again.push(e);
    seen.add(look(e));
  }
  first.forEach((e) => e.setAttribute("data-first-of-its-look", ""));
  again.forEach((e) => e.replaceWith(e.textContent));  // afterwards, for each change costs the next look its styles
}"""
LOOKS_AT_THESE = (
    'axe.configure({ rules: [{ id: "color-contrast", selector: "[data-first-of-its-look]" }] });'
)


def violations(visit, within=None, rules=None):
    """Return the barriers that axe-core finds on a page, all that is folded shut opened, or within
    a selector.

    rules: the names of the rules to apply, or None for all. A whole page serves only for other
    searches afterwards.
    """
    if within is None:
        visit.page.evaluate(OPEN)
        visit.page.evaluate(ONE_OF_EACH_LOOK)
    # Without "preload", which would read the style sheets once more: a browser refuses that for
    # files, and says so.
    options = {"preload": False, "resultTypes": ["violations"]} | (
        {"runOnly": rules} if rules else {}
    )
    axe = Axe() if within else Axe(f"{AXE_SCRIPT};\n{LOOKS_AT_THESE}")
    found = axe.run(visit.page, context=within, options=options).response["violations"]
    return [
        (each["id"], node["target"], node["failureSummary"])
        for each in found
        for node in each["nodes"]
    ]
