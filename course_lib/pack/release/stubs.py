"""A student's copy of a notebook: stubs for solutions, prompts for written answers, no output but a first picture."""

import ast
import re

import nbformat

from course_lib.checks.errors import UNWRITTEN
from course_lib.pack.more import cells_of_more, heading_level
from course_lib.pack.notebooks import tidy
from course_lib.pack.release import PROMPT, ReleaseError
from course_lib.pack.release.students.carry_over import fingerprint

BEGIN, END = "BEGIN SOLUTION", "END SOLUTION"  # anywhere in a line, as nbgrader has it
FOR_GRADERS = (BEGIN, END, "Model answer", "*Rubric")


def students_copy(text, name, release, more=True):
    """Return the text of a notebook without solutions and outputs, and without the cells of More unless `more`.

    The first picture stays if it stands before all exercises, so that a student who opens the
    notebook sees it at once. `name` is the notebook's, for messages; `release` goes into its
    metadata. Raises ReleaseError, which names notebook and cell, if markers are not paired, a stub
    would not be a function, or another cell contains words for graders.
    """
    notebook = _read(text, name)
    first = next(
        (cell for cell in notebook.cells if "nbgrader" in cell.metadata or _has_picture(cell)), None
    )
    shown = None if first is None or "nbgrader" in first.metadata else first.outputs
    for number, cell in enumerate(notebook.cells, 1):
        grade_id = cell.metadata.get("nbgrader", {}).get("grade_id")
        _empty(cell, f"{name}, cell {number}" + (f" ({grade_id})" if grade_id else ""))
    if shown:
        first.outputs = shown
    if not more:
        _leave_out_more(notebook)
    course = {**notebook.metadata.get("course", {}), "release": release}
    notebook.metadata["course"] = course | _record(notebook.cells)
    tidy(notebook)
    return nbformat.writes(notebook, indent=1, ensure_ascii=False, sort_keys=True) + "\n"


def _record(cells):
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


def _read(text, name):
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


def _leave_out_more(notebook):
    """Remove the cells of More, and of the rest the links to them and the clauses that mention *More*."""
    folded = cells_of_more(notebook)
    cells = list(zip(notebook.cells, folded, strict=True))
    titles = (
        cell.source.splitlines()[0].lstrip("# ")
        for cell, out in cells
        if out and heading_level(cell)
    )
    links = "|".join(re.escape(title.replace(" ", "-")) for title in titles)
    notebook.cells = [cell for cell, out in cells if not out]
    for cell in notebook.cells:
        if links and cell.cell_type == "markdown":
            cell.source = re.sub(rf"\[([^]]*)\]\((?:\w+\.ipynb)?#(?:{links})\)", r"\1", cell.source)
            cell.source = _ON_MORE.sub("", cell.source)


def _has_picture(cell):
    return any("image/png" in output.get("data", {}) for output in cell.get("outputs", []))


def _empty(cell, place):
    """Remove from one cell the answer and the outputs, which students produce themselves."""
    nbgrader = cell.metadata.get("nbgrader", {})
    take_answer(cell, place)
    if cell.cell_type == "code":
        cell.outputs, cell.execution_count = [], None
    # as nbgrader does: its cells cannot be deleted by accident, and locked ones cannot be edited
    if nbgrader:
        cell.metadata["deletable"] = False
        if nbgrader.get("locked"):
            cell.metadata["editable"] = False


def take_answer(cell, place):
    """Replace the author's answer in an answer cell by its stub or prompt; refuse answers in other cells.

    `place` names the notebook and the cell in messages. Raises ReleaseError if the answer cannot be
    separated from the rest, or another cell contains words for graders.
    """
    nbgrader = cell.metadata.get("nbgrader", {})
    if nbgrader.get("solution"):
        code = cell.cell_type == "code"
        cell.source = stub(cell.source, nbgrader.get("grade_id", ""), place) if code else PROMPT
    found = [words for words in FOR_GRADERS if words in cell.source]
    if found:
        how = (
            "Move that to an answer cell, or mark this one as one: `solution` in nbgrader's "
            "metadata."
        )
        raise ReleaseError(f'{place} holds "{found[0]}" and is no answer cell. {how}')


def stub(source, exercise, place):
    """Return the source of an answer cell with the marked lines replaced by one that says what to write.

    If there are lines below the marked ones, the exercise is to find a bug in them, and only they
    are kept.

    `place` names the notebook and the cell in messages. Raises ReleaseError if the markers do not
    pair, or what remains is not a function of the exercise's name.
    """
    kept, inside, blocks = [], False, 0
    has_bug = source.rpartition(END)[2].strip(" #\n") != ""
    for line in source.splitlines():
        if (BEGIN if inside else END) in line:
            what = (
                "a second BEGIN SOLUTION before END" if inside else "an END SOLUTION without BEGIN"
            )
            raise ReleaseError(f"{place}: {what} SOLUTION.")
        if BEGIN in line:
            indent = line[: len(line) - len(line.lstrip())]
            if not has_bug:
                kept.append(f'{indent}raise NotImplementedError("{UNWRITTEN.format(exercise)}")')
            inside, blocks = True, blocks + 1
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
        what = (
            f"without its solution this is no function `{exercise}` that "
            f"{'returns' if has_bug else 'raises'}"
        )
        raise ReleaseError(
            f"{place}: {what}. Put the two markers inside the function, below its docstring."
        )
    return text


def _defines(text, exercise, kind):
    """Return whether the text is Python that defines the exercise's function, with a statement of this kind in it.

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
