"""A student's copy of a notebook, without solutions.

Stubs stand for solutions, prompts for written answers, and no output is left but a first picture.
"""

import ast
import re

import nbformat
from nbformat import NotebookNode

from course_lib.checks.errors import UNWRITTEN
from course_lib.pack.more import cells_of_more, heading_level
from course_lib.pack.notebooks import tidy
from course_lib.pack.release import PROMPT, ReleaseError
from course_lib.pack.release.students.update.notebook_file import fingerprint

BEGIN, END = "BEGIN SOLUTION", "END SOLUTION"  # anywhere in a line, as nbgrader has it
FOR_GRADERS = (BEGIN, END, "Model answer", "*Rubric")


def students_copy(text: str, name: str, release: str, more: bool = True) -> str:
    """Return the text of a notebook without solutions and outputs.

    The cells of More are left out unless `more`. The first picture stays if it stands before all
    exercises, so that a student who opens the notebook sees it at once. `name` is the notebook's,
    for messages; `release` goes into its metadata. Raises ReleaseError, which names notebook and
    cell, if markers are not paired, a stub would not be a function, or another cell contains words
    for graders.
    """
    notebook = _read(text, name)
    opening = _cell_of_first_picture(notebook)
    picture = opening.outputs if opening else []
    for number, cell in enumerate(notebook.cells, 1):
        place = f"{name}, cell {number}"
        grade_id = cell.metadata.get("nbgrader", {}).get("grade_id")
        if grade_id:
            place += f" ({grade_id})"
        _empty(cell, place)
    if opening:
        opening.outputs = picture
    if not more:
        _leave_out_more(notebook)
    course = {**notebook.metadata.get("course", {}), "release": release}
    notebook.metadata["course"] = course | _record(notebook.cells)
    tidy(notebook)
    return nbformat.writes(notebook, indent=1, ensure_ascii=False, sort_keys=True) + "\n"


def _cell_of_first_picture(notebook: NotebookNode) -> NotebookNode | None:
    """Return the first cell with a picture, or None if there is none before the exercises."""
    for cell in notebook.cells:
        if "nbgrader" in cell.metadata:
            return None
        if _has_picture(cell):
            return cell
    return None


def _record(cells: list[NotebookNode]) -> dict:
    """Return what a release says of its cells, so that an update knows what a student has changed.

    The keys are "stubs", {exercise: hash of its answer cell}, and "cells", the hashes of all others
    in one text, separated by spaces.
    """
    stubs, others = {}, set()
    for cell in cells:
        about = cell.metadata.get("nbgrader", {})
        if about.get("solution"):
            stubs[about["grade_id"]] = fingerprint(cell.source)
        else:
            others.add(fingerprint(cell.source))
    return {"stubs": stubs, "cells": " ".join(sorted(others))}


def _read(text: str, name: str) -> NotebookNode:
    try:
        notebook = nbformat.reads(text, as_version=4)
        nbformat.validate(notebook)
    except (ValueError, LookupError, TypeError, AttributeError, nbformat.ValidationError) as error:
        # Most often a half-resolved merge; the other exceptions come from JSON that is not a
        # notebook.
        raise ReleaseError(
            f"{name} is not a notebook: {str(error).splitlines()[0]:.100}"
        ) from error
    return notebook


# What mentions *More*: words in brackets, the rest of a sentence behind a comma or semicolon, or a
# sentence.
_ON_MORE = re.compile(
    r"\s*\([^()]*\*More\*[^()]*\)"
    r"|[;,][^.;,()]*\*More\*[^.]*(?=\.)"
    r"|(?<=[.?!])\s+[^.;]*\*More\*[^.]*\."
)


def _leave_out_more(notebook: NotebookNode) -> None:
    """Remove the cells of More, and what mentions them in other cells.

    That is the links to them, of which the text stays, and the clauses that name *More*.
    """
    cells_kept, anchors = [], []
    for cell, is_in_more in zip(notebook.cells, cells_of_more(notebook), strict=True):
        if not is_in_more:
            cells_kept.append(cell)
        elif heading_level(cell):
            title = cell.source.splitlines()[0].lstrip("# ")
            anchors.append(re.escape(title.replace(" ", "-")))
    links = "|".join(anchors)
    notebook.cells = cells_kept
    for cell in notebook.cells:
        if links and cell.cell_type == "markdown":
            cell.source = re.sub(rf"\[([^]]*)\]\((?:\w+\.ipynb)?#(?:{links})\)", r"\1", cell.source)
            cell.source = _ON_MORE.sub("", cell.source)


