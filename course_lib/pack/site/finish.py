"""Correct Sphinx's pages: remove what the theme repeats or loads without need, and add what it leaves out."""

import html
import re
import shutil
from pathlib import Path

# Loaded on every page by the theme: a font of 1,500 icons as a script, and the search's index.
NOT_NEEDED = re.compile(
    r'<script[^>]*src="[^"]*(?:fontawesome|searchtools|language_data|searchindex)\.js[^"]*"></script>|'
    r'<link rel="preload"[^>]*>|<meta name="(?:viewport|docsearch:[a-z]*)"[^>]*>|'
    r"<!--.*?-->",
    re.DOTALL,
)
EMPTY = re.compile(
    r'<footer class="bd-footer(?:-content)?">[^\w]*(?:<div class="bd-footer-content__inner container">\s*</div>\s*)?'
    r"</footer>",
    re.DOTALL,
)
ICON = (
    "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 32 32' fill='none' stroke='%230b5fff' stroke-width='4' "
    "stroke-linecap='round'><path d='M4 28h12M10 28V18L18 8l9 6'/><circle cx='10' cy='18' r='2'/>"
    "<circle cx='18' cy='8' r='2'/></svg>"
)
# The theme's buttons get the names that they show, for screen readers and for control by voice.
NAMES = {
    ' title="Search" aria-label="Search"': "",
    'class="btn btn-sm pst-navbar-icon search-button search-button__button pst-js-only"': (
        'class="btn btn-sm pst-navbar-icon search-button search-button__button pst-js-only" aria-label="Search"'
    ),
    # The theme's script chooses light or dark; without it there would be no colours at all.
    'data-theme="auto"': 'data-theme="light"',
    # Buttons that need JavaScript are hidden without it.
    "btn-fullscreen-button ": "btn-fullscreen-button pst-js-only ",
    'class="sidebar-toggle ': 'class="pst-js-only sidebar-toggle ',
    'aria-label="Main"': 'aria-label="Pages of the course"',
    'title="Toggle primary sidebar"': 'title="Pages of the course" aria-label="Pages of the course"',
    'title="Toggle secondary sidebar"': 'title="On this page" aria-label="On this page"',
    # Above the printed page; the page's own title is its one heading of the first level.
    "<h2> On this page </h2>": '<p class="print-contents">Contents</p>',
}


def finish(site: Path) -> None:
    """Correct all pages of a site in place, and delete the files that none of them loads any more."""
    for page in site.glob("*.html"):
        page.write_text(_finished(page.read_text(encoding="utf-8")), encoding="utf-8")
    static = site / "_static"
    shutil.rmtree(static / "vendor", ignore_errors=True)
    for name in ("scripts/fontawesome.js", "searchtools.js", "language_data.js", "english-stemmer.js"):
        (static / name).unlink(missing_ok=True)
    for style in static.rglob("*.css"):  # the font is that of the icons
        style.write_text(re.sub(r"@font-face\s*\{[^}]*\}", "", style.read_text(encoding="utf-8")), encoding="utf-8")
    # Source maps are for the theme's authors, and its translations for pages in other languages.
    for source_map in site.rglob("*.map"):
        source_map.unlink()
    shutil.rmtree(static / "locales", ignore_errors=True)


PRINTED_TITLE = re.compile(r'(<div id="jb-print-docs-body"[^>]*>\s*)<h1>(.*?)</h1>', re.DOTALL)


def _finished(page: str) -> str:
    page = EMPTY.sub("", NOT_NEEDED.sub("", page))
    page = PRINTED_TITLE.sub(r'\1<p class="print-title">\2</p>', page)
    for old, new in NAMES.items():
        page = page.replace(old, new)
    title = html.unescape(re.search(r"<title>(.*?)</title>", page, re.DOTALL)[1]).strip()
    parts = list(dict.fromkeys(part.strip() for part in re.split(" [—-] ", title)))
    title = html.escape(" — ".join(parts))
    page = re.sub(r"<title>.*?</title>", lambda _: f"<title>{title}</title>", page, count=1, flags=re.DOTALL)
    head = [
        '<meta name="viewport" content="width=device-width, initial-scale=1">',
        f'<link rel="icon" href="data:image/svg+xml,{ICON}">'.replace("<svg", "%3Csvg", 1),
    ]
    if words := _first_words(page):
        head.insert(1, f'<meta name="description" content="{words}">')
    return page.replace('<meta charset="utf-8" />', '<meta charset="utf-8">' + "\n    ".join(["", *head]), 1)


def _first_words(page: str) -> str:
    """Return the first paragraph of a page's text, for search engines."""
    article = page.partition("<article")[2]
    for paragraph in re.findall(r"<p>(.*?)</p>", article, re.DOTALL):
        words = " ".join(re.sub(r"<svg.*?</svg>|<[^>]*>", "", paragraph, flags=re.DOTALL).split())
        if len(words) > 60:
            return words if len(words) <= 200 else words[:200].rsplit(" ", 1)[0] + " …"
    return ""
