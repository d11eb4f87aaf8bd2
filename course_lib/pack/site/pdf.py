"""The pages of a site as one PDF, printed by a browser without a window.

It has a title, contents, and the articles.
"""

import re
import tempfile
from datetime import date
from importlib.metadata import version
from pathlib import Path

from bs4 import BeautifulSoup

from course_lib.pack.files import write_atomically
from course_lib.pack.photograph import find_browser, headless
from course_lib.pack.release.bundle import release_date
from course_lib.pack.site import SiteError, ten_minutes


def check_browser() -> None:
    """Raise SiteError if there is no browser that could print."""
    try:
        find_browser()
    except TimeoutError as error:
        raise SiteError(f"A browser prints the PDF, and {error}.") from error


def write_pdf(site: Path, file: Path) -> None:
    """Print a site to `file`; raises SiteError if there is no browser, or it prints nothing."""
    # Only what is printed says on which page a chapter begins, so it is printed twice: a browser
    # cannot write a page's number beside a link to it.
    pages = first_pages(_print(site, _book(site, {})))
    content = _print(site, _book(site, pages))
    write_atomically(file, name_bookmarks_once(content), mode=0o644)


def _print(site: Path, text: str) -> bytes:
    """Return the PDF that a browser prints of a page of a site."""
    book = site / "book.html"  # beside the pictures that it shows
    book.write_text(text, encoding="utf-8")
    # Not in /tmp, to which a browser that Ubuntu installs as a snap cannot write.
    with tempfile.TemporaryDirectory(dir=site.parent, prefix="pdf-") as folder:
        file = Path(folder, "book.pdf").resolve()
        try:  # page numbers are the style sheet's
            headless(
                book,
                "--no-pdf-header-footer",
                "--generate-pdf-document-outline",
                f"--print-to-pdf={file}",
            )
        except TimeoutError as error:
            raise SiteError(f"A browser prints the PDF, and {error}.") from error
        finally:
            book.unlink()
        if not file.is_file():
            raise SiteError("The browser printed nothing.")
        return file.read_bytes()


def first_pages(content: bytes) -> dict[str, int]:
    """Return the page on which each anchor of a PDF stands, counted from 1.

    Chromium writes pages, in their order, and anchors as plain text. In a PDF that is written in
    another way nothing is found, and the contents have no numbers.
    """
    objects = re.findall(rb"(\d+) 0 obj\s*<<\s*/Type\s*/Page\b", content)
    numbers = {page: number for number, page in enumerate(objects, 1)}
    anchors = re.findall(rb"/(?!Dest )(\S+) \[(\d+) 0 R /XYZ", content)
    return {
        name.decode(errors="replace"): numbers[page] for name, page in anchors if page in numbers
    }


def name_bookmarks_once(content: bytes) -> bytes:
    """Return a PDF in which no bookmark says its name twice.

    Chromium repeats the name of a heading that it moves to the next page. Spaces behind the name
    keep the length of the file, which lists the places of its parts.
    """

    def halve(match: re.Match) -> bytes:
        begin, name, end = match.groups()
        half = name[: len(name) // 2]
        if len(name) % 2 or half + half != name:
            return match[0]
        return begin + half + end + b" " * len(half)

    content = re.sub(rb"(/Title \()((?:\\.|[^()\\])+)(\)(?=\s*/Dest))", halve, content)
    # Names with other letters than Latin ones are UTF-16, in hexadecimal digits after a mark.
    return re.sub(rb"(/Title <FEFF)([0-9A-F]+)(>(?=\s*/Dest))", halve, content)


def _book(site: Path, pages: dict[str, int]) -> str:
    """Return one page of all articles but the home page's: notation, notebooks, then the others.

    The contents have the numbers of `pages`, {chapter: page}, where these are known.
    """
    names = [
        page.name
        for page in site.glob("*.html")
        if page.stem not in ("index", "search", "genindex", "book", ten_minutes.NAME)
    ]
    names.sort(key=lambda name: (name != "notation.html", not name[0].isdigit(), name))
    frame = _read(site / "index.html")
    for part in frame.select(
        "script, #jb-print-docs-body, .sidebar, .bd-header, .bd-header-article, .prev-next-area"
    ):
        part.decompose()
    title, article = frame.title.string, frame.find("article")
    article.clear()
    contents = frame.new_tag("ol", attrs={"class": "book-contents"})
    article.append(frame.new_tag("h1", string=title))
    day = date(*release_date(Path())[:3])
    article.append(frame.new_tag("p", string=f"Version {version('course_lib')}, {day:%-d %B %Y}"))
    article.append(contents)
    for name in names:
        page = _renamed(_read(site / name).find("article"), name, set(names))
        chapter = frame.new_tag("section", attrs={"class": "chapter", "id": Path(name).stem})
        line = frame.new_tag("li")
        heading = page.find("h1").get_text().strip()
        line.append(frame.new_tag("a", href=f"#{Path(name).stem}", string=heading))
        if Path(name).stem in pages:
            number = str(pages[Path(name).stem])
            line.append(frame.new_tag("span", attrs={"class": "page-number"}, string=number))
        contents.append(line)
        chapter.extend(page.contents[:])
        article.append(chapter)
    return str(frame)


def _read(page: Path):
    return BeautifulSoup(page.read_text(encoding="utf-8"), "html.parser")


def _renamed(article, name: str, names: set[str]):
    """Return an article whose anchors have the page's name before them.

    Its links lead to such anchors.
    """
    for part in article.select("script, .headerlink, #course-symbols"):
        part.decompose()
    for section in article.select("section.more > details"):
        section["open"] = ""  # else paper leaves it out
    for part in article.select("[id]:not([id^=MJX])"):
        part["id"] = f"{Path(name).stem}-{part['id']}"
    for link in article.select("a[href]"):
        page, _, anchor = link["href"].partition("#")
        if (page or name) in names:
            link["href"] = "-".join(filter(None, [f"#{Path(page or name).stem}", anchor]))
    return article
