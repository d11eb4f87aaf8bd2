"""Remove what tools put on pages without need, and the files that no page loads any more."""

import re
import shutil
from pathlib import Path

# On every page: a font of 1,500 icons as a script, and footers with nothing in them.
NOT_NEEDED = re.compile(
    r'<script[^>]*fontawesome\.js[^>]*></script>|<footer class="bd-footer.*?</footer>', re.DOTALL
)
# Sphinx's own search, which the theme loads on every page.
SEARCH = re.compile(r"<script[^>]*(?:searchtools|language_data|searchindex)\.js[^>]*></script>")
# Code as Pygments colours it. A page has thousands of its spans.
CODE = re.compile(r'(?<=<div class="highlight"><pre>).*?(?=</pre>)', re.DOTALL)
# A rule of the style of code: its theme, its class (none for the ground), what it says.
RULE = re.compile(
    r'^html\[data-theme="(\w+)"\] \.highlight (?:\.(\w+) )?\{ (.*?);? \}', re.MULTILINE
)
FILES = (
    "vendor",
    "locales",
    "scripts/*.map",
    "scripts/fontawesome.js",
    "styles/*.map",
    "searchtools.js",
    "language_data.js",
)


def plain_classes(style: str) -> list[str]:
    """Return the classes of code that no theme colours otherwise than its ground, sorted.

    Without a span their words have the colour of the page's text. `style` is the sheet that Sphinx
    writes for code.
    """
    rules = RULE.findall(style)
    grounds = {theme: says for theme, name, says in rules if not name}
    differing = {name for theme, name, says in rules if name and not grounds[theme].endswith(says)}
    return sorted({name for _, name, _ in rules if name} - differing)


def finish(site: Path) -> None:
    """Correct all pages of a site in place, and delete files."""
    style = (site / "_static/pygments.css").read_text(encoding="utf-8")
    plain = re.compile(f'<span class="(?:{"|".join(plain_classes(style))})">([^<]*)</span>')
    for page in site.glob("*.html"):
        text = NOT_NEEDED.sub("", page.read_text(encoding="utf-8"))
        text = CODE.sub(lambda code: plain.sub(r"\1", code[0]), text)
        if page.stem != "search":
            text = SEARCH.sub("", text)
        # A script chooses light or dark, which paper and readers without scripts do not wait for.
        text = text.replace('data-theme="auto"', 'data-theme="light"')
        # A screen reader shall read the line that the page shows, "Solution", not MyST-NB's name
        # for all folded cells.
        text = text.replace(' aria-label="Toggle hidden content"', "")
        # The name of the search button holds the words that it shows, "Search Ctrl+K".
        text = re.sub(
            r'(<button class="[^"]*search-button-field[^>]*?) aria-label="Search"', r"\1", text
        )
        page.write_text(text, encoding="utf-8")
    for path in (path for name in FILES for path in site.glob(f"_static/{name}")):
        shutil.rmtree(path) if path.is_dir() else path.unlink()
