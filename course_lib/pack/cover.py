"""The picture that stands for a notebook, on the home page of the site and in README.md."""

from collections.abc import Collection

from nbformat import NotebookNode

COVER = "cover"  # the tag of the cell whose picture it is


def cover_of(notebook: NotebookNode, kinds: Collection[str]) -> tuple[NotebookNode | None, str]:
    """Return the output that holds the cover of a notebook, and the picture's MIME type.

    It is the first picture of the cell that is tagged for it, or else of the notebook. Without a
    picture the output is None, and the type is "".

    `kinds` are the MIME types of pictures, the preferred one first.
    """
    cells = [cell for cell in notebook.cells if cell.cell_type == "code"]
    tagged_first = sorted(cells, key=lambda cell: COVER not in cell.metadata.get("tags", []))
    for cell in tagged_first:
        for output in cell.outputs:
            for kind in kinds:
                if kind in output.get("data", {}):
                    return output, kind
    return None, ""
