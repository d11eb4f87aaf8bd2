"""body_screws: an arm's screw axes as the end-effector sees them at home."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.exercises.poe_kuka_iiwa.shared import (
    ELBOW,
    KUKA,
    KUKA_HOME,
    ONE,
    TWO,
    WHOLE,
    WHOLE_HOME,
    WRONG_ADJOINTS,
    at,
    axes,
    drawn_axes,
    first_off,
    in_blocks,
)
from course_lib.checks.vocabulary import X, any_pose, near
from course_lib.rigid import adjoint, inverse, transform
from course_lib.rotations import exp_so3


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


EXERCISE = Exercise(
    name="body_screws",
    points=1,
    arguments=("screws", "M"),
    cases=_cases,
    returns=numbers(lambda screws, M: (len(screws), 6)),
    library=_right,
    properties=(
        Property(
            "each row is the screw axis of its joint, seen from the end-effector at home",
            lambda B, *case: near(B, _right(*case)),
            says=lambda B, *case: first_off(B.T, _right(*case).T, "Row"),
        ),
    ),
    hints=(
        "An axis known to the base is to be seen from the end-effector at home. Which matrix takes twists there?",
        "M is T_sb: it takes what frame b sees to frame s. The adjoint of its inverse takes twists from s to b.",
        "Apply Ad(M^-1) to each row of screws, or to the columns of screws.T and transpose the result.",
    ),
    forbidden=("course_lib.arms.SerialArm",),
)


@EXERCISE.mistake
def other_direction(screws, M):
    """Ad(M) stands where Ad(M^-1) belongs. What M takes is seen from the end-effector: in which direction do you go?"""
    return screws @ adjoint(M).T


@EXERCISE.mistake(of=(lambda M: M, inverse))
def transposed_for_inverted(screws, M, of):
    """an adjoint is transposed where it is to be inverted, or stands on the wrong side of the rows. The inverse of a
    rotation is its transpose: is that of an adjoint? And what does a matrix act on, rows or columns?"""
    return screws @ adjoint(of(M))


@EXERCISE.mistake(form=WRONG_ADJOINTS[:7])
def wrong_adjoint(screws, M, form):
    """a block of the adjoint, or of what stands for it, is wrong. Does your adjoint pass its own check?"""
    return screws @ in_blocks(inverse(M), form).T


@EXERCISE.mistake(R=(True, False))
def half_way(screws, M, R):
    """the axes are only rotated, or only moved to the end-effector's origin. Along which axes does it see omega and v,
    and of which point is v the velocity?"""
    return screws @ (np.kron(np.eye(2), M[:3, :3]) if R else adjoint(at(*-M[:3, 3])).T)
