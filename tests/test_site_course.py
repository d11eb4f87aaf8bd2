"""The whole course as a site: every page and every figure, in a browser without a network.

Each page is opened once, on a phone in the dark. A page of each kind is later made as wide as a
desktop, in the light.
"""

import re
from itertools import pairwise
from pathlib import Path
from urllib.parse import quote_plus, unquote

import pytest
from bs4 import BeautifulSoup
from playwright.sync_api import expect
from site_visits import OPEN, SETTLED, SHIFT, Visit, assert_readable, violations

from course_lib.pack.site.sources import ADDRESSES

FIRST, *OTHERS = sorted((Path(__file__).parents[1] / "notebooks").glob("[0-9][0-9]_*.ipynb"))
NOTEBOOKS = [
    *OTHERS,
    FIRST,
]  # the second one first: pytest then tests the keyboard on it while it is open
PAGES = {notebook.stem: notebook for notebook in NOTEBOOKS}
PAGES |= dict.fromkeys(
    (
        *("index", "ten_minutes", "errata", "sources", "notation", "search"),
        *("reports", "places", "changes", "guide", "semester"),
    )
)
PLAIN = ("index", "errata", "sources", "notation")
PHONE, DESKTOP = 390, 1400

# Whatever can be pressed, chosen or typed into, and can be seen.
CONTROLS = """() => [...document.querySelectorAll("a[href], button, input, summary, [tabindex='0']")]
  .filter((e) => e.checkVisibility({ visibilityProperty: true }) && !e.closest(".toy-figure"))"""
WIDE = """() => [...document.querySelectorAll("article :is(.math, pre, table, .output, .toy-figure, .panels, img)")]
  .filter((e) => e.scrollWidth > e.clientWidth || e.getBoundingClientRect().right > innerWidth)
  .map((e) => `${e.scrollWidth} in ${e.clientWidth}: ${e.textContent.trim().slice(0, 80)}`)"""
WIDTH = "Math.max(document.documentElement.scrollWidth, document.body.scrollWidth)"
LEVELS = """() => [...document.querySelectorAll('h1, h2, h3, h4, h5, h6')]
  .filter((e) => e.getClientRects().length || e.closest("details")).map((e) => Number(e.localName[1]))"""


@pytest.fixture(scope="module", params=PAGES)
def visit(course, browser, request):
    """The visit to a page on a phone, in the dark theme; its `notebook` is None for the pages that
    have none."""
    with Visit(browser, course / f"{request.param}.html", theme="dark", width=PHONE) as visit:
        visit.notebook = PAGES[request.param]
        yield visit


of_a_notebook = pytest.mark.parametrize(
    "visit", [notebook.stem for notebook in NOTEBOOKS], indirect=True
)


TOYS_DRAWN = """() => [...document.querySelectorAll('.toy-figure:not(.drawn)')]
  .every((toy) => !toy.checkVisibility())"""


def test_nothing_jumps_while_a_page_is_loaded(visit):
    visit.page.wait_for_load_state()
    visit.page.wait_for_function(TOYS_DRAWN)
    assert visit.page.evaluate(SHIFT) < 0.1


def test_a_page_has_one_title_and_its_headings_skip_no_level(visit):
    levels = visit.page.evaluate(LEVELS)
    assert levels.count(1) == 1
    assert levels[0] == 1
    assert max((after - before for before, after in pairwise(levels)), default=0) <= 1


def test_no_page_is_wider_than_the_narrowest_phone(visit):
    """320 pixels, as WCAG requires (reflow)."""
    with visit.at_width(320):
        assert visit.page.evaluate(WIDTH) <= 320


@of_a_notebook
def test_every_panel_is_large_enough_to_read_on_a_phone(visit):
    panels = visit.page.locator(".panels > .panel").all()
    size = 'e => [e.getBoundingClientRect().right, e.clientWidth / e.getAttribute("width")]'
    sizes = [panel.evaluate(size) for panel in panels]
    # The panels of these notebooks are those of charts and toys, which a phone shows one below the
    # other.
    assert panels or visit.notebook.stem in ("05_panda_dh_ik", "06_decomposition_ik")
    assert all(right <= PHONE and scale > 0.6 for right, scale in sizes), (
        sizes
    )  # letters of 13 pixels become 8


@pytest.mark.parametrize("visit", [NOTEBOOKS[0].stem], indirect=True)
def test_the_keyboard_alone_reaches_everything(visit):
    page = visit.page
    page.set_viewport_size({"width": DESKTOP, "height": 844})
    page.evaluate(OPEN)
    wanted = page.evaluate(f"({CONTROLS})().map((e, i) => (e.dataset.wanted = i))")
    assert len(wanted) > 60
    reached = set()
    for _ in range(2 * len(wanted)):
        page.keyboard.press("Tab")
        reached.add(page.evaluate("document.activeElement.dataset.wanted"))
        if reached.issuperset(map(str, wanted)):
            break
    missed = (
        "(numbers) => numbers.map((i) => "
        "document.querySelector(`[data-wanted='${i}']`).outerHTML.slice(0, 200))"
    )
    assert page.evaluate(missed, [number for number in wanted if str(number) not in reached]) == []
    page.set_viewport_size({"width": PHONE, "height": 844})


