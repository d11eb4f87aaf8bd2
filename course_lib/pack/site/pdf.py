"""The pages of a site as one PDF, printed by a browser without a window.

It has a title, contents, and the articles.
"""

from datetime import date
from importlib.metadata import version
from pathlib import Path

from bs4 import BeautifulSoup

from course_lib.pack.photograph import find_browser, headless
from course_lib.pack.release.bundle import release_date
from course_lib.pack.site import SiteError

NEEDED = (
    "A PDF needs Chromium or Chrome: install one, or name it with BROWSER_PATH=/path/to/chromium."
)


def check_browser() -> None:
    """Raise SiteError if there is no browser that could print."""
    try:
        find_browser()
    except TimeoutError as error:
        raise SiteError(NEEDED) from error


def write_pdf(site: Path, file: Path) -> None:
    """Print a site to `file`; raises SiteError if there is no browser, or it prints nothing."""
    book = site / "book.html"  # beside the pictures that it shows
    book.write_text(_book(site), encoding="utf-8")
    file.parent.mkdir(parents=True, exist_ok=True)
    file.unlink(missing_ok=True)
    try:  # page numbers are the style sheet's
        headless(
            book,
            "--no-pdf-header-footer",
            "--generate-pdf-document-outline",
            f"--print-to-pdf={file.resolve()}",
        )
    except TimeoutError as error:
        raise SiteError(f"{NEEDED} ({error})") from error
    finally:
        book.unlink()
    if not file.is_file():
        raise SiteError("The browser printed nothing.")


def _book(site: Path) -> str:
    """Return one page of all articles but the home page's, notebooks first."""
    names = [
        page.name
        for page in site.glob("*.html")
        if page.stem not in ("index", "search", "genindex", "book")
    ]
    names.sort(key=lambda name: (not name[0].isdigit(), name))
    frame = _read(site / "index.html")
    for part in frame.select(
        "script, #jb-print-docs-body, .sidebar, .bd-header, .bd-header-article, .prev-next-area"
    ):
        part.decompose()
    title, article = frame.title.string, frame.find("article")
    article.clear()
    contents = frame.new_tag("ol")
    article.append(frame.new_tag("h1", string=title))
    day = date(*release_date(Path())[:3])
    article.append(frame.new_tag("p", string=f"Version {version('course_lib')}, {day:%-d %B %Y}"))
    article.append(contents)
    for name in names:
        page = _renamed(_read(site / name).find("article"), name, set(names))
        chapter = frame.new_tag("section", attrs={"class": "chapter", "id": Path(name).stem})
        contents.append(line := frame.new_tag("li"))
        line.append(
            frame.new_tag(
                "a", href=f"#{Path(name).stem}", string=page.find("h1").get_text().strip()
            )
        )
        chapter.extend(page.contents[:])
        article.append(chapter)
    return str(frame)


def _read(page: Path):
    return BeautifulSoup(page.read_text(encoding="utf-8"), "html.parser")


def _renamed(article, name: str, names: set[str]):
    """Return an article whose anchors have the page's name before them.

    Its links lead to such anchors.
    """
    for part in article.select("script, .headerlink"):
        part.decompose()
    for part in article.select("[id]:not([id^=MJX])"):
        part["id"] = f"{Path(name).stem}-{part['id']}"
    for link in article.select("a[href]"):
        page, _, anchor = link["href"].partition("#")
        if (page or name) in names:
            link["href"] = "-".join(filter(None, [f"#{Path(page or name).stem}", anchor]))
    return article
