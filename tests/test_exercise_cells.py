"""Each exercise has its task, its answer and its check in the notebook, with its points."""

import importlib
from functools import cache
from pathlib import Path

import nbformat
import pytest
from exercise_cells import graded, missing_of

from course_lib.checks import panda_dh_ik
from course_lib.checks.exercise import ERROR, RIGHT, Here, judge

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


def test_an_answer_that_multiplies_a_given_pose_in_place_spoils_no_later_answer(monkeypatch):
    monkeypatch.chdir(ROOT / "notebooks")
    book, exercise, space = nbformat.read("05_panda_dh_ik.ipynb", 4), panda_dh_ik.panda_fk.exercise, {}
    sources = {cell.id: cell.source for cell in book.cells}
    for name in ("setup", "failure-code", "dh-modified-answer"):
        exec(sources[name], space)
    exec(sources["panda-fk-answer"].replace("T = T @ dh_modified(", "T @= dh_modified("), space)
    with pytest.raises(ValueError, match="read-only"):  # also when the student tries it, before the check does
        space["panda_fk"](space["ready"])
    verdict = judge(exercise, Here(space["panda_fk"]))
    assert verdict.state == ERROR
    assert "changed in place" in verdict.mistake.name
    exec(sources["panda-fk-answer"], space)
    assert judge(exercise, Here(space["panda_fk"])).state == RIGHT
