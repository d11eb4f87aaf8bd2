"""tool_positions: the path of the end-effector for a list of joint angles; a bug is to be found."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.poe_kuka_iiwa.shared import (
    KUKA,
    KUKA_HOME,
    TWO,
    at,
    axes,
    drawn_axes,
    exponentials,
    tool_pose,
)
from course_lib.checks.vocabulary import any_pose, away_from_zero, few_digits, near, products
from course_lib.rigid import exp_se3

_POSES = Mistake("whole poses are returned", "Asked for are positions only: one row (x, y, z) for each row of angles.")
_TRANSPOSED = Mistake("rows and columns are swapped", "One position a row: the shape is (k, 3).")
_ONE = Mistake("only one position is returned", "There is one position for each row of angles.")


def _known_form(array, screws, M, angles):
    k = len(angles)
    known = {(k, 4, 4): _POSES, (k, 4): _POSES, (3, k): _TRANSPOSED, (3,): _ONE, (4, 4): _ONE}
    return known.get(array.shape)


_SIZES = ((3, 2), (6, 5), (4, 1))  # joints and rows


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


def _each(position):
    """The positions of somebody whose position(screws, M, q) is that of one row of angles."""
    return lambda screws, M, angles: np.array([position(screws, M, q) for q in angles])


def _product(screws, q):
    return products(exponentials(screws, q))[-1]


_right = _each(lambda screws, M, q: tool_pose(screws, M, q)[:3, 3])
_broken = _each(lambda screws, M, q: _product(screws, q)[:3, 3])


def _running(screws, M, angles):
    """The positions of somebody who does not begin anew for each row."""
    return np.array([(T @ M)[:3, 3] for T in products([_product(screws, q) for q in angles])[1:]])


def _seen(path, screws, M, angles):
    right = _right(screws, M, angles)
    i = int(np.argmax(np.abs(path - right).max(1)))
    return f"For row {i} it should be {format_tuple(right[i])}; yours is {format_tuple(path[i])}."


EXERCISE = Exercise(
    name="tool_positions",
    points=1,
    arguments=("screws", "M", "angles"),
    cases=_cases,
    returns=numbers(lambda screws, M, angles: (len(angles), 3), _known_form),
    properties=(
        Property(
            "each row is the position of the end-effector for that row of angles",
            lambda path, *case: near(path, _right(*case)),
            says=_seen,
        ),
    ),
    mistakes=(
        few_digits(_right),
        Mistake(
            "M stands on the left of the exponentials, or on both sides",
            "On which side of M does a motion seen from the base act?",
            *(
                _each(position)
                for position in (
                    lambda screws, M, q: (M @ _product(screws, q))[:3, 3],
                    lambda screws, M, q: (M @ tool_pose(screws, M, q))[:3, 3],
                )
            ),
        ),
        Mistake(
            "the exponentials are multiplied in the reverse order",
            "Joint 1 moves all the others: which exponential is applied last?",
            _each(lambda screws, M, q: tool_pose(screws[::-1], M, q[::-1])[:3, 3]),
            _each(lambda screws, M, q: _product(screws[::-1], q[::-1])[:3, 3]),
        ),
        Mistake(
            "M comes in once for each joint",
            "M comes in once, after the last exponential.",
            _each(lambda S, M, q: products([E @ M for E in exponentials(S, q)])[-1][:3, 3]),
        ),
        Mistake(
            "the product goes on from row to row",
            "Each row of angles is a configuration of its own: the product begins anew.",
            _running,
        ),
        Mistake(
            "only the position of M is added, without rotating it",
            "The arm rotates what it carries: adding vectors of two frames gives no position.",
            _each(lambda screws, M, q: _product(screws, q)[:3, 3] + M[:3, 3]),
        ),
        Mistake(
            "the rotation alone is applied to the position of M",
            "The product of the exponentials moves points as well as rotating them.",
            _each(lambda screws, M, q: _product(screws, q)[:3, :3] @ M[:3, 3]),
        ),
        Mistake(
            "every row is at home",
            "The exponentials must move the end-effector.",
            _each(lambda screws, M, q: M[:3, 3]),
        ),
        Mistake(
            "every row is that of the same angles",
            "Row i belongs to angles[i].",
            *(lambda s, M, angles, i=i: _right(s, M, angles)[[i] * len(angles)] for i in (0, -1)),
        ),
        Mistake(
            "a row of T is returned, not its last column",
            "The position is in the last column of T.",
            _each(lambda screws, M, q: tool_pose(screws, M, q)[3, :3]),
            _each(lambda screws, M, q: tool_pose(screws, M, q)[2, :3]),
        ),
        Mistake(
            "one exponential is taken of the sum of the twists",
            "For matrices exp(A) exp(B) is not exp(A + B).",
            _each(lambda screws, M, q: (exp_se3(q @ screws) @ M)[:3, 3]),
        ),
    ),
    hints=(
        "Run it at angles that are all 0, where you know the answer: which position comes out, and which should?",
        "The product of the exponentials says how the arm has moved things. What does it have to move here?",
        "A point that was at the base's origin while all angles were 0 is tracked now. Track M's point instead.",
    ),
    library=_right,
    forbidden=("course_lib.arms.SerialArm",),
    broken=_broken,
)
