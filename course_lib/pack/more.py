"""Which cells of a notebook are in More, its folded sections.

These need only the core, and can be left out of a release.
"""

import re

from nbformat import NotebookNode

TAG = "more"  # of the cell with the section's heading


def heading_level(cell: NotebookNode) -> int:
    """Return the level of the heading with which a cell begins, or 0."""
    if cell.cell_type != "markdown":
        return 0
    heading = re.match(r"(#+) ", cell.source)
    return len(heading[1]) if heading else 0


def cells_of_more(notebook: NotebookNode) -> list[bool]:
    """Return for each cell whether it is in More.

    More goes from a tagged heading to the next one of its or a higher level.
    """
    is_in_more = []
    folded = 0  # the level of the heading of the section of More, or 0 outside of one
    for cell in notebook.cells:
        level = heading_level(cell)
        if folded and 0 < level <= folded:
            folded = 0
        if level and not folded and TAG in cell.metadata.get("tags", []):
            folded = level
        is_in_more.append(folded > 0)
    return is_in_more
