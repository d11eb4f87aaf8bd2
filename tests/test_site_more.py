"""Folded sections of More on a page, with the appendix of a report among them."""

import pytest
from nbformat.v4 import new_markdown_cell
from playwright.sync_api import expect
from site_notebooks import NBGRADER, SLIDING, SOLUTION, cell, output, png, write
from site_visits import Visit, assert_readable
from sphinx_builds import build

from course_lib.figures.display import TOY

TITLE, PROMISE = "More: rotations at random", "You draw them uniformly, $R^\\top R = I$. 40 minutes."


def more(text):
    return new_markdown_cell(text, metadata={"tags": ["more"]})


@pytest.fixture(scope="module")
def notebooks(tmp_path_factory):
    folder = tmp_path_factory.mktemp("more") / "notebooks"
    write(
        folder,
        "01_rotations.ipynb",
        new_markdown_cell("# Rotations\n\nA drone grows. It takes about three hours."),
        cell(source="import numpy as np"),
        cell(output({"image/png": png()}, "A rising line"), source="x = 2\nprint(x)\ndraw(x)", tags=["cover"]),
        new_markdown_cell("Words of the core. See [the numbers](#Reproduce)."),
        more(f"## {TITLE}\n\n{PROMISE}"),
        new_markdown_cell("Haar's measure.\n\n### Three angles\n\nThey are not uniform."),
        cell(source=SOLUTION, nbgrader=NBGRADER),
        cell(output({TOY: SLIDING, "image/png": png()}, "Two poses on a floor")),
        more("## Appendix: the report\n\nWhat it did."),
        new_markdown_cell("### What it is\n\nA homework report.\n\n### Reproduce\n\nAll digits agree."),
    )
    plain = "# Rigid motion\n\n[There](01_rotations.ipynb#Reproduce)."
    write(folder, "02_rigid_motion.ipynb", new_markdown_cell(plain))
    return folder


@pytest.fixture(scope="module")
def site(notebooks):
    build(notebooks, notebooks.parent / "html")
    return notebooks.parent / "html"


@pytest.fixture
def visit(site, browser):
    with Visit(browser, site / "01_rotations.html", width=390, theme="dark") as visit:
        yield visit


def test_a_section_is_a_line_with_its_heading_and_its_promise_that_the_keyboard_opens(visit, notebooks):
    page = visit.page
    line, inside = page.locator("summary.more").first, page.get_by_text("Haar")
    expect(line.locator("h2")).to_contain_text(TITLE)
    expect(line.locator(".promise")).to_contain_text("40 minutes")
    expect(line.locator(".promise .math")).to_be_visible()
    expect(inside).not_to_be_visible()
    assert page.locator("summary.more").count() == 2
    assert page.locator("details details summary", has_text="Solution").count() == 1
    line.focus()
    page.keyboard.press("Enter")
    expect(inside).to_be_visible()
    expect(page.get_by_text("All digits agree")).not_to_be_visible()
    assert_readable(visit, notebooks / "01_rotations.ipynb", 390)


def test_a_link_into_a_section_opens_it_at_once_and_a_second_time(visit, site):
    page, there = visit.page, visit.page.get_by_text("All digits agree")
    for _ in range(2):
        page.get_by_role("link", name="the numbers").click()
        expect(there).to_be_in_viewport()
        page.locator("summary.more").nth(1).press("Enter")
        expect(there).not_to_be_visible()
    page.goto((site / "02_rigid_motion.html").as_uri())
    page.get_by_role("link", name="There").click()
    expect(there).to_be_in_viewport()


def test_a_hit_of_the_search_opens_the_section_and_the_answer_inside(site, browser):
    with Visit(browser, site / "search.html", query="?q=gooseberry") as visit:
        visit.page.locator("#search-results a").first.click()
        expect(visit.page.locator("details details .highlighted")).to_be_in_viewport()


def test_a_figure_in_a_section_has_its_place_once_it_is_open(visit):
    box = visit.page.locator(".toy-figure")
    visit.page.locator("summary.more").first.click()
    box.scroll_into_view_if_needed()
    expect(box.locator(".course-toy")).to_be_visible()
    assert box.bounding_box()["height"] > 300


def test_paper_shows_what_is_folded_but_imports(visit):
    page = visit.page
    page.emulate_media(media="print")
    for words in ("Haar", "All digits agree"):
        expect(page.get_by_text(words)).to_be_visible()
    expect(page.get_by_text("gooseberry")).to_be_visible()
    expect(page.locator(".tag_not-on-paper summary").first).not_to_be_visible()
    page.emulate_media(media="null")
    expect(page.get_by_text("Haar")).not_to_be_visible()


def test_the_first_screen_shows_the_figure_before_the_words(visit):
    tops = [
        visit.page.locator(part).first.bounding_box()["y"]
        for part in ("article h1", "article img", "p:has-text('core')")
    ]
    assert tops == sorted(tops)
    assert tops[1] < 600
    folded = [line.strip() for line in visit.page.locator("details.hide > summary").all_inner_texts()]
    assert folded[:2] == ["Imports and settings", "The lines that draw it"]