def test_works_offline_on_a_phone(visit):
    # What differs on a phone in the dark: on a desktop all rules are applied.
    assert_readable(
        visit, visit.notebook, PHONE, rules=["color-contrast", "scrollable-region-focusable"]
    )


# A page of each kind. The rules of the style, of which all pages are made, hold for the others too.
OF_EACH_KIND = (NOTEBOOKS[0].stem, "index", "errata", "notation", "search", "reports")


@pytest.mark.parametrize("visit", OF_EACH_KIND, indirect=True)
def test_works_on_a_desktop_in_the_light(visit):
    visit.page.evaluate("document.documentElement.dataset.theme = 'light'")
    visit.page.set_viewport_size({"width": DESKTOP, "height": 844})
    assert visit.page.evaluate(WIDE) == []
    width = DESKTOP if visit.notebook else 1000
    visit.page.set_viewport_size({"width": width, "height": 844})
    assert visit.page.evaluate(WIDTH) <= width
    visit.page.evaluate(
        SETTLED, 1000
    )  # for the theme lets keys reach what scrolls, a moment after a resize
    assert violations(visit) == []
    assert visit.complaints == []


def test_the_site_is_small_and_contains_each_library_once(course):
    files = [file for file in course.rglob("*") if file.is_file()]
    # Five megabytes are plotly's script, which stands in the site once, four the charts' numbers,
    # and three the zip for students.
    assert sum(file.stat().st_size for file in files) < 24e6
    assert not list(course.rglob("mathjax*.js")) + list(course.rglob("*.woff2"))
    assert not [file for file in files if file.suffix in (".map", ".po", ".mo")]


# What a page's file holds, before any script runs.
PARSED = """(text) => {
  const page = new DOMParser().parseFromString(text, "text/html");
  const all = (selector, fact) => [...new Set([...page.querySelectorAll(selector)].map(fact))];
  const link = (e) => e.getAttribute("href") ?? e.getAttribute("src");
  return {
    ids: all("[id]", (e) => e.id),
    links: all("[href], [src]", link),
    loaded: all("script[src], link[rel=stylesheet], img[src]", link),
  };
}"""


@pytest.fixture(scope="module")
def parsed(course, browser):
    """The name of each page, and the contents of its file."""
    with Visit(browser, None) as visit:
        return {
            file.name: visit.page.evaluate(PARSED, file.read_text("utf-8"))
            for file in course.glob("*.html")
        }


def test_every_column_of_a_table_has_a_name(course):
    count = 0
    for file in course.glob("*.html"):
        for head in BeautifulSoup(file.read_text("utf-8"), "html.parser").select("thead th"):
            # Above the names of rows pandas leaves a corner empty.
            if not head.find_parent(class_="dataframe"):
                assert head.get_text(strip=True), f"{file.name}: {head.parent}"
                count += 1
    assert count > 30


def test_the_page_after_the_last_notebook_is_the_next_one(course):
    page = BeautifulSoup((course / f"{OTHERS[-1].stem}.html").read_text("utf-8"), "html.parser")
    assert page.select_one(".prev-next-area .right-next")["href"] == "reports.html"


def test_sections_and_notebooks_that_a_text_names_are_links(course):
    for notebook in (FIRST, *OTHERS):
        page = BeautifulSoup((course / f"{notebook.stem}.html").read_text("utf-8"), "html.parser")
        named = [link for link in page.select("article a") if link.em and "#" in link["href"]]
        assert len(named) >= 5, notebook.stem
    semester = BeautifulSoup((course / "semester.html").read_text("utf-8"), "html.parser")
    assert len(semester.select("td a:has(em)")) >= 10


def test_each_known_source_is_a_link(course):
    page = BeautifulSoup((course / "sources.html").read_text("utf-8"), "html.parser")
    links = {link.get_text(): link["href"] for link in page.select("article li a[href^=https]")}
    missing = [words for words, address in ADDRESSES.items() if links.get(words) != address]
    assert missing == [], "a source that no notebook names in these words any more"


def test_every_figure_and_every_equation_has_a_number_of_its_own(course):
    for number, notebook in enumerate((FIRST, *OTHERS), 1):
        page = BeautifulSoup((course / f"{notebook.stem}.html").read_text("utf-8"), "html.parser")
        captions = [part.get_text() for part in page.select("figure[id] .figure-number")]
        assert captions == [f"Figure {number}.{k}." for k in range(1, len(captions) + 1)]
        assert len(captions) == len(page.select("figcaption")) > 10
        equations = [part.get_text() for part in page.select(".equation[id] .equation-number")]
        assert equations == [f"({number}.{k})" for k in range(1, len(equations) + 1)]
        assert len(equations) > 4


