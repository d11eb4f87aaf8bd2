"""The pages that are compiled from the notebooks: home, ten minutes, errata, sources."""

import re
from functools import cache
from itertools import zip_longest
from pathlib import Path

import nbformat
import pytest
from bs4 import BeautifulSoup
from playwright.sync_api import expect
from site_visits import SHIFT, Visit

from course_lib.figures.stills import TOY
from course_lib.pack.more import heading_level

NOTEBOOKS = sorted((Path(__file__).parents[1] / "notebooks").glob("[0-9][0-9]_*.ipynb"))


def first_cell(notebook):
    return nbformat.read(notebook, 4).cells[0].source


def words(text):
    """Only the words: a page shows quotes in other signs."""
    return " ".join(re.findall(r"\w+", text))


@pytest.fixture(scope="module")
def article(course):
    """A function that gives the article of a page."""

    @cache
    def read(page):
        return BeautifulSoup((course / f"{page}.html").read_text("utf-8"), "html.parser").find(
            "article"
        )

    return read


def said(part):
    """The text of a part of a page, without the signs that link to its headings."""
    return " ".join(part.get_text(" ").replace("#", "").split())


def test_the_home_page_states_each_question_and_duration(article):
    home, hours = article("index"), []
    for page in ("notation.html#what-you-need", "reports.html", "errata.html"):
        assert home.select(f"section > p a[href='{page}']"), page
    for notebook in NOTEBOOKS:
        title = re.match("# (.*)", first_cell(notebook))[1]
        (link,) = home.select(f"h3 a[href='{notebook.stem}.html']")
        assert link.get_text() == title
        card = said(link.find_parent(class_="card"))
        question = words(card.replace(title, "")).split(" About ")[0]
        assert len(question) > 20
        assert "?" in card
        hours.append(float(re.search(r"About ([\d.]+) hours\.", card)[1]))
    assert f"about {sum(hours):g} hours" in said(home)
    assert len(home.find_parent("html").select("meta[name=description]")) == 1
    for name in ("reports", "notation", "places", "changes", "errata", "sources"):
        assert home.select(f"li a[href='{name}.html']")


@pytest.mark.parametrize(("width", "height"), [(1280, 800), (390, 844)])
def test_the_first_screen_has_one_button_and_the_robot_to_drag(course, browser, width, height):
    with Visit(browser, course / "index.html", width=width) as visit:
        visit.page.set_viewport_size({"width": width, "height": height})
        button = visit.page.locator(".first-step a")
        expect(button).to_have_text("Try ten minutes")
        expect(button).to_be_in_viewport(ratio=1)
        expect(visit.page.locator(".toy-figure .handle").first).to_be_in_viewport(ratio=1)
        button.click()
        assert visit.page.url.endswith("/ten_minutes.html")
        assert visit.complaints == []


def test_ten_minutes_hold_a_prediction_a_toy_and_a_check(article):
    page = article("ten_minutes")
    assert len(page.select(".course-predict details")) == 3
    assert len(page.select(".toy-figure")) == 1
    (answer,) = page.select("[class^=highlight-]")
    assert "R = np.array" in answer.get_text()
    assert "rotate_point not right yet" in words(said(page)), "what a check says"
    assert page.select(f"a[href='{NOTEBOOKS[0].stem}.html']")
    assert page.select("a[href='index.html#run-it-yourself']")


def test_commands_are_coloured_as_those_of_a_shell(article):
    for page, count in (("index", 3), ("guide", 10)):
        blocks = article(page).select("[class^=highlight-]:not([class*=python], [class*=bibtex])")
        languages = [block["class"][0] for block in blocks]
        assert len(languages) >= count
        assert set(languages) <= {"highlight-sh", "highlight-powershell"}


PICTURE = (
    "img:not(.panel), .panels"  # whole, or cut into panels, which stand below each other on a phone
)


def test_the_home_page_shows_a_picture_of_each_notebook(article):
    pictures = article("index").select(f".card :is({PICTURE})")
    shown = [picture.get("alt") or picture["aria-label"] for picture in pictures]
    assert len(shown) == len(NOTEBOOKS)
    for notebook, alt in zip(NOTEBOOKS, shown, strict=True):
        cells = [
            cell
            for cell in nbformat.read(notebook, 4).cells
            if "cover" in cell.metadata.get("tags", [])
        ]
        assert len(cells) == 1
        stored = next(
            output for output in cells[0].outputs if "image/png" in output.get("data", {})
        )
        assert alt in " ".join(stored.metadata["image/png"]["alt"].split())


