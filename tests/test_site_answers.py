"""Answers on the pages: folded shut, or left out."""

import shutil
from pathlib import Path

import nbformat
import pytest
from bs4 import BeautifulSoup
from nbformat.v4 import new_markdown_cell, new_output
from playwright.sync_api import expect
from site_notebooks import CHECK, EXPLAINED, MODEL_ANSWER, NBGRADER, SOLUTION, cell, output, png, write
from site_visits import CONTRAST, Visit
from sphinx_builds import build

from course_lib.pack.site import SiteError

NOTEBOOKS = Path(__file__).parents[1] / "notebooks"
ANSWERS = {"Solution": "gooseberry", "Model answer": "stay orthogonal"}  # name: words that are inside


def answers(notebook):
    """The answer cells of a notebook."""
    cells = nbformat.read(notebook, 4).cells
    return [cell for cell in cells if cell.metadata.get("nbgrader", {}).get("solution")]


@pytest.fixture(scope="module")
def notebooks(tmp_path_factory):
    folder = tmp_path_factory.mktemp("answers") / "notebooks"
    write(
        folder,
        "01.ipynb",
        new_markdown_cell("# Answers"),
        cell(source=SOLUTION, nbgrader=NBGRADER),
        new_markdown_cell(MODEL_ANSWER, metadata={"nbgrader": EXPLAINED}),
        cell(output({"text/html": CHECK}), source="check.turn(turn)"),
        cell(output({"text/html": "<p>A result</p>"}), source="turn()"),
        cell(new_output("stream", text="raisins: 3\nyour score: 94 of 100\n"), source="score(turn)"),
        cell(source="import numpy as np\n\nraisins = 3"),
        cell(output({"image/png": png()}, "A rising line"), source='show(fig, caption="It rises.")'),
        cell(output({"image/png": png()}, "A line"), new_output("stream", text="7"), source="show(fig)\nprint(plums)"),
    )
    write(folder, "Untitled.ipynb", new_markdown_cell("# Notes of the author's own"))
    (folder / "Marks.md").write_text("# For graders")
    return folder


@pytest.fixture(scope="module")
def site(notebooks):
    """The site with solutions (True), and the one without (False) that was built in its place."""
    folder, copy = notebooks.parent / "html", notebooks.parent / "html-with-solutions"
    build(notebooks, folder)
    (folder / "of_before.html").touch()
    shutil.copytree(folder, copy)
    build(notebooks, folder, solutions=False)
    return {True: copy, False: folder}


def test_only_numbered_notebooks_and_the_pages_that_they_name_are_pages_and_none_of_before_stays(site):
    assert {page.name for page in site[False].glob("*.html")} == {"01.html", "index.html", "search.html"}


@pytest.fixture(scope="module")
def visit(site, browser):
    """A visit to the page with answers; every test leaves them shut."""
    with Visit(browser, site[True] / "01.html", theme="dark", width=390) as visit:
        yield visit
        assert visit.complaints == []


@pytest.mark.parametrize("name", ANSWERS)
def test_an_answer_opens_and_shuts_by_mouse_and_by_keyboard(visit, name):
    line = visit.page.locator("summary").filter(has_text=name)
    inside = visit.page.locator("article").get_by_text(ANSWERS[name])
    expect(inside).not_to_be_visible()
    line.click()
    expect(inside).to_be_visible()
    assert visit.page.evaluate("document.documentElement.scrollWidth <= innerWidth")
    for part in (line.locator("p:visible"), inside):
        assert part.evaluate(CONTRAST) > 4.5
    line.click()
    expect(inside).not_to_be_visible()
    line.focus()
    visit.page.keyboard.press("Enter")
    expect(inside).to_be_visible()
    visit.page.keyboard.press("Space")
    expect(inside).not_to_be_visible()


def test_imports_and_what_only_draws_are_folded_and_nothing_else(site):
    soup = BeautifulSoup((site[True] / "01.html").read_text(encoding="utf-8"), "html.parser")
    assert not soup.select("summary[aria-label]"), "a screen reader reads the line that is shown"
    folds = {fold.summary.p.get_text(strip=True): fold for fold in soup.select("article details.hide")}
    assert [*folds] == [*ANSWERS, "Imports and settings", "The lines that draw it"]
    assert "import numpy" in folds["Imports and settings"].get_text()
    drawn = folds["The lines that draw it"]
    assert "It rises." in drawn.get_text()
    assert not drawn.select("img"), "the figure itself stands open"
    assert not [fold for fold in folds.values() if "plums" in fold.get_text()], "it computes, and prints"


def test_left_out_the_page_shows_what_students_find_and_keeps_other_outputs(site):
    text = (site[False] / "01.html").read_text(encoding="utf-8")
    assert "NotImplementedError" in text
    assert "Type your answer here." in text
    assert "A result" in text
    assert "raisins: 3" in text
    assert "your score" in (site[True] / "01.html").read_text(encoding="utf-8")
    assert "your score" not in text, "there is no answer yet that could be scored"
    assert not [
        words
        for words in ("gooseberry", "orthogonal", "Rubric", "Model answer", ">Solution", "Right: ")
        if words in text
    ]
    assert "orthogon" not in (site[False] / "searchindex.js").read_text(encoding="utf-8")


def test_model_answers_alone_are_folded_where_the_instructor_allows_it(notebooks, tmp_path):
    build(notebooks, tmp_path / "html", solutions=False, model=True)
    text = (tmp_path / "html" / "01.html").read_text(encoding="utf-8")
    assert "stay orthogonal" in BeautifulSoup(text, "html.parser").select_one("article details.hide").get_text()
    assert "NotImplementedError" in text
    assert "gooseberry" not in text


def test_an_answer_that_cannot_be_told_from_the_rest_stops_the_site_without_answers(tmp_path):
    bare = cell(source="def turn():\n    return 42", nbgrader=NBGRADER)
    write(tmp_path / "notebooks", "01.ipynb", new_markdown_cell("# Answers"), bare, cell(output({"text/html": "x"})))
    with pytest.raises(SiteError, match=r"01\.ipynb, cell 2: an answer cell without ### BEGIN SOLUTION"):
        build(tmp_path / "notebooks", tmp_path / "html", solutions=False)
    assert not (tmp_path / "html").exists()
