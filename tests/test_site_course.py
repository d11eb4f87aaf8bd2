"""The whole course as a site: every page and every figure, in a browser with the network off."""

import re
from pathlib import Path
from urllib.parse import unquote

import pytest
from bs4 import BeautifulSoup
from playwright.sync_api import expect
from site_visits import OPEN, Visit, assert_readable

NOTEBOOKS = sorted((Path(__file__).parents[1] / "notebooks").glob("[0-9][0-9]_*.ipynb"))

# Whatever can be pressed, chosen or typed into, and can be seen.
CONTROLS = """() => [...document.querySelectorAll("a[href], button, input, summary, [tabindex='0']")]
  .filter((e) => e.checkVisibility({ visibilityProperty: true }) && !e.closest(".plotly-figure"))"""


LOOKS = {"phone": (390, "dark"), "desktop": (1280, "light")}


PAGES = [(notebook, look) for notebook in NOTEBOOKS for look in LOOKS]
# Drawing a page's figures takes ten seconds. On a phone, where room is scarce, all are drawn; on a desktop one page's.
DRAWN = [(notebook, look) for notebook, look in PAGES if look == "phone" or notebook == NOTEBOOKS[1]]


def each_of(pages):
    ids = [f"{notebook.stem}-{look}" for notebook, look in pages]
    return pytest.mark.parametrize("page", pages, ids=ids, indirect=True, scope="module")


@pytest.fixture(scope="module")
def page(course, browser, request):
    """A notebook, how it is looked at, and the visit to the notebook's page."""
    notebook, look = request.param
    width, theme = LOOKS[look]
    with Visit(browser, course / f"{notebook.stem}.html", theme=theme, width=width) as visit:
        yield notebook, look, visit


@each_of(DRAWN)
def test_play_moves_every_figure_that_has_frames(page):
    def plays(box):
        live, button = box.locator(".plotly-live"), box.locator(".plotly-player button")
        if not button.count():
            return
        drawn = "live => JSON.stringify(live.data.map((trace) => [trace.x, trace.y, trace.z]))"
        before = live.evaluate(drawn)
        button.click()
        visit.page.wait_for_function(
            f"([live, before]) => ({drawn})(live) !== before", arg=[live.element_handle(), before]
        )
        if button.inner_text() == "Pause":
            button.click()

    _, _, visit = page
    visit.draw_figures(plays)
    assert visit.complaints == []


@each_of(PAGES)
def test_works_offline(page):
    notebook, look, visit = page
    assert_readable(visit, notebook, LOOKS[look][0], draws=(notebook, look) in DRAWN)


def test_is_small_and_holds_each_library_once(course):
    files = [file for file in course.rglob("*") if file.is_file()]
    assert sum(file.stat().st_size for file in files) < 12e6
    assert len(list(course.rglob("plotly*.js"))) == 1
    assert not list(course.rglob("mathjax*.js")) + list(course.rglob("*.woff2"))
    assert not [file for file in files if file.suffix in (".map", ".po", ".mo")]


def test_every_link_leads_somewhere(course):
    pages = {page.name: BeautifulSoup(page.read_text("utf-8"), "html.parser") for page in course.glob("*.html")}
    anchors = {name: {e["id"] for e in soup.select("[id]")} | {""} for name, soup in pages.items()}
    count = 0
    for name, soup in pages.items():
        for element in soup.select("[href], [src]"):
            link = unquote(element.get("href", element.get("src")))
            if re.match("https://|data:", link):
                continue
            file, _, anchor = link.partition("#")
            file = file.split("?")[0] or name
            assert (course / file).is_file(), f"{name}: {link}"
            assert anchor == "" or anchor in anchors[file], f"{name}: {link}"
            count += 1
    assert count > 500
    assert {"index.html", "errata.html", "sources.html", "notation.html"} < set(pages)


def test_the_keyboard_alone_reaches_everything(course, browser):
    with Visit(browser, course / "03_subproblems_damped_ik.html") as visit:
        visit.page.evaluate(OPEN)
        wanted = visit.page.evaluate(f"({CONTROLS})().map((e, i) => (e.dataset.wanted = i))")
        assert len(wanted) > 60
        reached = set()
        for _ in range(2 * len(wanted)):
            visit.page.keyboard.press("Tab")
            reached.add(visit.page.evaluate("document.activeElement.dataset.wanted"))
            if reached.issuperset(map(str, wanted)):
                break
        missed = (
            "(numbers) => numbers.map((i) => document.querySelector(`[data-wanted='${i}']`).outerHTML.slice(0, 200))"
        )
        assert visit.page.evaluate(missed, [number for number in wanted if str(number) not in reached]) == []


@pytest.mark.parametrize(("word", "page"), [("adjoint", "Product of exponentials"), ("quaternion", "Rotations")])
def test_search_finds(course, browser, word, page):
    with Visit(browser, course / "search.html", query=f"?q={word}") as visit:
        link = visit.page.locator("#search-results a", has_text=page).first
        link.click()
        visit.page.locator("article mark").first.wait_for()
        assert page in visit.page.title()
        assert visit.complaints == []


def weight(course, page):
    """The bytes of a page and of all that it loads, at once or as the reader comes near; and the files' names."""
    soup = BeautifulSoup((course / page).read_text("utf-8"), "html.parser")
    found = [e.get("src") or e.get("href") for e in soup.select("script[src], link[rel=stylesheet], img[src]")]
    files = [page, *(link.split("?")[0] for link in found)]
    if soup.select(".plotly-figure:not([data-without-plotly])"):
        files.append("_static/plotly.packed.js")
    return sum((course / file).stat().st_size for file in files), files


def test_pages_are_light(course):
    for notebook in NOTEBOOKS:
        size, files = weight(course, f"{notebook.stem}.html")
        assert size < 4.5e6, notebook.stem
        assert len([file for file in files if "plotly" in file]) <= 1, "none of those loaded at once"
    for page in ("index", "errata", "sources", "notation"):
        size, files = weight(course, f"{page}.html")
        assert size < 1.5e6, page
        assert not [file for file in files if "plotly" in file]


def test_plotly_is_fetched_when_a_figure_comes_near_and_the_still_stands_until_it_is_there(course, browser):
    with Visit(browser, None) as visit:
        held = []
        visit.page.route("**/plotly.packed.js*", lambda route: held.append(route))
        visit.page.goto((course / "04_poe_kuka_iiwa.html").as_uri())  # a file's page takes no routes afterwards
        expect(visit.page.get_by_text("When you are through, you can")).to_be_visible()
        visit.page.wait_for_load_state()
        assert not [url for url in visit.requests if "plotly" in url]
        box = visit.page.locator(".plotly-figure:not([data-without-plotly])").first
        with visit.page.expect_request("**/plotly.packed.js*"):
            box.scroll_into_view_if_needed()
        expect(box.locator(".plotly-still")).to_be_visible()
        assert visit.page.evaluate("typeof Plotly") == "undefined"
        held[0].continue_()
        expect(box.locator(".main-svg").first).to_be_visible()
        assert visit.complaints == []
