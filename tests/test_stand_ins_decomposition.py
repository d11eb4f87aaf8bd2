"""What stands in for unfinished exercises of notebook 6: it serves the cells that follow, and answers no exercise."""

from dataclasses import replace

import numpy as np
import pytest
from hostile.build import SEED, book

from course_lib.checks import decomposition_ik as check
from course_lib.checks.decomposition_ik import stand_ins
from course_lib.checks.exercise import RIGHT, WRONG, Here, judge
from course_lib.checks.notebook import describe
from course_lib.pack.grade.submission import grade

NAME, MODULE = "06_decomposition_ik", "course_lib.checks.decomposition_ik.stand_ins"

each_exercise = pytest.mark.parametrize("exercise", [each.exercise for each in check.CHECKS], ids=lambda e: e.name)


def calls(exercise, called):
    """The source of an answer that only calls `called`."""
    arguments = ", ".join(exercise.arguments)
    return f"def {exercise.name}({arguments}):\n    return {called}({arguments})"


def verdict_on(exercise, imports, called):
    """The verdict on such an answer in a notebook with these imports."""
    notebook = {}
    exec(f"{imports}\n{calls(exercise, called)}", notebook)
    return judge(exercise, Here(notebook[exercise.name]))


@each_exercise
def test_it_would_pass_the_check_were_it_not_refused(exercise):
    verdict = judge(replace(exercise, forbidden=()), Here(getattr(stand_ins, exercise.name)))
    assert verdict.state == RIGHT, describe(verdict)


@each_exercise
def test_an_answer_that_calls_it_is_refused_with_that_reason(exercise):
    name = exercise.name
    library = getattr(stand_ins, name)
    notebook = "from course_lib.checks.decomposition_ik import stand_ins"
    for verdict in (
        verdict_on(exercise, notebook, f"stand_ins.{name}"),
        verdict_on(exercise, f"{notebook}\nfit, _ = stand_ins.{name}, 'until yours passes'", "fit"),
        verdict_on(exercise, f"from {MODULE} import {name} as librarys", "librarys"),
        judge(exercise, Here(library)),
    ):
        assert verdict.state == WRONG
        text = describe(verdict)
        assert "your own lines compute the answer" in text
        assert f"It looks as if {MODULE}.{name} is called" in text
        assert getattr(stand_ins, name) is library


def test_an_answer_may_call_what_stands_in_for_another_exercise():
    def approximation_error(xy, angles):
        return np.linalg.norm(stand_ins.fk_2r(angles) - np.asarray(xy)[:, None], axis=-1)

    def fit_cells(xy, theta, cell, count):
        models = np.full((count, 2, 2, 3), np.nan)
        for c in range(count):
            places, angles = xy[cell == c], theta[cell == c]
            labels = stand_ins.split_branches(angles)
            for k in (0, 1):
                with_one = np.column_stack([places, np.ones(len(places))])[labels == k]
                if len(with_one) >= 3:
                    models[c, k] = np.linalg.lstsq(with_one, angles[labels == k])[0].T
        return models

    for function in (approximation_error, fit_cells):
        verdict = judge(getattr(check, function.__name__).exercise, Here(function))
        assert verdict.state == RIGHT, describe(verdict)


def test_an_answer_that_calls_it_earns_nothing_in_grading_and_says_why(solutions):
    first, *own = solutions(NAME)
    exercises = [each.exercise for each in check.CHECKS]
    result = grade(book(first, *(calls(e, f"stand_ins.{e.name}") for e in exercises)), NAME, SEED)
    for row in result["exercises"]:
        assert (row["state"], row["points"]) == ("wrong", 0)
        assert f"{MODULE}.{row['exercise']} is called" in row["message"]
    copied = check.fk_2r.exercise
    rows = grade(book(first, *own, calls(copied, "stand_ins.fk_2r")), NAME, SEED)["exercises"]
    assert {row["exercise"] for row in rows if row["state"] != "right"} == {"fk_2r", "approximation_error"}