def test_every_link_leads_somewhere(course, parsed):
    count = 0
    for name, page in parsed.items():
        for link in map(unquote, page["links"]):
            if re.match("https://|data:", link):
                continue
            file, _, anchor = link.partition("#")
            file = file.split("?")[0] or name
            assert (course / file).is_file(), f"{name}: {link}"
            assert anchor == "" or anchor in parsed[file]["ids"], f"{name}: {link}"
            count += 1
    assert count > 500
    assert {"index.html", "errata.html", "sources.html", "notation.html"} < set(parsed)


@pytest.mark.parametrize(
    ("words", "page"),
    [  # a word, a symbol, a number, and two words
        ("quaternion", "Rotations"),
        ("θ", "Rigid motion"),
        ("50,000", "decomposition"),
        ("rotation matrices", "Rotations"),
    ],
)
def test_the_search_leads_to_the_marked_words(course, browser, words, page):
    with Visit(browser, course / "search.html", query=f"?q={quote_plus(words)}") as visit:
        assert visit.page.title() == "Search — Robot kinematics"
        first = visit.page.locator("#search-results a").first
        expect(first).to_contain_text(page)
        with visit.at_width(320):
            assert visit.page.evaluate("document.documentElement.scrollWidth") <= 320
        assert violations(visit) == []
        first.click()
        expect(visit.page.locator("article .highlighted").first).to_be_visible()
        visit.page.wait_for_function(MARK_IN_VIEW)
        assert page in visit.page.title()
        assert visit.complaints == []


# Of the words that are marked, some are in the window.
MARK_IN_VIEW = """() => [...document.querySelectorAll("article .highlighted")].some((mark) => {
  const { top, bottom, height } = mark.getBoundingClientRect();
  return height > 0 && top >= 0 && bottom <= innerHeight;
})"""


def search(visit, words):
    """Search for words, from the page of an earlier search."""
    visit.page.goto(f"{visit.page.url.split('?')[0]}?q={quote_plus(words)}")


FIRST_FOUND = {
    "adjoint": "Product of exponentials",
    "SO(3)": "Rotations",
    "0.1222": "decomposition",
    "1.301": "Product of exponentials",
    "50000": "decomposition",
}


def test_the_search_marks_the_words_in_its_list(course, browser):
    with Visit(browser, course / "search.html") as visit:
        for words, page in FIRST_FOUND.items():
            search(visit, words)
            expect(visit.page.locator("#search-results a").first).to_contain_text(page)
            expect(visit.page.locator("#search-results li mark").first).to_be_visible()


def found_pages(visit, words):
    """The pages of the sections that the search lists."""
    search(visit, words)
    links = visit.page.locator("#search-results a").all()
    return {
        Path(unquote(link.get_attribute("href")).split("?")[0].split("#")[0]).stem for link in links
    }


def test_the_search_lists_only_pages_that_hold_the_word(course, browser):
    with Visit(browser, course / "search.html") as visit:
        for word in ("manipulability", "quaternion", "adjoint"):
            pages = found_pages(visit, word)
            assert pages, word
            for page in pages:
                assert word in (course / f"{page}.html").read_text("utf-8").lower(), page


def test_pages_are_light(course, parsed):
    for pages, most in ([notebook.stem for notebook in NOTEBOOKS], 4.5e6), (PLAIN, 1.5e6):
        for page in pages:
            files = [
                f"{page}.html",
                *(link.split("?")[0] for link in parsed[f"{page}.html"]["loaded"]),
            ]
            assert sum((course / file).stat().st_size for file in files) < most, page


# ---- without JavaScript ----

PRESSED = "button:visible, [role=button]:visible, input:visible, select:visible"


@pytest.mark.parametrize("name", ["index", "02_rigid_motion"])
def test_without_javascript_every_control_that_is_shown_works(course, browser, name):
    with Visit(browser, course / f"{name}.html", width=1280, java_script_enabled=False) as visit:
        link = visit.page.locator(".bd-sidebar-primary a", has_text="Errata")
        for width in (1280, 390):
            with visit.at_width(width):
                assert [
                    each.evaluate("e => e.outerHTML") for each in visit.page.locator(PRESSED).all()
                ] == []
                start, words = (
                    visit.page.locator(f"article {tag}").first for tag in (":is(p, li) a", "p")
                )
                colours = [
                    each.evaluate("e => getComputedStyle(e).color") for each in (start, words)
                ]
                assert colours[0] != colours[1], "links are seen"
                assert link.is_visible(), "the other pages are in reach"
        link.click()
        assert "errata.html" in visit.page.url
