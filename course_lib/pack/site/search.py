"""Write what the search looks through: the text of each section of each page.

Sphinx's own index leaves out short words, symbols and numbers, knows no sections, and reads the
lines of context with requests that browsers refuse to pages in a folder.
"""

import json
import re
from pathlib import Path

from bs4 import BeautifulSoup

from course_lib.pack.site import ten_minutes

INDEX = "searchindex.js"
# What is not read as text: the figures' data, and the pictures of formulas, whose words are MathML.
# They are nine tenths of a page, so they are taken out before it is parsed.
DATA = re.compile(r"<(script|style|svg)\b.*?</\1>", re.DOTALL)
NO_TEXT = "button, .headerlink, .expanded, #course-symbols"
# In MathML: spaces, and signs for what is not printed, such as an applied function. A formula is
# one word.
NOT_PRINTED = re.compile(r"[\s\u2061-\u2064]+")
# An element whose text does not continue that of the element before it.
BLOCKS = ["p", "li", "td", "th", "pre", "div", "figcaption", "summary", "dt", "dd", "br"]


def write_index(site: Path) -> None:
    """Write the search's index of a site beside its pages, as a script that pages can load."""
    sections = []
    for page in sorted(site.glob("*.html")):
        if page.stem not in ("search", ten_minutes.NAME):  # its words are those of a notebook
            sections += sections_of(page)
    data = json.dumps(sections, ensure_ascii=False, separators=(",", ":"))
    (site / INDEX).write_text(f"window.courseSections = {data};\n", encoding="utf-8")


def sections_of(page: Path) -> list[dict[str, str]]:
    """Return the sections of a page in their order.

    Each is {"page": the page's title, "link": page and anchor, "title": the section's heading,
    "text": the text of the section without that of the sections inside it}.
    """
    text = DATA.sub("", page.read_text(encoding="utf-8"))
    article = BeautifulSoup(text, "html.parser").find("article")
    for part in article.select(NO_TEXT):
        part.decompose()
    for formula in article.select(".math"):
        formula.replace_with(NOT_PRINTED.sub("", formula.get_text()))
    for block in article.find_all(BLOCKS):
        block.append("\n")
    title = _line(article.find("h1").get_text())
    sections = []
    # An inner section is read, and taken away, before the one around it.
    for section in reversed(article.find_all("section")):
        heading = section.find(re.compile("^h[1-6]$"))
        name = _line(heading.extract().get_text()) if heading else title
        link = page.name if name == title else f"{page.name}#{section['id']}"
        text = _line(section.extract().get_text())
        sections.append({"page": title, "link": link, "title": name, "text": text})
    return sections[::-1]


def _line(text: str) -> str:
    return " ".join(text.split())
