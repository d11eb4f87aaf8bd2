"""Which cells of a notebook are More: folded sections, which need only the core and can be left out of a release."""

import re

TAG = "more"  # of the cell with the section's heading


def heading_level(cell) -> int:
    """Return the level of the heading with which a cell begins, or 0."""
    found = re.match(r"(#+) ", cell.source) if cell.cell_type == "markdown" else None
    return len(found[1]) if found else 0


def cells_of_more(notebook) -> list[bool]:
    """Return for each cell whether it is in More: from a tagged heading to the next one of its or a higher level."""
    found, folded = [], 0
    for cell in notebook.cells:
        level = heading_level(cell)
        if folded and 0 < level <= folded:
            folded = 0
        if level and not folded and TAG in cell.metadata.get("tags", []):
            folded = level
        found.append(folded > 0)
    return found
