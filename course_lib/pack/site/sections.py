"""Pages that put one section of every notebook together.

They are the reports' errors with remarks on them, and the sources.
"""

import re
from copy import deepcopy
from pathlib import Path

import nbformat
from nbformat import NotebookNode
from nbformat.v4 import new_markdown_cell, new_notebook

from course_lib.pack.site.answers import hide

LINES = "The lines that compute it"

# Each page: its beginning, and for each of its parts the heading in the notebooks and what begins
# the part.
PAGES = {
    "errata": (
        """# Errata

This page puts the errors in the published reports together, and remarks on the reports, from the
appendices of the notebooks. Each title links to its notebook, which has the functions and exercises
that are named here. The words *above* and *this notebook* refer to that notebook.""",
        {
            "### Errors in it": """## Errors

Each entry quotes what a report prints, gives the evidence against it, and says what is right.""",
            "### Remarks": """## Remarks

The remarks are about choices that we would make differently. These choices are not errors.""",
        },
    ),
    "sources": (
        """# Sources

This page lists the books, articles and reports that each notebook uses.""",
        {"## Sources": ""},
    ),
}


def write(books: dict[str, NotebookNode], path: Path) -> bool:
    """Write the page that `path` names, and return whether it has any contents.

    The page is a notebook, written from {file name: notebook}.
    """
    begin, parts = PAGES[path.stem]
    cells = [new_markdown_cell(begin)]
    for heading, words in parts.items():
        of_part = []
        for name, book in books.items():
            of_part += _titled(heading, name, book)
        if of_part and words:
            cells.append(new_markdown_cell(words))
        cells += of_part
    if len(cells) == 1:
        return False
    for number, cell in enumerate(cells):
        cell.id = f"{path.stem}-{number}"  # else random, and no two builds the same
    metadata = next(iter(books.values())).metadata
    nbformat.write(new_notebook(cells=cells, metadata=metadata), path)
    return True


def _titled(heading: str, name: str, book: NotebookNode) -> list:
    """Return the cells of a notebook's section.

    Its heading becomes the notebook's title with a link to the notebook.
    """
    text = "\n".join(cell.source for cell in book.cells if cell.cell_type == "markdown")
    title = re.search(r"^# (.+)|$", text, re.MULTILINE)[1] or Path(name).stem
    cells = section(book, heading)
    for cell in cells:
        if cell.cell_type == "markdown":
            cell.source = cell.source.replace("](#", f"]({name}#")
    if cells:
        level = heading.partition(" ")[0]
        cells[0].source = cells[0].source.replace(heading, f"{level} [{title}]({name})", 1)
    return cells


def section(book, heading: str) -> list:
    """Return copies of the cells from a heading to the next one of its or a higher level.

    Code is folded.
    """
    copies = []
    inside = False
    begins = re.compile(rf"^(?=#{{1,{heading.index(' ')}}} )", re.MULTILINE)
    for cell in book.cells:
        if cell.cell_type == "markdown":
            for part in begins.split(cell.source):
                if begins.match(part):
                    inside = part.splitlines()[0].strip() == heading
                if inside and part.strip():
                    copies.append(new_markdown_cell(part))
        elif inside and cell.cell_type == "code":
            copies.append(deepcopy(cell))
            hide(copies[-1], "hide-input", LINES)
    return copies
