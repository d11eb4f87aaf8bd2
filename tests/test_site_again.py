"""Building a second time."""

import shutil

import pytest
from loaded_sphinx import build
from nbformat.v4 import new_code_cell, new_markdown_cell
from site_notebooks import HELIX, MOVING, NBGRADER, PLOTLY, SOLUTION, TEXT, cell, output, png, write

from course_lib.pack.site import SiteError


@pytest.fixture(scope="module")
def made(tmp_path_factory):
    """The folder of notebooks, beside it the site built from them, and the lines printed by the build."""
    folder = tmp_path_factory.mktemp("made") / "notebooks"
    both = {PLOTLY: HELIX, "image/png": png()}
    cells = [
        cell(source=SOLUTION, nbgrader=NBGRADER),
        cell(output(both, "Two helices")),
        cell(output({PLOTLY: MOVING})),
    ]
    write(folder, "01_rotations.ipynb", new_markdown_cell(TEXT + "\nSee [the next](02_rigid_motion.ipynb)."), *cells)
    write(folder, "02_rigid_motion.ipynb", new_markdown_cell("# Rigid motion\n\nSee [numpy](https://numpy.org)."))
    write(folder, "Untitled.ipynb", new_markdown_cell("# Notes of the author's own"))
    (folder / "Answers.md").write_text("# For graders")
    return folder, built(folder)


@pytest.fixture
def notebooks(made, tmp_path):
    """A copy of the notebooks, and beside it of their site."""
    for each in made[0].parent.iterdir():
        shutil.copytree(each, tmp_path / each.name)
    return tmp_path / "notebooks"


def built(notebooks, **settings):
    """Build; return the lines printed."""
    said = []
    build(notebooks, notebooks.parent / "html", said.append, **settings)
    return said


def test_progress_names_each_notebook(made):
    _, said = made
    assert said[:2] == [
        "01_rotations.ipynb: 2 live figures, 0 pictures",
        "02_rigid_motion.ipynb: 0 live figures, 0 pictures",
    ]


def test_only_numbered_notebooks_and_the_pages_that_they_name_are_pages(made):
    assert {page.name for page in (made[0].parent / "html").glob("[0-9UA]*.html")} == {
        "01_rotations.html",
        "02_rigid_motion.html",
    }


def test_a_second_build_replaces_the_first(notebooks):
    page = notebooks.parent / "html/01_rotations.html"
    assert "BEGIN SOLUTION" in page.read_text("utf-8")
    (page.parent / "of_before.html").touch()
    built(notebooks, solutions=False)
    assert "BEGIN SOLUTION" not in page.read_text("utf-8")
    assert not (page.parent / "of_before.html").exists()


def test_a_cell_that_was_changed_and_not_run_stops_the_build(notebooks):
    write(notebooks, "03.ipynb", new_markdown_cell("# New"), cell(output({"text/html": "x"})), new_code_cell("1 + 1"))
    with pytest.raises(SiteError, match=r"03\.ipynb, cell 3 was changed, and not run since"):
        built(notebooks)
