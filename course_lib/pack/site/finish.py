"""Remove what the theme puts on pages without need, and the files that no page loads any more."""

import re
import shutil
from pathlib import Path

# On every page: a font of 1,500 icons as a script, and footers with nothing in them.
NOT_NEEDED = re.compile(
    r'<script[^>]*fontawesome\.js[^>]*></script>|<footer class="bd-footer.*?</footer>', re.DOTALL
)
# Sphinx's own search, which the theme loads on every page.
SEARCH = re.compile(r"<script[^>]*(?:searchtools|language_data|searchindex)\.js[^>]*></script>")
FILES = (
    "vendor",
    "locales",
    "scripts/*.map",
    "scripts/fontawesome.js",
    "styles/*.map",
    "searchtools.js",
    "language_data.js",
)


def finish(site: Path) -> None:
    """Correct all pages of a site in place, and delete files."""
    for page in site.glob("*.html"):
        text = NOT_NEEDED.sub("", page.read_text(encoding="utf-8"))
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
