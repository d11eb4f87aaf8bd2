"""A site without solutions contains none: all that Sphinx reads is searched, and the search is
tried on the other site.

What Sphinx makes of it is looked at on a small notebook (test_site_answers.py).
"""

import re
import shutil
import zipfile
from itertools import chain
from pathlib import Path

import nbformat
import pytest
from leaks import ROOT, answer_cells, code, lines, secrets

from course_lib.pack.site import build as builder
from course_lib.pack.site import prepare, ten_minutes

VERDICT = re.compile(
    r"right[,:]? \(?\d+ of \d+|class=.course-(check|use)"
)  # what only checks say, and their box


def as_sphinx_reads_it(pages, site, *others):
    """Make a site of pages as they are before Sphinx, with an empty sheet for the style of code."""
    shutil.copytree(pages, site)
    (site / "_static").mkdir(exist_ok=True)
    (site / "_static/pygments.css").touch()


@pytest.fixture(scope="module")
def sites(tmp_path_factory):
    """What Sphinx reads, and the zip: for the site with solutions and for the one without."""
    folder = tmp_path_factory.mktemp("sites")
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(
            prepare,
            "picture",
            lambda output, kind, name, alt, folder: f'<img class="{name}" alt="{alt}">',
        )
        patch.setattr(builder, "_run_sphinx", as_sphinx_reads_it)
        builder.build(ROOT / "notebooks", folder / "yes")
        builder.build(ROOT / "notebooks", folder / "no", solutions=False)
    return {"yes": folder / "yes", "no": folder / "no"}


def words(text):
    """Only the words and numbers of a text, without its formulas: however it is emphasized, and its
    lines broken."""
    return " ".join(re.findall(r"[^\W_]+", re.sub(r"\$\$?[^$]+\$\$?", " ", text)))


def outputs(notebook):
    """The printed outputs of a notebook, and the texts of the others."""
    found = [output for cell in notebook.cells for output in cell.get("outputs", [])]
    printed = [output.text for output in found if output.output_type == "stream"]
    return printed, [str(text) for output in found for text in output.get("data", {}).values()]


def notebooks(file):
    """{name: content} of the notebooks in a zip."""
    with zipfile.ZipFile(file) as archive:
        return {name: archive.read(name) for name in archive.namelist() if name.endswith(".ipynb")}


def said(file):
    """What one file says, code and words as `secrets` has them: a notebook, those in the zip, or
    bytes taken for text.

    What else is in the zip is searched by the tests of the release.
    """
    if file.suffix not in (".ipynb", ".zip"):
        return file.read_bytes().decode(errors="replace")
    parts = []
    for content in notebooks(file).values() if file.suffix == ".zip" else [file.read_bytes()]:
        book = nbformat.reads(content.decode(), 4)
        shown = [
            re.sub("<script.*?</script>", "", text, flags=re.DOTALL)
            for text in chain(*outputs(book))
        ]
        sources = [cell.source for cell in book.cells]
        parts += [content.decode(), *map(words, shown + sources)]
        parts += [
            text
            for source in sources
            for text in ("\n".join(lines(source)), "\n".join(code(source)))
        ]
    return "\n\n".join(parts)


def leaks(site, wanted):
    """The (exercise, text) that are found in any file of a site."""
    files = [said(file) for file in site.rglob("*") if file.is_file()]
    return {
        (exercise, text) for text, exercise in wanted.items() if any(text in file for file in files)
    }


@pytest.fixture(scope="module")
def wanted():
    # A sentence that is all formulas has no words left to look for; its formulas are looked for
    # below.
    return {text: exercise for text, exercise in secrets(words).items() if len(text) >= 10}


def test_the_search_finds_every_answer_on_the_full_site(sites, wanted):
    assert set(wanted.values()) == {exercise for exercise, _ in answer_cells()}
    assert {text for _, text in leaks(sites["yes"], wanted)} == set(wanted)


def test_a_site_without_solutions_contains_no_line_of_them(sites, wanted):
    assert leaks(sites["no"], wanted) == set()


def test_the_search_looks_into_downloads(sites, wanted, tmp_path):
    (file,) = sites["no"].glob("*.zip")
    pages = {page.name: page.read_text(encoding="utf-8") for page in sites["no"].glob("0*.ipynb")}
    assert {Path(name).name for name in notebooks(file)} == set(pages)
    assert [name for name, text in pages.items() if file.name not in text] == []
    with zipfile.ZipFile(tmp_path / "planted.zip", "w") as archive:
        archive.write(ROOT / "notebooks/02_rigid_motion.ipynb", "notebooks/02_rigid_motion.ipynb")
    assert {"wrap_angle", "explain_wrap"} <= {exercise for exercise, _ in leaks(tmp_path, wanted)}


def formulas(cells):
    """The formulas of Markdown cells, each in one line."""
    texts = [
        re.sub(r"`[^`]*`|^```.*?^```", " ", cell.source)
        for cell in cells
        if cell.cell_type == "markdown"
    ]
    return {" ".join(tex.split()) for text in texts for tex in re.findall(r"\$\$?([^$]+)\$", text)}


def test_a_site_without_solutions_has_none_of_their_formulas(sites):
    answers = {cell.id: cell for _, cell in answer_cells()}
    cells = [
        cell
        for path in (ROOT / "notebooks").glob("0*.ipynb")
        for cell in nbformat.read(path, 4).cells
    ]
    open_to_all = "\n".join(formulas(cell for cell in cells if cell.id not in answers))
    secret = {tex for tex in formulas(answers.values()) if len(tex) > 10 and tex not in open_to_all}
    pages = {
        name: [nbformat.read(page, 4).cells for page in sites[name].glob("*.ipynb")]
        for name in sites
    }
    full, bare = ("\n".join(formulas(chain(*pages[name]))) for name in ("yes", "no"))
    assert len(secret) > 10
    assert [tex for tex in secret if tex not in full] == [], (
        "looked for as the pages are given them"
    )
    assert [tex for tex in secret if tex in bare] == []


def test_no_check_reports_right_and_every_other_output_stays(sites):
    books = {
        name: [nbformat.read(page, 4) for page in sorted(sites[name].glob("*.ipynb"))]
        for name in sites
    }
    for bare, full in zip(*(map(outputs, books[name]) for name in ("no", "yes")), strict=True):
        # A check's answer to code that no student wrote stands on the page for strangers.
        texts = "".join(bare[1]).replace(ten_minutes.check_of(ten_minutes.ANSWER), "")
        assert not VERDICT.search(texts)
        for output in ('class="toy-figure"', 'class="picture'):
            assert "".join(bare[1]).count(output) == "".join(full[1]).count(output)
        # No exercise of the notebooks is scored by a printed line, so each line stays.
        assert bare[0] == full[0]
    assert any(VERDICT.search("".join(outputs(book)[1])) for book in books["yes"])
    pages = "".join(said(page) for page in sites["no"].glob("*.ipynb"))
    assert not re.search("Model answer|Rubric|(BEGIN|END) SOLUTION", pages)
    sources = [cell.source for book in books["no"] for cell in book.cells]
    solved = [cell.source for _, cell in answer_cells() if cell.cell_type == "code"]
    unwritten = [
        source for source in solved if not source.rpartition("END SOLUTION")[2].strip()
    ]  # the rest hold a bug
    assert sum("NotImplementedError" in source for source in sources) >= len(unwritten)
    written = sum(cell.cell_type == "markdown" for _, cell in answer_cells())
    assert sum("Type your answer here." in source for source in sources) == written
