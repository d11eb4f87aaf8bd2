"""The layout of pages: no horizontal scrolling, no shifts, no control without effect, nested headings."""

from itertools import pairwise
from pathlib import Path

import pytest
from bs4 import BeautifulSoup
from PIL import Image
from site_visits import OPEN, Visit, assert_readable

NOTEBOOKS = sorted((Path(__file__).parents[1] / "notebooks").glob("[0-9][0-9]_*.ipynb"))
PAGES = {"index": None, "errata": None, "sources": None, "notation": None, "search": None}
PAGES |= {"reports": None, "places": None, "changes": None}
PAGES |= {notebook.stem: notebook for notebook in NOTEBOOKS}
WIDE = """() => [...document.querySelectorAll("article :is(.math, pre, table, .output, .plotly-figure, .panels, img)")]
  .filter((e) => e.scrollWidth > e.clientWidth || e.getBoundingClientRect().right > innerWidth)
  .map((e) => `${e.scrollWidth} in ${e.clientWidth}: ${e.textContent.trim().slice(0, 80)}`)"""
WIDTH = "Math.max(document.documentElement.scrollWidth, document.body.scrollWidth)"
LEVELS = """() => [...document.querySelectorAll('h1, h2, h3, h4, h5, h6')]
  .filter((e) => e.getClientRects().length || e.closest("details")).map((e) => Number(e.localName[1]))"""


def only(course, name):
    (page,) = course.glob(f"{name}*.html")
    return page


@pytest.fixture(scope="module", params=PAGES)
def on_a_desktop(course, browser, request):
    """A page's name, the width of the window, and the visit to the page, in the light theme."""
    width = 1280 if PAGES[request.param] else 1000
    with Visit(browser, course / f"{request.param}.html", width=width) as visit:
        yield request.param, width, visit


def test_a_page_has_one_title_and_its_headings_skip_no_level(on_a_desktop):
    levels = on_a_desktop[2].page.evaluate(LEVELS)
    assert levels.count(1) == 1
    assert levels[0] == 1
    assert max((after - before for before, after in pairwise(levels)), default=0) <= 1


def test_no_page_is_wider_than_the_narrowest_phone(on_a_desktop):
    """320 pixels, as WCAG requires (reflow)."""
    visit = on_a_desktop[2]
    with visit.at_width(320):
        assert visit.page.evaluate(WIDTH) <= 320


def test_nothing_scrolls_sideways_at_1400_pixels(on_a_desktop):
    visit = on_a_desktop[2]
    visit.page.evaluate(OPEN)
    with visit.at_width(1400):
        assert visit.page.evaluate(WIDE) == []


def test_works_offline_on_a_desktop(on_a_desktop):
    name, width, visit = on_a_desktop
    assert_readable(visit, PAGES[name], width, draws=False)  # test_site_course.py draws them


def test_the_still_of_a_film_has_no_empty_margin_below(course):
    films = BeautifulSoup(only(course, "02").read_text("utf-8"), "html.parser").select(".plotly-figure[data-moves]")
    assert films
    for film in films:
        image = Image.open(course / film.select_one("img")["src"]).convert("L")
        ink = image.point(lambda dot: 255 * (dot < 250)).getbbox()
        assert image.height - ink[3] < 70, "no strip for buttons that are not there"


# ---- without JavaScript ----

PRESSED = "button:visible, [role=button]:visible, input:visible, select:visible"


@pytest.mark.parametrize("name", ["index", "02"])
def test_without_javascript_every_control_that_is_shown_works(course, browser, name):
    with Visit(browser, only(course, name), width=1280, java_script_enabled=False) as visit:
        link = visit.page.locator(".bd-sidebar-primary a", has_text="Errata")
        for width in (1280, 390):
            with visit.at_width(width):
                assert [each.evaluate("e => e.outerHTML") for each in visit.page.locator(PRESSED).all()] == []
                start, words = (visit.page.locator(f"article {tag}").first for tag in (":is(p, li) a", "p"))
                colours = [each.evaluate("e => getComputedStyle(e).color") for each in (start, words)]
                assert colours[0] != colours[1], "links are seen"
                assert link.is_visible(), "the other pages are in reach"
        link.click()
        assert "errata.html" in visit.page.url
