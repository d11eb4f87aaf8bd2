"""body_screws: an arm's screw axes as the end-effector sees them at home."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.poe_kuka_iiwa.shared import (
    ELBOW,
    KUKA,
    KUKA_HOME,
    ONE,
    TWO,
    WHOLE,
    WHOLE_HOME,
    adjoint_mistakes,
    at,
    axes,
    drawn_axes,
    whole_screws,
)
from course_lib.checks.vocabulary import X, any_pose, few_digits, halves_swapped, near
from course_lib.rigid import adjoint, inverse, transform
from course_lib.rotations import exp_so3

_TRANSPOSED = Mistake("rows and columns are swapped", "One axis a row: the shape is (n, 6), as of screws.")


def _cases(rng):
    tool = transform(exp_so3(np.pi / 2 * X), [2.0, 0, 1])
    drawn = [(axes(*drawn_axes(rng, n)), any_pose(rng)) for n in (1, 3, 5, 7)]
    return [
        (TWO, at(2, 0, 0)),
        (TWO, tool),
        (ELBOW, tool),
        (KUKA, KUKA_HOME),
        *drawn,
        (WHOLE, at(0.5, 0.25, 0)),
        (WHOLE, WHOLE_HOME),
        (ONE, at(0, 0, 0)),
    ]


def _right(screws, M):
    return screws @ adjoint(inverse(M)).T


def _by(matrix):
    """Return the answer of somebody with another matrix: matrix(M)."""
    return lambda screws, M: screws @ matrix(M).T


def _seen(B, screws, M):
    right = _right(screws, M)
    i = int(np.argmax(np.abs(B - right).max(1)))
    return f"Row {i} should be {format_tuple(right[i])}; yours is {format_tuple(B[i])}."


EXERCISE = Exercise(
    name="body_screws",
    points=1,
    arguments=("screws", "M"),
    cases=_cases,
    returns=numbers(
        lambda screws, M: (len(screws), 6),
        lambda array, screws, M: _TRANSPOSED if array.shape == (6, len(screws)) else None,
    ),
    properties=(
        Property(
            "each row is the screw axis of its joint, seen from the end-effector at home: Ad(M^-1) S_i",
            lambda B, *case: near(B, _right(*case)),
            says=_seen,
        ),
    ),
    mistakes=(
        few_digits(_right),
        whole_screws(_right),
        Mistake("the screw axes are returned as they came", "They are seen from the base still.", lambda S, M: S),
        Mistake(
            "Ad(M) stands where Ad(M^-1) belongs",
            "M takes what the end-effector sees to what the base sees. Here you need the opposite direction.",
            _by(adjoint),
        ),
        Mistake(
            "Ad(M) is transposed where it is to be inverted",
            "The inverse of a rotation is its transpose; that of an adjoint is not.",
            _by(lambda M: adjoint(M).T),
        ),
        Mistake(
            "the matrix is multiplied from the wrong side",
            "A matrix acts on a column. The screw axes are rows.",
            lambda screws, M: screws @ adjoint(inverse(M)),
            lambda screws, M: screws @ adjoint(M),
            shadowed_by="Ad(M) is transposed where it is to be inverted",
        ),
        *adjoint_mistakes(
            lambda wrong: _by(lambda M: wrong(M[:3, :3].T, -M[:3, :3].T @ M[:3, 3])),
            without=("the adjoint is transposed", "the blocks of the adjoint are in the order (v, omega)"),
        ),
        halves_swapped(_right, "v stands before omega", "Each row is (omega, v).", axis=1),
    ),
    hints=(
        "An axis known to the base is to be seen from the end-effector at home. Which matrix takes twists there?",
        "M is T_sb: it takes what frame b sees to frame s. The adjoint of its inverse takes twists from s to b.",
        "Apply Ad(M^-1) to each row of screws, or to the columns of screws.T and transpose the result.",
    ),
    library=_right,
    forbidden=("course_lib.arms.SerialArm",),
)
