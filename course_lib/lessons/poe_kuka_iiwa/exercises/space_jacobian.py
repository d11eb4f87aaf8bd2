"""space_jacobian: the joints' screw axes where the arm has moved them."""

import numpy as np

from course_lib.checks.exercise import Exercise, Mistake
from course_lib.checks.special_cases import Sweep
from course_lib.checks.vocabulary import SAME_TWICE, part_is, products
from course_lib.lessons.poe_kuka_iiwa.exercises.shared import (
    ONE_COLUMN,
    SMALL_ANGLES,
    STRAIGHT,
    arms,
    columns,
    exponentials,
    jacobian,
    read_jacobian,
)
from course_lib.rigid import adjoint

_FIRST_MOVED = Mistake(
    "the first axis is moved, or changed",
    "Which joints stand before joint 1? Column 1 is S1.",
)


def _nearly_zero(rng, size):
    screws, _, q = SMALL_ANGLES.case(rng, size)
    return screws, q


def _nearly_straight(rng, size):
    screws, _, q = STRAIGHT.case(rng, size)
    return screws, q


EXERCISE = Exercise(
    name="space_jacobian",
    points=2,
    arguments=("screws", "q"),
    cases=lambda rng: [(screws, q) for screws, M, q in arms(rng)],
    sweeps=(
        Sweep("an angle is nearly 0", _nearly_zero, SMALL_ANGLES.values),
        Sweep("a nearly straight arm", _nearly_straight, STRAIGHT.values),
    ),
    angles=("q",),
    returns=read_jacobian,
    library=jacobian,
    properties=(
        SAME_TWICE,
        part_is(
            "the first column is the first screw axis: no joint stands before it",
            jacobian,
            np.s_[:, 0],
            _FIRST_MOVED,
        ),
        part_is(
            "in the upper three rows, each column has the direction of its axis, rotated by all "
            "joints before it",
            jacobian,
            np.s_[:3],
            Mistake(
                "an axis is not rotated by all joints before it, each by its own angle",
                "Which exponentials, in which order, move the axis of the column named below?",
            ),
            "The upper half of the {} column",
        ),
        part_is(
            "in the lower three rows, each column has v = -omega x p, with p on its axis as the "
            "joints before it have moved it",
            jacobian,
            np.s_[3:],
            Mistake(
                "an axis is rotated, but not moved",
                "Which 6 x 6 matrix of a pose transforms both halves of a screw axis?",
            ),
            "The lower half of the {} column",
        ),
    ),
    hints=(
        "Column 1 is S1. Column 2 is S2 as joint 1 has moved it.",
        "Column i is Ad(T) S_i; T is the product of the exponentials of the joints before joint i.",
        "Keep T in the loop: first note the column, then multiply T by this joint's exponential. "
        "At the end, put the "
        "columns side by side.",
    ),
    forbidden=("course_lib.arms.SerialArm",),
)

EXERCISE.mistake(ONE_COLUMN, form=(6,))


@EXERCISE.mistake(
    "the exponentials are multiplied in the reverse order",
    "Joint 1 moves all the other joints. On which side of the product does its exponential stand?",
    own=(0, 1),
)
def reverse_order(screws, q, own):
    each = exponentials(screws, q)
    return columns(adjoint([products(each[: i + own][::-1])[-1] for i in range(len(each))]), screws)
