"""Build the site from the notebooks.

Copies of the notebooks are prepared, Sphinx turns them into pages, and these are moved into place.
"""

import re
import shutil
import subprocess
import sys
import tempfile
from importlib.resources import files
from pathlib import Path

import nbformat
from nbformat import NotebookNode

from course_lib.figures.toys.toy import script, script_names
from course_lib.pack.release.bundle import PAGES, release_date
from course_lib.pack.site import SiteError, gather, icons, sections, ten_minutes
from course_lib.pack.site.downloads import ZIP, offer, offered, students_zip
from course_lib.pack.site.finish import finish
from course_lib.pack.site.prepare import prepare
from course_lib.pack.site.search import write_index

HERE = Path(__file__).parent
UNKNOWN = 2000  # the year that release_date gives to files whose date nothing says
REPOSITORY = re.compile(r"https://github\.com/[\w.-]+/[\w.-]+")


def build(
    notebooks: Path,
    output: Path,
    solutions: bool = True,
    model: bool = False,
    repository: str = "",
) -> None:
    """Write the numbered notebooks of one folder, as they were saved, to `output` as a static site.

    No cell is executed and no notebook is changed.

    `output` is empty, absent, or holds a site. With `solutions` the answers are folded, else left
    out; with `model` those to written questions are folded. `repository` is the address of a public
    repository on GitHub that holds these notebooks, on its branch main; each page then has buttons
    that open its notebook on Binder and on Colab. Raises SiteError if a notebook cannot be
    published, or the address is no such one; `output` then stays as it was.
    """
    if repository and not REPOSITORY.fullmatch(repository):
        raise SiteError(
            f"REPOSITORY={repository} is no address of a repository on GitHub, such as "
            "https://github.com/owner/name."
        )
    sources = sorted(notebooks.glob("[0-9][0-9]*.ipynb"))
    if not sources:
        raise SiteError(f"There are no notebooks in {notebooks}.")
    if notebooks.resolve() in output.resolve().parents:
        raise SiteError(
            f"{output} lies inside {notebooks}, which is read. Name a folder elsewhere."
        )
    # Sphinx leaves .buildinfo in every site, so a folder without it was not written by us.
    if output.exists() and any(output.iterdir()) and not (output / ".buildinfo").exists():
        raise SiteError(f"{output} holds other files than a site. Name an empty folder.")

    output.parent.mkdir(parents=True, exist_ok=True)
    with tempfile.TemporaryDirectory(dir=output.parent, prefix="site-") as work:
        pages, site = Path(work, "pages"), Path(work, "html")
        release = students_zip(notebooks.parent, Path(work, ZIP))
        _gather(sources, pages, solutions, model, release, repository)
        _copy_own_files(pages / "_static")
        print(f"Making pages of {len(sources)} notebooks with Sphinx")
        _run_sphinx(pages, site, Path(work, "doctrees"), repository)
        finish(site)
        write_index(site)
        if release:
            release.rename(site / ZIP)
        if output.exists():
            shutil.rmtree(output)
        site.rename(output)
    size = sum(file.stat().st_size for file in output.rglob("*") if file.is_file()) / 1e6
    print(
        f"Wrote {len(list(output.glob('*.html')))} pages, {size:.1f} MB. Open "
        f"{output / 'index.html'}"
    )


