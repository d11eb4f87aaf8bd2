"""Each notebook runs on with answers in whatever form its checks accept: columns, lists, complex
numbers. The forms take turns, from one exercise to the next.

The cells run in this process, without pictures, and each check asks one set of its cases: the
others differ in their numbers alone. What the cells print has to be what the notebook holds.
"""

import contextlib
import functools
import importlib
import io
import itertools
import re
from pathlib import Path
from unittest import mock

import nbformat
import numpy as np
import pytest

from course_lib.checks.exercise import PUBLIC_SEED, Exercise
from course_lib.checks.later_cells import as_read

# A matrix of numpy is one of the forms, however much numpy advises against it.
pytestmark = pytest.mark.filterwarnings("ignore:the matrix subclass:PendingDeprecationWarning")

NOTEBOOKS = sorted((Path(__file__).parents[1] / "notebooks").glob("0[1-6]_*.ipynb"))


def in_another_form(value):
    """Return an answer in a form that checks read as the same: a column, or a matrix, of complex
    numbers."""
    array = np.asarray(value)
    if array.dtype.kind not in "fi" or array.size == 0:
        return value
    if array.ndim == 0:
        return array.reshape(1, 1) + 0j
    if array.ndim == 1:
        return array[:, None] + 0j
    return np.matrix(array) + 0j if array.ndim == 2 else (array + 0j).tolist()


def as_a_list(value):
    array = np.asarray(value)
    return array.tolist() if array.dtype.kind in "fi" else value


def changed(function, form):
    @functools.wraps(function)
    def answering_otherwise(*arguments, **named):
        value = function(*arguments, **named)
        try:
            return form(value)
        except (TypeError, ValueError):
            return value

    return answering_otherwise


def printed(cell):
    """Return what a notebook holds of what a cell has printed."""
    streams = (output.text for output in cell.get("outputs", ()) if output.output_type == "stream")
    return "".join(streams)


def accepted(check, function):
    """Return whether the notebook's check finds the function right; nothing is displayed."""
    with mock.patch("IPython.display.display"):
        check(function)
    return check.verdict.state == "right"


@pytest.mark.slow
@pytest.mark.parametrize("path", NOTEBOOKS, ids=[path.stem for path in NOTEBOOKS])
def test_later_cells_print_the_same_whatever_form_an_answer_has(path, monkeypatch):
    monkeypatch.chdir(path.parent)
    monkeypatch.setattr("IPython.display.display", lambda *shown, **options: None)
    monkeypatch.setattr("course_lib.figures.show", lambda *shown, **options: None)
    monkeypatch.setattr(Exercise, "public_seeds", (PUBLIC_SEED,))
    book = nbformat.read(path, 4)
    space = {"__name__": "__main__", "display": lambda *shown: None}
    in_other_form = []
    forms = itertools.cycle([in_another_form, as_a_list])
    for cell in book.cells:
        if cell.cell_type != "code":
            continue
        name = cell.metadata.get("nbgrader", {}).get("grade_id", "")
        called = re.fullmatch(r"check\.(\w+)\((\w+)\)", cell.source.strip())
        out = io.StringIO()
        with contextlib.redirect_stdout(out), contextlib.redirect_stderr(io.StringIO()):
            if called is None:
                exec(compile(cell.source, f"{path.stem} {cell.id}", "exec"), space)
            else:
                check, plain = getattr(space["check"], called[1]), space[called[2]]
                other = changed(plain, next(forms))
                if accepted(check, other):
                    space[called[2]] = other
                    in_other_form.append(called[1])
                else:
                    assert accepted(check, plain), f"{called[1]} is refused"
        if not name and printed(cell):
            assert out.getvalue() == printed(cell), f"cell {cell.id} prints something else"
    assert len(in_other_form) >= 3


def test_truth_values_stay_truth_values():
    reached = importlib.import_module("course_lib.lessons.panda_dh_ik.exercises.reached_targets")
    case = next(iter(reached.EXERCISE.cases(np.random.default_rng(0))))
    answer = reached.EXERCISE.library(*case)
    column = np.reshape(answer, (-1, 1))
    read = as_read(reached.EXERCISE, column, case)
    assert read.dtype == bool
    assert read.shape == np.shape(answer)


def test_whole_numbers_stay_indices():
    split = importlib.import_module("course_lib.lessons.decomposition_ik.exercises.split_branches")
    q = np.array([[0.0, 1.0], [1.0, -1.0], [0.1, 1.1]])
    labels = as_read(split.EXERCISE, np.array([[0], [1], [0]]), (q,))
    assert np.arange(2)[labels].tolist() == [0, 1, 0]
