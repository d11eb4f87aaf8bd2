"""Points for a part: a property may carry some of its exercise's points, earned where it holds and
another does not."""

import dataclasses

import numpy as np
import pytest
from scipy.linalg import expm

from course_lib import rigid
from course_lib.checks.judge import LocalFunction, judge
from course_lib.checks.messages import describe
from course_lib.checks.verdict import RIGHT, WRONG
from course_lib.lessons.poe_kuka_iiwa import check

EXP = check.exp_se3.exercise


def verdict(answer, exercise=EXP):
    return judge(exercise, LocalFunction(answer), seed=5)


def only_turns(twist):
    T = expm(rigid.hat_se3(np.asarray(twist, float)))
    T[:3, 3] = twist[3:]
    return T


def only_moves(twist):
    T = expm(rigid.hat_se3(np.asarray(twist, float)))
    T[:3, :3] = np.eye(3)
    return T


def test_a_wrong_answer_keeps_the_points_of_its_right_part():
    got = verdict(only_moves)
    assert (got.state, got.points) == (WRONG, 1)
    assert describe(got).splitlines()[0] == "✗ exp_se3: not right yet, 1 of 3 points so far"


@pytest.mark.parametrize(
    "answer", [only_turns, lambda twist: np.eye(4), lambda twist: None, lambda twist: "pose"]
)
def test_an_answer_without_that_part_earns_nothing(answer):
    got = verdict(answer)
    assert (got.state, got.points) == (WRONG, 0)
    assert "so far" not in describe(got)


def test_an_error_earns_nothing_and_a_right_answer_all():
    broken = verdict(lambda twist: only_turns(twist) if twist[0] == 0 else 1 / 0)
    assert (broken.state, broken.points) == (WRONG, 0)
    parts = tuple(dataclasses.replace(part, points=1) for part in EXP.properties)
    assert (
        verdict(only_turns, dataclasses.replace(EXP, properties=parts)).points == EXP.points - 1
    )  # never all
    got = verdict(lambda twist: expm(rigid.hat_se3(np.asarray(twist, float))))
    assert (got.state, got.points) == (RIGHT, EXP.points)
