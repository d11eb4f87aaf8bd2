"""A site without solutions contains none: all its files are searched, and the search is tried on the other site."""

import html
import re
import zipfile

import nbformat
import pytest
from leaks import ROOT, answer_cells, code, lines, secrets, texts

from course_lib.pack.site import formulas

TAG = re.compile(r"<[^>]+>")
VERDICT = re.compile(r"right[,:]? \(?\d+ of \d+|role=.status")  # what only checks say, and their box


FORMULA = re.compile(r'<(span|div) class="math[^>]*><svg.*?</math></span></\1>', re.DOTALL)


def words(text):
    """Only the words and numbers of a text: a page shows quotes and emphasis with other signs, formulas as pictures."""
    return " ".join(re.findall(r"[^\W_]+", re.sub(r"\$\$?[^$]+\$\$?", " ", text)))


def shown(page):
    """What a page shows: each block of code, its lines and its lines as ast.unparse has them; and all its words."""
    for block in re.findall(r"<pre[^>]*>(.*?)</pre>", page, re.DOTALL):
        source = html.unescape(TAG.sub("", block))
        yield "\n".join(lines(source))
        yield "\n".join(code(source))
    yield words(html.unescape(TAG.sub("", FORMULA.sub(" ", page))).replace("$", " "))


def said(file):
    """What one file of a site says: a page, the notebooks in the zip, or bytes taken for text.

    What else is in the zip is searched by the tests of the release.
    """
    if file.suffix == ".zip":
        parts = [part for name, content in notebooks(file) for part in texts(name, content)]
        return "\n\n".join([*parts, *map(words, parts)])
    if file.suffix != ".html":
        return file.read_bytes().decode(errors="replace")
    return "\n\n".join(shown(file.read_text(encoding="utf-8")))


def notebooks(file):
    with zipfile.ZipFile(file) as archive:
        return [(name, archive.read(name)) for name in archive.namelist() if name.endswith(".ipynb")]


def leaks(site, wanted):
    """The (exercise, text) that are found in any file of a site."""
    files = [said(file) for file in site.rglob("*") if file.is_file()]
    return {(exercise, text) for text, exercise in wanted.items() if any(text in file for file in files)}


@pytest.fixture(scope="module")
def wanted():
    # A sentence that is all formulas has no words left to look for; its formulas are looked for below.
    return {text: exercise for text, exercise in secrets(words).items() if len(text) >= 10}


def mathml(texts):
    """The formulas of Markdown texts, as pages contain them for screen readers: as MathML."""
    found = [
        formulas.typeset(" ".join(tex.split()), display=bool(sign == "$$"))
        for text in texts
        for sign, tex in re.findall(r"(\$\$?)([^$]+)\$", re.sub(r"`[^`]*`|^```.*?^```", " ", text))
    ]
    return {re.search(r"<math\b[^>]*>(.*)</math>", made, re.DOTALL)[1] for made in found}


@pytest.fixture(scope="module")
def secret_formulas():
    """The formulas that occur in model answers only and are longer than a single letter."""
    answers = {cell.id for _, cell in answer_cells()}
    cells = [
        cell
        for path in sorted((ROOT / "notebooks").glob("[0-9][0-9]_*.ipynb"))
        for cell in nbformat.read(path, 4).cells
        if cell.cell_type == "markdown"
    ]
    secret = mathml(cell.source for cell in cells if cell.id in answers)
    open_to_all = "".join(mathml(cell.source for cell in cells if cell.id not in answers))
    return {each for each in secret if len(each) > 150 and each not in open_to_all}


@pytest.fixture
def sites(course, course_without_answers):
    """The course as a site with solutions and as one without."""
    return {"yes": course, "no": course_without_answers}


def test_the_search_finds_every_line_and_every_sentence_where_they_are(sites, wanted):
    assert set(wanted.values()) == {exercise for exercise, _ in answer_cells()}
    assert {text for _, text in leaks(sites["yes"], wanted)} == set(wanted)


def test_the_search_looks_into_downloads(sites, wanted, tmp_path):
    (file,) = sites["no"].glob("*.zip")
    assert len(notebooks(file)) == len(list((ROOT / "notebooks").glob("[0-9][0-9]_*.ipynb")))
    for page in sites["no"].glob("0*.html"):
        assert f'href="{file.name}"' in page.read_text(encoding="utf-8")
    with zipfile.ZipFile(tmp_path / "planted.zip", "w") as archive:
        archive.write(ROOT / "notebooks/02_rigid_motion.ipynb", "notebooks/02_rigid_motion.ipynb")
    assert {"wrap_angle", "explain_wrap"} <= {exercise for exercise, _ in leaks(tmp_path, wanted)}


def test_a_site_without_solutions_contains_none_of_their_formulas(sites, secret_formulas):
    full, bare = (
        "".join(page.read_text(encoding="utf-8") for page in sites[name].glob("*.html")) for name in ("yes", "no")
    )
    assert len(secret_formulas) > 10
    assert [each for each in secret_formulas if each not in full] == [], "looked for as pages write them"
    assert [each for each in secret_formulas if each in bare] == []


def test_a_site_without_solutions_contains_no_line_and_no_sentence_of_them(sites, wanted):
    assert leaks(sites["no"], wanted) == set()


def own_lines(notebook):
    """The number of printed outputs of a notebook that only address the author of the answers."""
    cells = nbformat.read(notebook, 4).cells
    printed = [output.text for cell in cells for output in cell.get("outputs", []) if output.output_type == "stream"]
    return sum(all(re.search(r"\b(you|yours?)\b", line, re.I) for line in lines(text)) for text in printed)


def test_no_check_reports_right_and_every_other_output_stays(sites):
    for page in sites["no"].glob("*.html"):
        bare, full = page.read_text("utf-8"), (sites["yes"] / page.name).read_text("utf-8")
        assert not VERDICT.search(bare), page.name
        for output in ('class="toy-figure"', 'class="picture'):
            assert bare.count(output) == full.count(output), page.name
        notebook = ROOT / "notebooks" / f"{page.stem}.ipynb"
        left_out = own_lines(notebook) if notebook.exists() else 0
        assert bare.count('class="output stream') == full.count('class="output stream') - left_out, page.name
        assert not re.search("Model answer|Rubric|(BEGIN|END) SOLUTION", bare)
    assert any(VERDICT.search(page.read_text("utf-8")) for page in sites["yes"].glob("*.html"))
    pages = "".join(page.read_text("utf-8") for page in sites["no"].glob("*.html"))
    code = [cell.source for _, cell in answer_cells() if cell.cell_type == "code"]
    unwritten = [source for source in code if not source.rpartition("END SOLUTION")[2].strip()]  # the rest hold a bug
    assert pages.count("NotImplementedError") >= len(unwritten)
    assert pages.count("Type your answer here.") == sum(cell.cell_type == "markdown" for _, cell in answer_cells())
