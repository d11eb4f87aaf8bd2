"""Each exercise has its task, its answer and its check in the notebook, with its points."""

import importlib
from functools import cache
from pathlib import Path

import nbformat
import pytest
from exercise_cells import graded, missing_of

ROOT = Path(__file__).parents[1]
BANK = sorted((ROOT / "tests/answers").glob("*/*.py"))


@cache
def cells_of(notebook):
    """The cells of a notebook that have names, by these."""
    (path,) = (ROOT / "notebooks").glob(f"[0-9][0-9]_{notebook}.ipynb")
    return graded(nbformat.read(path, 4))


@pytest.mark.parametrize("path", BANK, ids=[f"{path.parent.name}-{path.stem}" for path in BANK])
def test_task_answer_and_check_fit_the_exercise(path):
    package = importlib.import_module(f"course_lib.checks.{path.parent.name}")
    exercise = getattr(package, path.stem).exercise
    missing = missing_of(exercise, cells_of(path.parent.name))
    assert not missing, f"{exercise.name}: " + "; ".join(missing)