def _has_picture(cell: NotebookNode) -> bool:
    return any("image/png" in output.get("data", {}) for output in cell.get("outputs", []))


def _empty(cell: NotebookNode, place: str) -> None:
    """Remove from one cell the answer and the outputs, which students produce themselves."""
    nbgrader = cell.metadata.get("nbgrader", {})
    take_answer(cell, place)
    if cell.cell_type == "code":
        cell.outputs = []
        cell.execution_count = None
    # As nbgrader does it: its cells cannot be deleted by accident, and locked ones not be edited.
    if nbgrader:
        cell.metadata["deletable"] = False
        if nbgrader.get("locked"):
            cell.metadata["editable"] = False


def take_answer(cell: NotebookNode, place: str) -> None:
    """Replace the author's answer in an answer cell by its stub or prompt.

    Answers in other cells are refused.

    `place` names the notebook and the cell in messages. Raises ReleaseError if the answer cannot be
    separated from the rest, or another cell contains words for graders.
    """
    nbgrader = cell.metadata.get("nbgrader", {})
    if nbgrader.get("solution"):
        if cell.cell_type == "code":
            cell.source = stub(cell.source, nbgrader.get("grade_id", ""), place)
        else:
            cell.source = PROMPT
        # A picture that the author pasted into the answer is stored beside its text.
        cell.pop("attachments", None)
    for words in FOR_GRADERS:
        if words in cell.source:
            raise ReleaseError(
                f'{place} holds "{words}" and is no answer cell. Move that to an answer cell, or '
                "mark this one as one: `solution` in nbgrader's metadata."
            )


def stub(source: str, exercise: str, place: str) -> str:
    """Return the source of an answer cell without the marked lines.

    One line that says what to write stands in their place. If there are lines below the marked
    ones, the exercise is to find a bug in them, and only they are kept.

    `place` names the notebook and the cell in messages. Raises ReleaseError if the markers do not
    pair, or what remains is not a function of the exercise's name.
    """
    kept = []
    inside = False
    blocks = 0
    has_bug = source.rpartition(END)[2].strip(" #\n") != ""
    for line in source.splitlines():
        if inside and BEGIN in line:
            raise ReleaseError(f"{place}: a second BEGIN SOLUTION before END SOLUTION.")
        if not inside and END in line:
            raise ReleaseError(f"{place}: an END SOLUTION without BEGIN SOLUTION.")
        if BEGIN in line:
            indent = line[: len(line) - len(line.lstrip())]
            if not has_bug:
                kept.append(f'{indent}raise NotImplementedError("{UNWRITTEN.format(exercise)}")')
            inside = True
            blocks += 1
        elif END in line:
            inside = False
        elif not inside:
            kept.append(line)
    if inside:
        raise ReleaseError(f"{place}: a BEGIN SOLUTION without END SOLUTION.")
    if not blocks:
        raise ReleaseError(
            f"{place}: an answer cell without ### BEGIN SOLUTION and ### END SOLUTION around the "
            f"answer."
        )
    text = "\n".join(kept)
    if not _defines(text, exercise, ast.Return if has_bug else ast.Raise):
        verb = "returns" if has_bug else "raises"
        raise ReleaseError(
            f"{place}: without its solution this is no function `{exercise}` that {verb}. Put the "
            "two markers inside the function, below its docstring."
        )
    return text


def _defines(text: str, exercise: str, kind: type[ast.stmt]) -> bool:
    """Return whether the text defines the exercise's function with a statement of a kind.

    What stands in for a solution raises on every call. Code with a bug may return in each of its
    cases.
    """
    try:
        statements = ast.parse(text).body
    except SyntaxError:
        return False
    functions = [s for s in statements if isinstance(s, ast.FunctionDef) and s.name == exercise]
    lines = ast.walk if kind is ast.Return else lambda function: function.body
    return any(isinstance(line, kind) for function in functions for line in lines(function))
