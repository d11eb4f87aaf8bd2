"""The pages that are compiled from the notebooks: home, errata, sources."""

import re
from contextlib import ExitStack
from functools import cache
from itertools import pairwise, zip_longest
from pathlib import Path

import nbformat
import pytest
from bs4 import BeautifulSoup
from site_notebooks import PLOTLY
from site_visits import Visit, assert_readable

from course_lib.pack.more import heading_level

NOTEBOOKS = sorted((Path(__file__).parents[1] / "notebooks").glob("[0-9][0-9]_*.ipynb"))
PAGES = ("index", "errata", "sources")


def first_cell(notebook):
    return nbformat.read(notebook, 4).cells[0].source


def words(text):
    """Only the words: a page shows quotes in other signs."""
    return " ".join(re.findall(r"\w+", text))


@pytest.fixture(scope="module")
def on_a_phone(course, browser):
    """A function that gives the visit to a page on a phone, in the dark theme; each page is opened once."""
    with ExitStack() as visits:
        yield cache(lambda page: visits.enter_context(Visit(browser, course / f"{page}.html", theme="dark", width=390)))


def test_the_home_page_states_the_question_and_the_duration_of_each_notebook(on_a_phone):
    page = on_a_phone("index").page
    article = page.locator("article")
    text = " ".join(article.inner_text().split())
    assert article.locator(".first-steps a").count() == 4
    hours = []
    for notebook in NOTEBOOKS:
        said = first_cell(notebook)
        title = re.match("# (.*)", said)[1]
        assert article.locator(f"h2 a[href='{notebook.stem}.html']").inner_text() == title
        card = article.locator(".card", has=page.locator(f"a[href='{notebook.stem}.html']")).inner_text()
        question = words(card.replace(title, "").replace("#", "")).split(" About ")[0]
        assert len(question) > 20
        assert "?" in card
        hours.append(float(re.search(r"About ([\d.]+) hours\.", card)[1]))
    assert f"about {sum(hours):g} hours" in text
    assert "rotate_point not right yet" in words(article.inner_text()), "what a check says"
    assert page.locator("meta[name=description]").count() == 1
    for name in ("reports", "notation", "places", "changes", "errata", "sources"):
        assert article.locator(f"li a[href='{name}.html']").count() >= 1


def test_the_home_page_shows_a_picture_of_each_notebook_from_the_tagged_cell(on_a_phone):
    shown = [image.get_attribute("alt") for image in on_a_phone("index").page.locator(".card img").all()]
    assert len(shown) == len(NOTEBOOKS)
    for notebook, alt in zip(NOTEBOOKS, shown, strict=True):
        cells = [cell for cell in nbformat.read(notebook, 4).cells if "cover" in cell.metadata.get("tags", [])]
        assert len(cells) == 1
        stored = next(output for output in cells[0].outputs if "image/png" in output.get("data", {}))
        assert alt in " ".join(stored.metadata["image/png"]["alt"].split())


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda notebook: notebook.stem)
def test_every_figure_has_a_caption(notebook):
    bare, count = [], 0
    for number, cell in enumerate(nbformat.read(notebook, 4).cells, 1):
        outputs = cell.get("outputs", [])
        for output, following in zip_longest(outputs, outputs[1:], fillvalue={}):
            if {PLOTLY, "image/png", "image/svg+xml"} & set(output.get("data", {})):
                count += 1
                if not following.get("metadata", {}).get("caption", output.metadata.get("caption", "")).strip():
                    bare.append(f"cell {number}: {cell.source[:60]}")
    assert count > 8
    assert bare == []


def section(notebook, heading):
    """The cells from a heading to the next one of its or a higher level; empty if it is not there."""
    found, inside = [], False
    for cell in nbformat.read(notebook, 4).cells:
        if level := heading_level(cell):
            inside = cell.source.startswith(heading) or (inside and level > heading_level(found[0]))
        if inside:
            found.append(cell)
    return found


ERRATA = ("### Errors in it", "### Remarks")


def test_errata_contain_every_claim_with_its_evidence_and_the_correction(on_a_phone):
    article = on_a_phone("errata").page.locator("article")
    printed = ["".join(text.split()) for text in article.locator(".output.stream").all_text_contents()]
    assert article.locator("details").count() == len(printed)
    assert article.locator("details[open]").count() == 0
    strong = [text.strip() for text in article.locator("strong").all_inner_texts()]
    cells = [cell for heading in ERRATA for notebook in NOTEBOOKS for cell in section(notebook, heading)]
    text = "\n".join(cell.source for cell in cells if cell.cell_type == "markdown")
    shown, titles = words(article.text_content()), re.findall(r"^(?:#### |\*\*\d)(.*)", text, re.MULTILINE)
    assert len(titles) >= len(NOTEBOOKS)
    assert [title for title in titles if words(re.split(r"[$*]", title)[0]) not in shown] == []
    for word in ("Printed", "Evidence", "Right"):
        assert sum(each.startswith(word) for each in strong) == text.count(f"**{word}"), word
    outputs = [output for cell in cells for output in cell.get("outputs", []) if output.output_type == "stream"]
    assert sorted(printed) == sorted("".join(output.text.split()) for output in outputs)


def test_errata_name_their_notebooks_in_headings_that_skip_no_level(course):
    article = BeautifulSoup((course / "errata.html").read_text("utf-8"), "html.parser").find("article")
    into = {link["href"] for link in article.select("h3 a[href]")}
    assert {f"{notebook.stem}.html" for notebook in NOTEBOOKS if section(notebook, ERRATA[0])} <= into
    levels = [int(heading.name[1]) for heading in article.select("h1, h2, h3, h4")]
    assert levels[0] == 1
    assert max(after - before for before, after in pairwise(levels)) == 1, "no level is left out"


def test_each_report_has_its_picture_and_a_link_to_the_cells_that_compute_its_numbers(course):
    article = BeautifulSoup((course / "reports.html").read_text("utf-8"), "html.parser").find("article")
    parts = article.select("section section")
    assert [len(part.select("img")) for part in parts] == [1] * len(NOTEBOOKS)
    links = [part.select_one("a[href*=html]")["href"] for part in parts]
    assert links == [f"{notebook.stem}.html#reproduce" for notebook in NOTEBOOKS]


def test_the_page_of_sources_lists_those_of_each_notebook(on_a_phone):
    article = on_a_phone("sources").page.locator("article")
    listed = [words(text) for text in article.locator("li").all_inner_texts()]
    assert article.locator("h2").count() == len(NOTEBOOKS)
    sources = re.findall("^- (.*)", "\n".join(section(n, "## Sources")[0].source for n in NOTEBOOKS), re.MULTILINE)
    assert len(listed) == len(sources) > 30
    for shown, source in zip(listed, sources, strict=True):
        assert shown.startswith(words(source.split("$")[0]))


@pytest.mark.parametrize("page", PAGES)
def test_works_offline_on_a_phone(on_a_phone, page):  # last, since the search for barriers takes a page apart
    assert_readable(on_a_phone(page), None, 390, rules=["color-contrast", "scrollable-region-focusable"])