def _gather(
    sources: list[Path],
    pages: Path,
    solutions: bool,
    model: bool,
    release: Path | None,
    repository: str,
) -> None:
    """Fill `pages` with what Sphinx reads: notebooks, the files they show, settings and more pages.

    `release` is the students' zip, or None.
    """
    # The notebooks' texts link to pictures and data beside them.
    shutil.copytree(sources[0].parent, pages, ignore=shutil.ignore_patterns("*.ipynb", ".*"))
    shutil.copy(HERE / "conf.py", pages)
    shutil.copytree(HERE / "templates", pages / "_templates")
    for source in sources:
        prepare(source, pages, solutions, model)
        if release:
            offer(pages / source.name, release, repository)
    books = {source.name: nbformat.read(source, as_version=4) for source in sources}
    notebooks = [gather.read(source, books[source.name], pages) for source in sources]
    others = _linked(books, pages)
    if solutions:  # instructors' pages
        others.append(Path(shutil.copy(HERE.parent / "README.md", pages / gather.GUIDE)))
        others.append(Path(shutil.copy(HERE.parent / "semester.md", pages)))
    if others and others[0].name == PAGES[0]:
        text = gather.with_pictures(others[0].read_text(encoding="utf-8"), notebooks)
        others[0].write_text(text, encoding="utf-8")
    writers = dict.fromkeys(sections.PAGES, sections.write) | {ten_minutes.NAME: ten_minutes.write}
    for name, write in writers.items():
        page = pages / f"{name}.ipynb"
        if write(books, page):
            prepare(page, pages, solutions)
            others.append(page)
    (pages / "index.md").write_text(
        gather.home(notebooks, others, offered(release), _year(sources[0]), repository),
        encoding="utf-8",
    )


def _year(notebook: Path) -> int | None:
    """Return the year of the project that holds a notebook, or None where nothing says it."""
    year = release_date(notebook.parent.parent)[0]
    return year if year > UNKNOWN else None


def _linked(books: dict[str, NotebookNode], pages: Path) -> list[Path]:
    """Return the pages of text that the notebooks name, and the course's own.

    The others, which are an author's notes, are deleted. Of their links to notebooks that are not
    among `books` only the text is left.
    """
    named = "".join(cell.source for book in books.values() for cell in book.cells)
    link = re.compile(r"\[([^]]*)\]\((\w+\.ipynb)[^)]*\)")
    kept = []
    for page in sorted(pages.glob("*.md"), key=lambda page: (page.name != PAGES[0], page.name)):
        if page.name in named or page.name in PAGES:
            text = page.read_text(encoding="utf-8")
            text = link.sub(lambda match: match[0] if match[2] in books else match[1], text)
            page.write_text(text, encoding="utf-8")
            kept.append(page)
        else:
            page.unlink()
    return kept


def _copy_own_files(static: Path) -> None:
    """Put our style and scripts into `static`."""
    shutil.copytree(HERE / "static", static, dirs_exist_ok=True)
    (static / "icons.css").write_text(icons.style(), encoding="utf-8")
    (static / "figures").mkdir()
    for name in script_names():
        (static / "figures" / f"{name}.js").write_text(script(name), encoding="utf-8")
    shutil.copy(files("plotly") / "package_data" / "plotly.min.js", static)  # for charts.js


def _run_sphinx(pages: Path, site: Path, doctrees: Path, repository: str = "") -> None:
    """Run Sphinx on `pages`; every warning is an error, because readers would see its effect."""
    settings = ["-b", "html", "-q", "-N", "-W", "--keep-going", "-d", doctrees]
    settings += ["-D", f"course_repository={repository}"]
    command = [sys.executable, "-m", "sphinx", *settings, pages, site]
    done = subprocess.run(command, capture_output=True, text=True)
    if done.returncode:
        raise SiteError("Sphinx says:\n" + _readable(done.stderr, pages))


def _readable(messages: str, pages: Path) -> str:
    """Name notebook, cell and line instead of Sphinx's path and running number."""

    def place(match: re.Match) -> str:
        # MyST-NB counts 10000 lines for each cell.
        cell, line = divmod(int(match[2]), 10000)
        return f"{match[1]}, cell {cell}, line {line}:" if cell else f"{match[1]}, line {line}:"

    messages = messages.replace(f"{pages.resolve()}/", "").replace(f"{pages}/", "")
    return re.sub(r"(\S+\.ipynb):(\d+):", place, messages).strip()
