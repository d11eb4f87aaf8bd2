"""Offer downloads on the pages: the students' zip, or, on a page that is one file, its notebook."""

import base64
import hashlib
from pathlib import Path

import nbformat

from course_lib.pack.release import ReleaseError
from course_lib.pack.release.bundle import PAGES, collect, named, release_date, write_zip
from course_lib.pack.release.stubs import students_copy
from course_lib.pack.site import SiteError
from course_lib.pack.site.prepare import OPENING

ZIP = "robot-kinematics.zip"  # beside the pages
LINK = '<a href="{name}" download>Download the course</a> ({size:.1f} MB, without solutions)'
RUN = """<p><strong>Run it.</strong> {link}, unpack it and type <code>make lab</code> in its folder; without make,
follow its README. Then open <code>notebooks/{name}</code>.</p>"""
REPORTS = '\n<p><a href="reports.html">What the reports print, beside our numbers</a>.</p>'
# The link on a page that is one file contains the notebook.
KIND = "data:application/x-ipynb+json;base64,"
WORDS = """<p><a download="{name}" href="{kind}{content}">Download this notebook, without solutions</a>. It runs beside
the others in the course's folder, where it finds the helper package and the data.</p>"""


def students_zip(root: Path, path: Path) -> Path | None:
    """Write the students' zip of the project at `root` to `path` and return it, or None if `root` is no project."""
    if not (root / "pyproject.toml").is_file():
        return None
    try:
        write_zip(path, named(collect(root))[1], release_date(root))
    except ReleaseError as error:
        raise SiteError(str(error)) from error
    return path


def offered(release: Path | None) -> str:
    """Return the link to the students' zip, or "" if there is none."""
    return LINK.format(name=ZIP, size=release.stat().st_size / 1e6) if release else ""


def offer(source: Path, folder: Path, release: Path | None = None) -> None:
    """Put a link to the zip, or to a notebook without solutions, below the first figure of its copy in `folder`.

    Below the first text if nothing is shown in the opening cells.

    Raises SiteError if a solution cannot be separated from the rest.
    """
    book = nbformat.read(folder / source.name, as_version=4)
    words = RUN.format(link=offered(release), name=source.name) if release else _alone(source)
    if (folder / PAGES[0]).exists():
        words += REPORTS
    shown = next((cell for cell in book.cells[:OPENING] if cell.get("outputs")), None)
    if shown:  # no cell is added, for Sphinx's messages name cells by their numbers
        shown.outputs.append(nbformat.v4.new_output("display_data", data={"text/html": words}))
    elif book.cells[0].cell_type == "markdown":
        book.cells[0].source += f"\n\n{words}"
    nbformat.write(book, folder / source.name)


def _alone(source: Path) -> str:
    """Return the text that holds a notebook without solutions in a link."""
    text = source.read_text(encoding="utf-8")
    version = hashlib.sha256(text.encode()).hexdigest()[:8]
    try:
        copy = students_copy(text, source.name, f"site-{version}")
    except ReleaseError as error:
        raise SiteError(str(error)) from error
    content = base64.b64encode(copy.encode()).decode()
    return WORDS.format(name=source.name, kind=KIND, content=content)
