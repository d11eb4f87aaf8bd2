"""tool_positions: the path of the end-effector for a list of joint angles; a bug is to be found."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.poe_kuka_iiwa.shared import (
    KUKA,
    KUKA_HOME,
    TWO,
    at,
    axes,
    drawn_axes,
    exponentials,
    first_off,
    tool_pose,
)
from course_lib.checks.vocabulary import any_pose, away_from_zero, near, products

_POSES = Mistake("whole poses are returned", "Asked for are positions only: one row (x, y, z) for each row of angles.")
_ROWS_OF_FOUR = Mistake("positions have four entries", "Asked for are x, y and z: which entry is always 1?")
_SIZES = ((3, 2), (6, 5), (4, 1))  # joints and rows


def _known_form(array, screws, M, angles):
    k = len(angles)
    return {(k, 4, 4): _POSES, (k, 4): _ROWS_OF_FOUR, (k, 4, 1): _ROWS_OF_FOUR}.get(array.shape)


def _cases(rng):
    line = np.array([[0, 0.5], [0.5, 0.5], [1.0, -0.4], [np.pi / 2, 0]])
    drawn = [(axes(*drawn_axes(rng, n)), any_pose(rng), away_from_zero(rng, (k, n))) for n, k in _SIZES]
    return [
        (TWO, at(2, 0, 0), line),
        (KUKA, KUKA_HOME, away_from_zero(rng, (4, 7))),
        *drawn,
        (TWO, at(2, 1, 0), np.zeros((2, 2))),
        (TWO, at(0, 0, 0), line),
    ]


def _product(screws, q):
    return products(exponentials(screws, q))[-1]


def _right(screws, M, angles):
    return np.array([tool_pose(screws, M, q)[:3, 3] for q in angles])


EXERCISE = Exercise(
    name="tool_positions",
    points=1,
    arguments=("screws", "M", "angles"),
    cases=_cases,
    returns=numbers(lambda screws, M, angles: (len(angles), 3), _known_form),
    library=_right,
    properties=(
        Property(
            "each row is the position of the end-effector for that row of angles",
            lambda path, *case: near(path, _right(*case)),
            says=lambda path, *case: first_off(path.T, _right(*case).T, "Row"),
        ),
    ),
    hints=(
        "Run it at angles that are all 0, where you know the answer: which position comes out, and which should?",
        "The product of the exponentials says how the arm has moved things. What does it have to move here?",
        "A point that was at the base's origin while all angles were 0 is tracked now. Track M's point instead.",
    ),
    forbidden=("course_lib.arms.SerialArm",),
    broken=lambda screws, M, angles: np.array([_product(screws, q)[:3, 3] for q in angles]),
)


@EXERCISE.mistake(before=(lambda S, M, q: _product(S, q), tool_pose))
def M_on_the_left(screws, M, angles, before):
    """M stands on the left of the exponentials. On which side of M does a motion seen from the base act?"""
    return np.array([(M @ before(screws, M, q))[:3, 3] for q in angles])


@EXERCISE.mistake(with_M=(True, False))
def reverse_order(screws, M, angles, with_M):
    """the exponentials are multiplied in the reverse order. Joint 1 moves all the others: which is applied last?"""
    return _right(screws[::-1], M if with_M else np.eye(4), angles[:, ::-1])


@EXERCISE.mistake
def product_goes_on(screws, M, angles):
    """the product goes on from row to row. Does the next configuration begin where the last one was?"""
    return np.array([(T @ M)[:3, 3] for T in products([_product(screws, q) for q in angles])[1:]])


@EXERCISE.mistake
def position_of_M_added(screws, M, angles):
    """the position of M is added, without rotating it. What happens to the way to the end-effector if joint 1 turns?"""
    return np.array([_product(screws, q)[:3, 3] + M[:3, 3] for q in angles])


@EXERCISE.mistake
def only_rotated(screws, M, angles):
    """the position of M is rotated, and not moved. What else than a rotation does the product of exponentials do?"""
    return np.array([_product(screws, q)[:3, :3] @ M[:3, 3] for q in angles])
