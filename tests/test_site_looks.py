"""How pages are laid out: nothing scrolls sideways on a desktop, nothing jumps, nothing is dead, headings nest."""

from itertools import pairwise

import pytest
from bs4 import BeautifulSoup
from PIL import Image
from site_visits import OPEN, Visit

PAGES = ["index", "errata", "sources", "notation", "search", *(f"0{n}_" for n in range(1, 7))]
WIDE = """() => [...document.querySelectorAll("article :is(.math, pre, table, .output, .plotly-figure, .panels, img)")]
  .filter((e) => e.scrollWidth > e.clientWidth || e.getBoundingClientRect().right > innerWidth)
  .map((e) => `${e.scrollWidth} in ${e.clientWidth}: ${e.textContent.trim().slice(0, 80)}`)"""


def only(course, name):
    (page,) = course.glob(f"{name}*.html")
    return page


@pytest.mark.parametrize("name", PAGES)
def test_nothing_scrolls_sideways_at_1400_pixels(course, browser, name):
    with Visit(browser, only(course, name), width=1400) as visit:
        visit.page.evaluate(OPEN)
        assert visit.page.evaluate(WIDE) == []


@pytest.mark.parametrize("name", PAGES)
def test_a_page_has_one_title_and_its_headings_leave_out_no_level(course, name):
    soup = BeautifulSoup(only(course, name).read_text("utf-8"), "html.parser")
    levels = [int(heading.name[1]) for heading in soup.select("h1, h2, h3, h4, h5, h6")]
    assert levels.count(1) == 1
    assert levels[0] == 1
    assert max((after - before for before, after in pairwise(levels)), default=0) <= 1


# ---- nothing jumps ----

HEIGHTS = "() => [...document.querySelectorAll('.plotly-figure')].map((box) => box.getBoundingClientRect().height)"
RESERVED = """() => [...document.querySelectorAll(".plotly-figure")]
  .every((box) => box.classList.contains("drawn") || box.style.minHeight)"""


@pytest.mark.parametrize("width", [390, 1400])
def test_a_live_figure_takes_the_room_that_was_kept_for_it(course, browser, width):
    with Visit(browser, only(course, "02"), width=width) as visit:
        visit.page.wait_for_function(RESERVED)
        before = visit.page.evaluate(HEIGHTS)
        assert len(before) > 5
        for box, height in zip(visit.page.locator(".plotly-figure").all(), before, strict=True):
            box.scroll_into_view_if_needed()
            box.locator(".main-svg, .course-toy").first.wait_for()
            visit.page.wait_for_function(
                "([box, height]) => !box.style.minHeight && Math.abs(box.getBoundingClientRect().height - height) < 2",
                arg=[box.element_handle(), height],
            )
        assert visit.complaints == []


def test_the_still_of_a_film_ends_where_the_picture_ends(course):
    for name, kind in (("02", ""), ("04", "film"), ("05", "film")):
        soup = BeautifulSoup(only(course, name).read_text("utf-8"), "html.parser")
        films = soup.select(".plotly-figure[data-moves]")
        assert films
        for film in films:
            assert film.get("data-kind", "") == kind
            image = Image.open(course / film.select_one("img")["src"]).convert("L")
            ink = image.point(lambda dot: 255 * (dot < 250)).getbbox()
            assert image.height - ink[3] < 70, "no strip for buttons that are not there"


def test_the_pictures_on_the_cards_fill_their_frames(course):
    soup = BeautifulSoup(only(course, "index").read_text("utf-8"), "html.parser")
    covers = soup.select(".card img")
    assert len(covers) == 6
    for cover in covers:
        image = Image.open(course / cover["src"]).convert("L")
        left, top, right, bottom = image.point(lambda dot: 255 * (dot < 250)).getbbox()
        assert right - left > 0.85 * image.width, cover["alt"]
        assert bottom - top > 0.85 * image.height, cover["alt"]


# ---- without JavaScript ----

PRESSED = "button:visible, [role=button]:visible, input:visible, select:visible"


@pytest.mark.parametrize("width", [390, 1280])
@pytest.mark.parametrize("name", ["index", "02"])
def test_without_javascript_nothing_can_be_pressed_in_vain(course, browser, name, width):
    with Visit(browser, only(course, name), width=width, java_script_enabled=False) as visit:
        assert [each.evaluate("e => e.outerHTML") for each in visit.page.locator(PRESSED).all()] == []
        start, words = (visit.page.locator(f"article {tag}").first for tag in (":is(p, li) a", "p"))
        colours = [each.evaluate("e => getComputedStyle(e).color") for each in (start, words)]
        assert colours[0] != colours[1], "links are seen"
        link = visit.page.locator(".bd-sidebar-primary a", has_text="Errata")
        assert link.is_visible(), "the other pages are in reach"
        link.click()
        assert "errata.html" in visit.page.url
