"""The student's notebook, to download from its page."""

import base64
import hashlib
from pathlib import Path

import nbformat

from course_lib.pack.release import ReleaseError
from course_lib.pack.release.stubs import students_copy
from course_lib.pack.site.errors import SiteError

# The link holds the notebook: a browser shows a file that lies beside the page as text, unless a server sends it.
KIND = "data:application/x-ipynb+json;base64,"
WORDS = """

<a download="{name}" href="{kind}{content}">Download this notebook, without solutions</a>. It runs beside the others in
the course's folder, where it finds the helper package and the data."""


def offer(source: Path, folder: Path) -> None:
    """Put a link to a notebook without solutions at the end of the first text of its prepared copy in `folder`.

    Raises SiteError where a solution cannot be told from the rest.
    """
    text = source.read_text(encoding="utf-8")
    version = hashlib.sha256(text.encode()).hexdigest()[:8]
    try:
        copy = students_copy(text, source.name, f"site-{version}")
    except ReleaseError as error:
        raise SiteError(str(error)) from error
    book = nbformat.read(folder / source.name, as_version=4)
    first = next((cell for cell in book.cells if cell.cell_type == "markdown"), None)
    if first:
        content = base64.b64encode(copy.encode()).decode()
        first.source += WORDS.format(name=source.name, kind=KIND, content=content)
    nbformat.write(book, folder / source.name)
