"""The pages that are gathered from the notebooks: home."""

import re
from pathlib import Path

import nbformat
import pytest
from site_visits import Visit
from test_site import assert_readable

from course_lib.pack.site.build import build

NOTEBOOKS = sorted((Path(__file__).parents[1] / "notebooks").glob("[0-9][0-9]_*.ipynb"))
PAGES = ("index",)


@pytest.fixture(scope="module")
def course(tmp_path_factory):
    folder = tmp_path_factory.mktemp("pages") / "html"
    build(NOTEBOOKS[0].parent, folder)
    return folder


def first_cell(notebook):
    return nbformat.read(notebook, 4).cells[0].source


def words(text):
    """Only the words: a page shows quotes in other signs."""
    return " ".join(re.findall(r"\w+", text))


@pytest.mark.parametrize("theme", ["light", "dark"])
@pytest.mark.parametrize("width", [390, 1000])
@pytest.mark.parametrize("page", PAGES)
def test_works_offline(course, browser, page, theme, width):
    with Visit(browser, course / f"{page}.html", theme=theme, width=width) as visit:
        assert_readable(visit, None, width)


def test_home_says_what_each_notebook_says_of_itself(course, browser):
    with Visit(browser, course / "index.html") as visit:
        article = visit.page.locator("article")
        text = words(article.inner_text())
        for notebook in NOTEBOOKS:
            said = first_cell(notebook)
            title = re.match("# (.*)", said)[1]
            assert article.locator(f"h2 a[href='{notebook.stem}.html']").inner_text() == title
            goals = re.findall(r"^- ([^$*`\n]*)", said, re.MULTILINE)
            assert len(goals) >= 4
            for goal in goals:
                assert words(goal) in text
            assert re.search(r"It takes about \w+ hours", said)[0] in text
        assert "about 33 hours" in text
        assert article.locator("a[href='notation.html']").count() == 1


def test_home_shows_a_picture_of_each_notebook_from_the_cell_that_is_tagged(course, browser):
    with Visit(browser, course / "index.html") as visit:
        shown = [image.get_attribute("alt") for image in visit.page.locator("article img").all()]
    assert len(shown) == len(NOTEBOOKS)
    for notebook, alt in zip(NOTEBOOKS, shown, strict=True):
        cells = [cell for cell in nbformat.read(notebook, 4).cells if "cover" in cell.metadata.get("tags", [])]
        assert len(cells) == 1
        stored = next(output for output in cells[0].outputs if "image/png" in output.get("data", {}))
        assert alt in " ".join(stored.metadata["image/png"]["alt"].split())
