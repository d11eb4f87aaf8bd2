"""Pages that are one file each, with styles, scripts and pictures inside; links lead to the pages beside it."""

import base64
import mimetypes
import re
import shutil
from pathlib import Path

from bs4 import BeautifulSoup

# Elements that lead to other pages.
LEFT_OUT = """link[rel=search], link[rel=next], link[rel=prev], link[rel=preload], .search-button, .primary-toggle,
#pst-search-dialog, #pst-primary-sidebar-modal"""


def make_single(site: Path) -> None:
    """Turn the pages of a site into files that need no other, and delete all others except hidden files."""
    pages = [page for page in site.glob("*.html") if page.name not in ("search.html", "genindex.html")]
    made = {page.name: _whole(page, {page.name for page in pages}) for page in pages}
    for old in site.glob("[!.]*"):
        shutil.rmtree(old) if old.is_dir() else old.unlink()
    for name, text in made.items():
        (site / name).write_text(text, encoding="utf-8")


def _whole(page: Path, beside: set[str]) -> str:
    """Return a page with everything that it loads inside, and links only to the pages `beside` it and to the web."""
    soup = BeautifulSoup(page.read_text(encoding="utf-8"), "html.parser")
    for element in soup.select(LEFT_OUT):
        element.decompose()
    for link in soup.select("link[rel=stylesheet]"):
        style = soup.new_tag("style")
        style.string = _style(_beside(page, link["href"]))
        link.replace_with(style)
    for image in soup.select("img[src]"):
        image["src"] = _as_link(_beside(page, image["src"]))
    late = []
    for script in soup.select("script[src]"):
        # "</script" would end the element; in a script's strings and patterns "<\/script" is the same.
        script.string = _beside(page, script["src"]).read_text(encoding="utf-8").replace("</script", r"<\/script")
        del script["src"]
        if script.has_attr("defer"):  # which has no effect inside a page; at its end the script runs as late
            del script["defer"]
            late.append(script.extract())
    for script in late:
        soup.body.append(script)
    for link in soup.select("a[href]"):
        here = re.match(r"#|data:|https?:|mailto:", link["href"]) or link["href"].partition("#")[0] in beside
        if not here:
            link.unwrap()
    return str(soup)


def _style(file: Path) -> str:
    """Return a style sheet with the style sheets, fonts and pictures that it names inside."""
    text = file.read_text(encoding="utf-8")
    text = re.sub(r"""@import ["']([^"']+)["'];""", lambda found: _style(file.parent / found[1]), text)
    named = r"""url\(["']?(?!data:)([^"')?#]+)[^)]*\)"""
    return re.sub(named, lambda found: f"url({_as_link(file.parent / found[1])})", text)


def _beside(page: Path, link: str) -> Path:
    """Return the file that a link of a page names."""
    return page.parent / link.split("?")[0]


def _as_link(file: Path) -> str:
    """Return a file's contents as a link."""
    kind = {".webp": "image/webp", ".woff2": "font/woff2"}.get(file.suffix) or mimetypes.guess_type(file.name)[0]
    return f"data:{kind};base64,{base64.b64encode(file.read_bytes()).decode()}"
