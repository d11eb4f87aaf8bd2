"""The search: an index of sections, and the page that searches it. It works from a folder, without a network."""

import html
import json
import re
from pathlib import Path

NAME = "sections.js"
PAGE = """<section id="search"><h1>Search</h1>
<form class="bd-search"><input type="search" class="form-control" id="search-words" name="q" autocomplete="off"
aria-label="Words to find in all sections" spellcheck="false"></form>
<p id="search-count" aria-live="polite"></p>
<ol id="search-results"></ol></section>"""

SECTION = re.compile(r'<section [^>]*?id="([^"]+)">')
CODE = re.compile(r"<pre.*?</pre>", re.DOTALL)
HEADING = re.compile(r"<h([1-6])>(.*?)</h\1>", re.DOTALL)
# Not in the index: formulas (pictures and MathML), the data of figures, and the link beside each heading.
SILENT = re.compile(
    r"<(script|style|svg)\b.*?</\1>|<summary>.*?</summary>|<a class=\"headerlink\".*?</a>",
    re.DOTALL,
)


def write(site: Path) -> None:
    """Write the index of all pages of a site: page, its title, section, its heading, its words, whether on an error."""
    entries = []
    for page in sorted(site.glob("*.html")):
        if page.name != "search.html":
            entries += _sections(page)
    lines = ",\n".join(json.dumps(entry, ensure_ascii=False) for entry in entries)
    (site / "_static" / NAME).write_text(f"window.courseSections = [\n{lines}\n];\n", encoding="utf-8")


def _sections(page: Path) -> list[list[str]]:
    """Return [page, title, section's id, heading, words, whether it is on an error] for each section of a page."""
    article = re.search(r"<article.*?>(.*)</article>", page.read_text(encoding="utf-8"), re.DOTALL)
    if not article:
        return []
    parts = SECTION.split(article[1])
    found, title, on_errors = [], "", False
    for name, body in zip(parts[1::2], parts[2::2], strict=True):
        heading = HEADING.search(body)
        words = _words(heading[2]) if heading else ""
        title = title or words
        if heading and heading[1] in "12":
            on_errors = page.stem == "errata" or words.startswith("Appendix")
        found.append([page.name, title, name, words, _words(HEADING.sub("", body, count=1)), on_errors])
    return found


def _words(page: str) -> str:
    """Return the text of a part of a page, on one line: first the sentences, then code and what it prints."""
    page = CODE.sub(" ", page) + " ".join(part[0] for part in CODE.finditer(page))
    text = re.sub(r"<[^>]*>", " ", re.sub(r"</?(?:span|m[a-z]+|em|strong|code|a)\b[^>]*>", "", SILENT.sub(" ", page)))
    return " ".join(html.unescape(text).split())
