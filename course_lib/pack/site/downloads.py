"""Offer the students' zip on the pages."""

from pathlib import Path

import nbformat

from course_lib.pack.release import ReleaseError
from course_lib.pack.release.bundle import collect, named, release_date, write_zip
from course_lib.pack.site import SiteError
from course_lib.pack.site.prepare import OPENING

ZIP = "robot-kinematics.zip"  # beside the pages
LINK = '<a href="{name}" download>Download the course</a> ({size:.1f} MB, without solutions)'
RUN = """<p class="run-it"><strong>Run it.</strong> {link}, unpack it and type
<code>make lab</code> in its folder. Without make, follow the README in this folder. Then open
<code>notebooks/{name}</code>.</p>"""
# Colab opens a notebook without the folder in which it stands.
ON_COLAB = """<details><summary>Run it on Colab</summary><p>The button with the rocket opens this
notebook on Colab. Put these lines into a new cell above the first one, and run them before all
other cells:</p><pre>!git clone --depth 1 {repository} course
%cd course/notebooks
!pip install --quiet ..
from google.colab import output
output.enable_custom_widget_manager()</pre></details>"""


def students_zip(root: Path, path: Path) -> Path | None:
    """Write the students' zip of the project at `root` to `path`, and return it.

    Return None if `root` is no project.
    """
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


def offer(notebook: Path, release: Path, repository: str = "") -> None:
    """Put a link to the zip below the first figure of a prepared notebook.

    Without a figure it stands below the notebook's first text. If the address of a repository is
    given, it says how to run the notebook on Colab, too.
    """
    words = RUN.format(link=offered(release), name=notebook.name)
    if repository:
        words += ON_COLAB.format(repository=repository)
    book = nbformat.read(notebook, as_version=4)
    shown = next((cell for cell in book.cells[:OPENING] if cell.get("outputs")), None)
    if shown:  # no cell is added, for Sphinx's messages name cells by their numbers
        shown.outputs.append(nbformat.v4.new_output("display_data", data={"text/html": words}))
    elif book.cells[0].cell_type == "markdown":
        book.cells[0].source += f"\n\n{words}"
    nbformat.write(book, notebook)