def test_the_home_page_has_the_toy_of_the_tagged_cell(course, browser):
    cells = [cell for notebook in NOTEBOOKS for cell in nbformat.read(notebook, 4).cells]
    (tagged,) = (cell for cell in cells if "home" in cell.metadata.get("tags", []))
    (toy,) = (output for output in tagged.outputs if TOY in output.get("data", {}))
    with Visit(browser, course / "index.html") as visit:
        assert visit.draw_figures() == 1
        figure = visit.page.locator(".toy-figure.drawn")
        assert figure.get_attribute("aria-label") == " ".join(
            toy.metadata["image/png"]["alt"].split()
        )
        assert visit.page.evaluate(SHIFT) < 0.02
        expect(figure).to_contain_text("the arm follows")
        assert visit.complaints == []


@pytest.mark.parametrize("notebook", NOTEBOOKS, ids=lambda notebook: notebook.stem)
def test_every_figure_has_a_caption(notebook):
    bare, count = [], 0
    for number, cell in enumerate(nbformat.read(notebook, 4).cells, 1):
        outputs = cell.get("outputs", [])
        for output, following in zip_longest(outputs, outputs[1:], fillvalue={}):
            if {"image/png", "image/svg+xml"} & set(output.get("data", {})):
                count += 1
                if (
                    not following.get("metadata", {})
                    .get("caption", output.metadata.get("caption", ""))
                    .strip()
                ):
                    bare.append(f"cell {number}: {cell.source[:60]}")
    assert count > 0
    assert bare == []


def section(notebook, heading):
    """The cells from a heading to the next one of its or a higher level; empty if it is not
    there."""
    found, inside = [], False
    for cell in nbformat.read(notebook, 4).cells:
        if level := heading_level(cell):
            inside = cell.source.startswith(heading) or (inside and level > heading_level(found[0]))
        if inside:
            found.append(cell)
    return found


ERRATA = ("### Errors in it", "### Remarks")


def test_errata_contain_every_claim_with_its_evidence(article):
    errata = article("errata")
    printed = ["".join(part.get_text().split()) for part in errata.select(".output.stream")]
    assert errata.select("details[open]") == []
    assert [said(part) for part in errata.select("h2")] == ["Errors", "Remarks"]
    strong = [said(part) for part in errata.select("strong")]
    cells = [
        cell for heading in ERRATA for notebook in NOTEBOOKS for cell in section(notebook, heading)
    ]
    code = [cell for cell in cells if cell.cell_type == "code"]
    assert len(errata.select("details:not(.chart-numbers)")) == len(code)
    text = "\n".join(cell.source for cell in cells if cell.cell_type == "markdown")
    shown, titles = (
        words(errata.get_text()),
        re.findall(r"^(?:#### |\*\*\d)(.*)", text, re.MULTILINE),
    )
    assert len(titles) >= len(NOTEBOOKS)
    assert [title for title in titles if words(re.split(r"[$*]", title)[0]) not in shown] == []
    for word in ("Printed", "Evidence", "Right"):
        assert sum(each.startswith(word) for each in strong) == text.count(f"**{word}"), word
    outputs = [
        output
        for cell in cells
        for output in cell.get("outputs", [])
        if output.output_type == "stream"
    ]
    assert sorted(printed) == sorted("".join(output.text.split()) for output in outputs)


def test_each_report_has_its_picture_and_links_to_its_cells(article):
    parts = article("reports").select("section section")
    reproduced = [
        notebook
        for notebook in NOTEBOOKS
        if "### Reproduce" in notebook.read_text(encoding="utf-8")
    ]
    assert [len(part.select(PICTURE)) for part in parts] == [1] * len(reproduced)
    links = [part.select_one("a[href*=html]")["href"] for part in parts]
    assert links == [f"{notebook.stem}.html#reproduce" for notebook in reproduced]


def test_the_page_of_sources_lists_those_of_each_notebook(article):
    listed = [words(said(part)) for part in article("sources").select("li")]
    assert len(article("sources").select("h2")) == len(NOTEBOOKS)
    sources = re.findall(
        "^- (.*)", "\n".join(section(n, "## Sources")[0].source for n in NOTEBOOKS), re.MULTILINE
    )
    assert len(listed) == len(sources) > 30
    for shown, source in zip(listed, sources, strict=True):
        assert shown.startswith(words(source.split("$")[0]))
