"""Pages that put one section of every notebook together: what the report got wrong, and the sources."""

import re
from pathlib import Path

import nbformat
from nbformat.v4 import new_markdown_cell, new_notebook

from course_lib.pack.site.answers import hide

ERRATA, SOURCES = "What the report got wrong", "Sources"
LINES = "The lines that compute it"

BEGIN = {
    ERRATA: """# Errata

What the published report got wrong, gathered from the notebooks: what it claims, the evidence against it, computed, and
what is right.""",
    SOURCES: """# Sources

What each notebook rests on.""",
}


def write(heading: str, sources: list[Path], path: Path) -> bool:
    """Write to `path` a notebook of the sections with that heading; return whether there are any."""
    cells = [cell for source in sources for cell in _titled(heading, source)]
    if not cells:
        return False
    cells.insert(0, new_markdown_cell(BEGIN[heading]))
    for number, cell in enumerate(cells):
        cell.id = f"{path.stem}-{number}"  # else random, and no two builds the same
    metadata = nbformat.read(sources[0], as_version=4).metadata
    nbformat.write(new_notebook(cells=cells, metadata=metadata), path)
    return True


def _titled(heading: str, source: Path) -> list:
    """Return the cells of a notebook's section, under its title, which leads to it, for a heading."""
    book = nbformat.read(source, as_version=4)
    text = "\n".join(cell.source for cell in book.cells if cell.cell_type == "markdown")
    title = re.search(r"^# (.+)", text, re.MULTILINE)
    cells = section(book, heading)
    if cells:
        cells[0].source = cells[0].source.replace(
            f"## {heading}", f"## [{title[1] if title else source.stem}]({source.name})", 1
        )
    return cells


def section(book, heading: str) -> list:
    """Return copies of what stands between a heading of the second level and the next; code is folded shut."""
    found, inside = [], False
    for cell in book.cells:
        if cell.cell_type == "markdown":
            for part in re.split(r"^(?=## )", cell.source, flags=re.MULTILINE):
                if part.startswith("## "):
                    inside = part.splitlines()[0].strip() == f"## {heading}"
                if inside and part.strip():
                    found.append(new_markdown_cell(part))
        elif inside and cell.cell_type == "code":
            hide(cell, "hide-input", LINES)
            found.append(cell)
    return found
