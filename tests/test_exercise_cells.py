"""Each exercise has its task, its answer and its check in the notebook, with its points."""

import importlib
import re
from functools import cache
from pathlib import Path

import nbformat
import numpy as np
import pytest

from course_lib.checks.exercise import PUBLIC_SEED, Exercise

ROOT = Path(__file__).parents[1]
BANK = sorted((ROOT / "tests/lessons").glob("*/answers/*.py"))
# What may come as an argument, and the words of which a task has one if its check asks it.
WHOLE_NUMBERS = ("whole number",)
REVOLUTIONS = ("revolution",)


def graded(notebook):
    """{grade_id: cell} of the cells that nbgrader knows."""
    cells = [cell for cell in notebook.cells if "nbgrader" in cell.metadata]
    found = {cell.metadata.nbgrader.grade_id: cell for cell in cells}
    names = [cell.metadata.nbgrader.grade_id for cell in cells]
    assert len(found) == len(names), (
        f"these occur twice: {', '.join(sorted({n for n in names if names.count(n) > 1}))}"
    )
    return found


@cache
def cells_of(notebook):
    """The cells of a notebook that have names, by these."""
    (path,) = (ROOT / "notebooks").glob(f"[0-9][0-9]_{notebook}.ipynb")
    return graded(nbformat.read(path, 4))


def missing_of(exercise, cells):
    """What the notebook lacks of an exercise, in words for its author. cells: by their grade_id."""
    name, points = exercise.name, exercise.points
    absent = [
        f"no cell has the grade_id {prefix}{name}"
        for prefix in ("task_", "", "check_")
        if prefix + name not in cells
    ]
    if absent:
        return absent
    task, answer, check = (cells[prefix + name] for prefix in ("task_", "", "check_"))
    about, shown = check.metadata.nbgrader, f"({points} point{'s' if points > 1 else ''}, "
    minutes = re.search(re.escape(shown) + r"\d+ minutes\)", task.source)
    solution = answer.source.partition("    ### BEGIN SOLUTION\n")[2]
    head = f"def {name}({', '.join(exercise.arguments)})"
    wanted = {
        f"the first line of its task does not name `{name}`": f"`{name}`"
        in task.source.splitlines()[0],
        "its task has no Example": "Example" in task.source,
        "its task does not say *Why it matters:*": "*Why it matters:*" in task.source,
        f"its task does not say {shown}... minutes), with the points that its Exercise gives": bool(
            minutes
        ),
        "its answer has no BEGIN SOLUTION and END SOLUTION": "    ### END SOLUTION" in solution,
        f"its answer does not begin with {head}": head in answer.source,
        f"its check is not check.{name}({name})": check.source == f"check.{name}({name})",
        f"its check's metadata say points {about.get('points')}, its Exercise {points}": about.get(
            "points"
        )
        == points,
        "its check's metadata do not say grade and locked": about.grade and about.locked,
        f"its task does not state the tolerance {exercise.tolerance}": states(
            exercise.tolerance, task.source
        ),
        "its properties carry more points than its Exercise": sum(
            p.points for p in exercise.properties
        )
        <= points,
    }
    return [what for what, holds in wanted.items() if not holds]


def states(tolerance, task):
    """Return whether a task states a number such as 1e-9, in digits or in a formula; None is said
    by no task."""
    if tolerance is None:
        return True
    power = round(-np.log10(tolerance))
    return any(form in task for form in (f"1e-{power}", f"10^{{-{power}}}"))


def holds_whole_numbers(argument):
    """Return whether an argument is an array of type int, or a list with such numbers."""
    if isinstance(argument, np.ndarray):
        return argument.dtype.kind == "i"
    if isinstance(argument, list | tuple):
        return any(type(item) is int or holds_whole_numbers(item) for item in argument)
    return False


def may_be_whole(column):
    """Return whether an argument holds whole numbers in some cases; one that does in all of them,
    such as the number of a cell, is no surprise."""
    whole = list(map(holds_whole_numbers, column))
    return any(whole) and not all(whole)


def needed_words(exercise):
    """Return the groups of words of each of which a task needs one, for what its check asks."""
    cases, _ = exercise.questions(PUBLIC_SEED)
    columns = zip(*cases, strict=True)
    needed = [WHOLE_NUMBERS] if any(map(may_be_whole, columns)) else []
    return [*needed, REVOLUTIONS] if exercise.angles else needed


def test_whole_numbers_are_found_in_arrays_and_in_lists():
    assert holds_whole_numbers(np.array([1, 2]))
    assert holds_whole_numbers([((1, 0.5), 0.25)])
    assert not holds_whole_numbers([True, 1.0])
    assert not holds_whole_numbers(np.array([1.0]))


@pytest.mark.parametrize("path", BANK, ids=[f"{path.parents[1].name}-{path.stem}" for path in BANK])
def test_a_task_says_what_may_come(path):
    package = importlib.import_module(f"course_lib.lessons.{path.parents[1].name}.check")
    exercise = getattr(package, path.stem).exercise
    if not isinstance(exercise, Exercise) or not exercise.arguments:
        return
    task = cells_of(path.parents[1].name)[f"task_{path.stem}"].source
    missing = [words for words in needed_words(exercise) if not any(w in task for w in words)]
    assert not missing, f"the task of {path.stem} does not say {missing}, which its check asks"


@pytest.mark.parametrize(
    "path", sorted((ROOT / "notebooks").glob("0[1-6]_*.ipynb")), ids=lambda path: path.stem
)
def test_a_notebook_says_how_accurate_an_answer_must_be(path):
    texts = (cell.source for cell in nbformat.read(path, 4).cells)
    (how_to_work,) = (text for text in texts if "**How to work with this notebook.**" in text)
    assert "it must be right to $10^{-9}$" in how_to_work


@pytest.mark.parametrize("path", BANK, ids=[f"{path.parents[1].name}-{path.stem}" for path in BANK])
def test_task_answer_and_check_fit_the_exercise(path):
    package = importlib.import_module(f"course_lib.lessons.{path.parents[1].name}.check")
    exercise = getattr(package, path.stem).exercise
    missing = missing_of(exercise, cells_of(path.parents[1].name))
    assert not missing, f"{exercise.name}: " + "; ".join(missing)
