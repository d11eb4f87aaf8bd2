"""The page with which a stranger begins: ten minutes of the first notebook, from its own cells.

It has a prediction, a figure to move, one line of code with what its check says, and what comes
next.
"""

from copy import deepcopy
from pathlib import Path
from unittest import mock

import nbformat
import numpy as np
from nbformat import NotebookNode
from nbformat.v4 import new_code_cell, new_markdown_cell, new_notebook, new_output

from course_lib.lessons.rotations import check

NAME = "ten_minutes"

BEGIN = """# Ten minutes

This page takes a prediction, a figure and an exercise from the notebook [*{title}*]({file}).

## Predict

The function `rot_z` returns the matrix of a rotation about the z axis, and `rot_x` that of a
rotation about the x axis. The angle `np.pi / 2` is 90 degrees, and `@` multiplies two matrices."""
MOVE = """## Move it

Test your prediction with the aircraft below. *Play* makes the two rotations, one after the other,
and the slider *Step* stops between them. One of the aircraft makes the product of the question, and
the other one makes the two rotations in the opposite order."""
WRITE = "## Write one line"
SAY = """The line of the following answer that begins with `R =` is wrong. The check says what
should hold, for which point the answer fails, and what the answer was. Which sign would you
change?"""
NEXT = """## What comes next

In the notebook you correct the line, and the check judges your code at once.

- [Read the notebook *{title}*]({file}), with all its figures.
- [Run the notebooks yourself](index.md#Run-it-yourself). One command opens them, with all checks.
- [Look at all six notebooks](index.md#Six-notebooks), up to a robot that grasps a mug."""

# What a student may write, and what the check of the first notebook says of it.
ANSWER = """def rotate_point(p, a):
    c, s = np.cos(a), np.sin(a)
    R = np.array([[c, s], [-s, c]])
    return R @ p

check.rotate_point(rotate_point)"""

PREDICT = "**Predict.**"  # begins the question, in a cell that explains other things before it
HOW_TO_ANSWER = "Answer in the next cell"  # begins what a page does not need
# The cells that the page takes, by their names in the notebook.
QUESTION, CHOICES, FIGURE, POINT, TASK = (
    "readings",
    "predict-order",
    "toy-order",
    "point",
    "task-rotate-point",
)


def write(books: dict[str, NotebookNode], path: Path) -> bool:
    """Write the page as a notebook, and return whether the first notebook has all of its cells.

    `books` are {file name: notebook}.
    """
    file, book = next(iter(books.items()))
    cells = {cell.id: deepcopy(cell) for cell in book.cells}
    if not {QUESTION, CHOICES, FIGURE, POINT, TASK} <= set(cells):
        return False
    title = book.cells[0].source.splitlines()[0].removeprefix("# ")
    question = cells[QUESTION].source.partition(PREDICT)[2].partition(HOW_TO_ANSWER)[0]
    _, _, point = cells[POINT].source.partition("\n")  # without its heading
    said = new_output("display_data", data={"text/html": check_of(ANSWER)})
    page = [
        new_markdown_cell(BEGIN.format(title=title, file=file)),
        new_markdown_cell(question.strip()),
        _without_code(cells[CHOICES]),
        new_markdown_cell(MOVE),
        _without_code(cells[FIGURE]),
        new_markdown_cell(f"{WRITE}\n\n{point.strip()}"),
        cells[TASK],
        new_markdown_cell(SAY),
        new_code_cell(ANSWER, outputs=[said], execution_count=1),
        new_markdown_cell(NEXT.format(title=title, file=file)),
    ]
    for number, cell in enumerate(page):
        cell.id = f"{NAME}-{number}"  # else random, and no two builds the same
    nbformat.write(new_notebook(cells=page, metadata=book.metadata), path)
    return True


def _without_code(cell: NotebookNode) -> NotebookNode:
    """Return a code cell of which the page shows the outputs alone."""
    cell.metadata["tags"] = [*cell.metadata.get("tags", []), "remove-input"]
    return cell


def check_of(answer: str) -> str:
    """Return as HTML what the check says of an answer to an exercise of the first notebook."""
    outputs = []
    with mock.patch("IPython.display.display", lambda data, **options: outputs.append(data)):
        exec(answer, {"np": np, "check": check})
    # Nothing changes here that would have to be read out.
    return outputs[-1]["text/html"].replace(' role="status"', "")
