"""The pages as one PDF: the order of its chapters, its contents and its bookmarks."""

import re
import subprocess

import pytest
from bs4 import BeautifulSoup
from nbformat.v4 import new_markdown_cell
from site_notebooks import write
from sphinx_builds import build

from course_lib.pack.site import SiteError, pdf

pytestmark = pytest.mark.slow  # Sphinx builds a site of its own for these tests

LONG_TITLE = "A section whose title is so long that a page has to set it in two lines, one below"


@pytest.fixture(scope="module")
def site(tmp_path_factory):
    folder = tmp_path_factory.mktemp("pdf") / "notebooks"
    write(folder, "01_rotations.ipynb", new_markdown_cell("# Rotations\n\nSee [it](notation.md)."))
    rows = "".join(f"| row {number} | a text |\n" for number in range(60))
    table = f"| number | text |\n| --- | --- |\n{rows}"
    text = f"# Rigid motion\n\n## {LONG_TITLE}\n\n## A table\n\n{table}"
    more = new_markdown_cell("## More: screws\n\nAn axis.", metadata={"tags": ["more"]})
    inside = new_markdown_cell("They have a pitch.")
    write(folder, "02_rigid_motion.ipynb", new_markdown_cell(text), more, inside)
    (folder / "notation.md").write_text("# Notation\n\n$R$ is a rotation.\n", encoding="utf-8")
    build(folder, folder.parent / "html")
    return folder.parent / "html"


def test_notation_stands_before_the_notebooks(site):
    book = BeautifulSoup(pdf._book(site, {}), "html.parser")
    chapters = [chapter["id"] for chapter in book.select(".chapter")]
    assert chapters == ["notation", "01_rotations", "02_rigid_motion", "guide", "semester"]
    assert len(book.select(".book-contents li")) == 5


# As Chromium writes them: pages in their order, whatever the numbers of the objects, and anchors.
PRINTED = b"""2 0 obj\n<</Type /Page\n/Resources <<>>>>\nendobj
41 0 obj\n<</Type /Page\n/Parent 5 0 R>>\nendobj\n5 0 obj\n<</Type /Pages\n/Count 3>>\nendobj
7 0 obj\n<</Type /Page\n/Parent 5 0 R>>\nendobj
8 0 obj\n<</notation [41 0 R /XYZ 0 8 0]\n/01_rotations-x [7 0 R /XYZ 0 8 0]>>\nendobj
9 0 obj\n<</Title (Go \\(on\\)Go \\(on\\))\n/Dest [7 0 R /XYZ 0 8 0]>>
10 0 obj\n<</Title <FEFF0031002000B70031002000B7>\n/Dest [7 0 R /XYZ 0 8 0]>>
11 0 obj\n<</Title (Once)\n/Dest [7 0 R /XYZ 0 8 0]>>
"""


def test_an_anchor_is_on_its_page_counted_from_the_first():
    assert pdf.first_pages(PRINTED) == {"notation": 2, "01_rotations-x": 3}


def test_a_pdf_written_in_another_way_has_no_page_numbers():
    assert pdf.first_pages(b"%PDF-1.7 compressed") == {}


def test_no_bookmark_says_its_name_twice():
    named = pdf.name_bookmarks_once(PRINTED)
    assert rb"(Go \(on\))" in named
    assert b"<FEFF0031002000B7>" in named
    assert b"(Once)" in named
    assert len(named) == len(PRINTED), "the places of the objects stay"


def test_a_pdf_stays_as_it_was_if_the_browser_fails(site, tmp_path, monkeypatch):
    file = tmp_path / "course.pdf"
    file.write_bytes(b"the PDF of yesterday")
    monkeypatch.setenv("BROWSER_PATH", "/bin/false")
    with pytest.raises(SiteError, match="A browser prints the PDF, and the browser /bin/false"):
        pdf.write_pdf(site, file)
    assert file.read_bytes() == b"the PDF of yesterday"


@pytest.fixture(scope="module")
def course(site, tmp_path_factory, browser):
    file = tmp_path_factory.mktemp("printed") / "course.pdf"
    pdf.write_pdf(site, file)
    return file


@pytest.fixture(scope="module")
def pages(course):
    printed = subprocess.run(
        ["pdftotext", "-layout", course, "-"], capture_output=True, text=True, check=True
    )
    return printed.stdout.split("\f")


@pytest.mark.tools("pdftotext")
def test_the_contents_give_the_page_on_which_each_chapter_begins(pages):
    for title in ("Notation", "Rotations", "Rigid motion"):
        (number,) = re.findall(rf"^ *{title} +(\d+)$", pages[0], re.MULTILINE)
        assert pages[int(number) - 1].lstrip().startswith(title)


@pytest.mark.tools("pdftotext")
def test_a_table_longer_than_a_page_begins_below_its_heading(pages):
    (first,) = [page for page in pages if re.search("^ *A table$", page, re.MULTILINE)]
    assert "row 0 " in first
    assert "row 59" not in first


@pytest.mark.tools("pdftotext")
def test_the_sections_of_more_are_printed(pages):
    assert any("They have a pitch." in page for page in pages)


@pytest.mark.tools("pdftotext")
def test_no_page_is_empty(pages):
    *printed, after_the_last = pages
    assert after_the_last == ""
    for page in printed:
        assert re.search("[A-Za-z]", page), "more than its number"


def test_a_bookmark_keeps_the_space_of_a_broken_heading(course):
    assert f"/Title ({LONG_TITLE})".encode() in course.read_bytes()


def test_every_object_of_the_pdf_is_where_its_table_says(course):
    content = course.read_bytes()
    _, _, table = content.rpartition(b"\nxref\n")
    places = [int(place) for place in re.findall(rb"(\d{10}) \d{5} n", table)]
    assert len(places) > 100
    for number, place in enumerate(places, 1):
        assert content[place:].startswith(b"%d 0 obj" % number)
    (start,) = re.findall(rb"startxref\s+(\d+)", table)
    assert content[int(start) :].startswith(b"xref")
