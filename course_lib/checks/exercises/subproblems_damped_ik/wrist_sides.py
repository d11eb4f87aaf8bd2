"""wrist_sides: find the bug. Both sides of the equation from which subproblem 2 finds a wrist's angles."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.format_numbers import format_array
from course_lib.checks.vocabulary import X, Y, Z, any_rotation, near
from course_lib.rotations import rot_x, rot_y


def _with_right(side):
    """The answer with another right side: side(b)."""
    return lambda R, b: np.array([rot_y(-b[0]) @ R @ Y, side(b)])


_right = _with_right(lambda b: rot_x(b[1]) @ Y)


def _cases(rng):
    angles = [np.array([0.5, 1.0, -0.3]), *(rng.uniform(0.4, 1.2, 3) * rng.choice([-1, 1], 3) for _ in range(3))]
    wrists = [(rot_y(b[0]) @ rot_x(b[1]) @ rot_y(b[2]), b) for b in angles]
    return [*wrists, (any_rotation(rng), angles[1]), (np.eye(3), np.zeros(3))]


def _is_of(R, b):
    return np.abs(rot_y(b[0]) @ rot_x(b[1]) @ rot_y(b[2]) - R).max() < 1e-9


def _gap(sides, R, b):
    return f"Yours are {format_array(sides[0])} and {format_array(sides[1])}."


EXERCISE = Exercise(
    name="wrist_sides",
    points=1,
    arguments=("R", "b"),
    cases=_cases,
    returns=numbers(lambda R, b: (2, 3)),
    library=_right,
    broken=_with_right(lambda b: rot_y(b[0]) @ rot_x(b[1]) @ Y),
    properties=(
        Property("the left side is Ry(-b1) R e_y", lambda sides, R, b: near(sides[0], rot_y(-b[0]) @ R @ Y), says=_gap),
        Property(
            "for R = Ry(b1) Rx(b2) Ry(b3) both sides are equal",
            lambda sides, R, b: near(sides[1], sides[0]),
            says=_gap,
            where=_is_of,
        ),
        Property(
            "the right side depends on the angles alone, not on R",
            lambda sides, R, b: near(sides[1], _right(R, b)[1]),
            where=lambda R, b: not _is_of(R, b),
        ),
    ),
    hints=(
        "Take numbers: b = (0.5, 1.0, -0.3), R made of it, and compare the two sides.",
        "Write R e_y with its three factors. Which of them leaves e_y alone?",
        "What is multiplied to the left of one side has to be multiplied to the left of the other: Ry(-b1) Ry(b1) = I.",
    ),
)


@EXERCISE.mistake
def left_side_twice(R, b):
    """the left side is returned twice. Subproblem 2 solves for the angles on the right: what is that side made of?"""
    return np.array([rot_y(-b[0]) @ R @ Y] * 2)


@EXERCISE.mistake(left=(lambda b: np.eye(3), lambda b: rot_y(b[0])), right=(lambda b: np.eye(3), lambda b: rot_y(b[0])))
def left_side_changed(R, b, left, right):
    """the left side is changed, which was right. What should stand on the right, if both are multiplied by Ry(-b1)?"""
    return np.array([left(b) @ R @ Y, right(b) @ rot_x(b[1]) @ Y])


@EXERCISE.mistake
def sign_of_b2(R, b):
    """the right side has the wrong sign of b2. Which sign does b2 have in R?"""
    return _with_right(lambda b: rot_x(-b[1]) @ Y)(R, b)


@EXERCISE.mistake(
    side=(
        lambda b: rot_y(-b[0]) @ rot_x(b[1]) @ Y,
        lambda b: rot_x(b[1]) @ rot_y(b[0]) @ rot_x(b[1]) @ Y,
        lambda b: rot_y(b[2]) @ rot_x(b[1]) @ Y,
    )
)
def factor_too_many(R, b, side):
    """a factor too many stands on the right. Multiply R = Ry(b1) Rx(b2) Ry(b3) by e_y from the right and by Ry(-b1)
    from the left: which factors are left?"""
    return _with_right(side)(R, b)


@EXERCISE.mistake(side=(lambda b: rot_x(b[1]) @ X, lambda b: rot_x(b[1]) @ Z, lambda b: rot_x(b[1]) @ rot_y(b[2]) @ X))
def another_vector(R, b, side):
    """the right side has another vector. On the left R acts on e_y. On which vector does the right side act?"""
    return _with_right(side)(R, b)
