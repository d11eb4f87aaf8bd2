"""Find out whether a site is still what a build of the same notebooks would write."""

import hashlib
from importlib.metadata import version
from pathlib import Path

import course_lib

TOOLS = ("sphinx", "myst-nb", "sphinx-book-theme", "sphinx-mathjax-offline", "mini-racer", "plotly", "nbformat")
MADE_FROM = ".made-from"  # in the site's folder: what it was made from, and what was made


def made_from(notebooks: Path, *settings) -> str:
    """Return a hash of all that a site depends on: the notebooks' folder, this package, the generator, settings."""
    tools = [f"{name} {version(name)}" for name in TOOLS]
    contents = [_contents(folder) for folder in (notebooks, Path(course_lib.__file__).parent)]
    return hashlib.sha256(repr([contents, tools, settings]).encode()).hexdigest()


def sign(site: Path, source: str) -> None:
    """Note in a site's folder what it was made from, and what its files are."""
    (site / MADE_FROM).write_text(f"{source} {_contents(site)}\n", encoding="utf-8")


def is_unchanged(site: Path, source: str) -> bool:
    """Return whether a site was made from `source` and nobody has changed it since."""
    noted = site / MADE_FROM
    return noted.is_file() and noted.read_text(encoding="utf-8") == f"{source} {_contents(site)}\n"


def _contents(folder: Path) -> str:
    """Return a hash of the names and contents of a folder's files, except hidden and compiled ones."""
    total = hashlib.sha256()
    for file in sorted(folder.rglob("*")):
        inside = file.relative_to(folder)
        if file.is_file() and "__pycache__" not in inside.parts and not any(p.startswith(".") for p in inside.parts):
            total.update(f"{inside.as_posix()} {hashlib.sha256(file.read_bytes()).hexdigest()}\n".encode())
    return total.hexdigest()
