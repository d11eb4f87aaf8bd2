"""space_jacobian: the joints' screw axes where the arm has moved them."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.kinds import OWN_CASES
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import Sweep
from course_lib.checks.vocabulary import SAME_TWICE, near, products
from course_lib.lessons.poe_kuka_iiwa.exercises.shared import (
    ONE_COLUMN,
    SMALL_ANGLES,
    STRAIGHT,
    arms,
    before,
    columns,
    exponentials,
    jacobian,
    special,
)
from course_lib.rigid import adjoint


def _without_home(sweep):
    """Return the sweep whose cases lack M."""

    def case(rng, size):
        screws, _, q = sweep.case(rng, size)
        return screws, q

    return Sweep(sweep.what, case, sweep.values)


def _otherwise(J, screws, q):
    right = jacobian(screws, q)
    if not near(J[:, 0], right[:, 0]):
        return Question(
            "the first axis is moved, or changed",
            "No joint stands before joint 1, so column 1 is S1 at all angles. What does your code "
            "put there, and what does it do to it afterwards?",
        )
    if not near(J[:3], right[:3]):
        return Question(
            "an axis is not rotated by all joints before it, each by its own angle",
            "Which exponentials, in which order and by which angles, move the axis of this column?",
        )
    return Question(
        "the directions of the axes are right for the angles below, and a v is not",
        "Take a point of this axis: where is it after the joints before it have moved it? Which "
        "6 x 6 matrix of a pose transforms both halves of a screw axis, and is it used for these "
        "angles?",
    )


def _unmoved(screws, q):
    """Return the answer whose v is rotated as omega is, as if no joint moved the axis."""
    R = np.array(before(screws, q))[:, :3, :3]
    halves = [np.einsum("nij,nj->in", R, half) for half in (screws[:, :3], screws[:, 3:])]
    return np.concatenate(halves)


def _in_reverse(own):
    """Return the answer by the reversed product of the exponentials before a joint; with own = 1
    that of the joint is among them."""

    def answer(screws, q):
        each = exponentials(screws, q)
        reversed_products = [products(each[: i + own][::-1])[-1] for i in range(len(each))]
        return columns(adjoint(reversed_products), screws)

    return answer


EXERCISE = declared(
    "space_jacobian",
    points=2,
    arguments={
        "screws": OWN_CASES.but(free=True),
        "q": OWN_CASES.but(angle=True, free=True),
    },
    cases=lambda rng: [(screws, q) for screws, M, q in arms(rng)],
    library=jacobian,
    properties=(SAME_TWICE,),
    says="each column is its screw axis as the joints before it have rotated and moved it: its "
    "direction above, and below v = -omega x p, with p on the axis",
    otherwise=_otherwise,
    sweeps=(_without_home(SMALL_ANGLES), _without_home(STRAIGHT)),
    special=lambda rng: special(rng)[::2],
    hints=(
        "Column 1 is S1. Column 2 is S2 as joint 1 has moved it.",
        "Column i is Ad(T) S_i; T is the product of the exponentials of the joints before joint i.",
        "Keep T in the loop: first note the column, then multiply T by this joint's exponential. "
        "At the end, put the columns side by side.",
    ),
    forbidden=("course_lib.arms.SerialArm",),
    mistakes=(
        ONE_COLUMN,
        Mistake(
            "the exponentials are multiplied in the reverse order",
            "Joint 1 moves all the other joints. On which side of the product does its exponential "
            "stand?",
            *map(_in_reverse, (0, 1)),
        ),
        Mistake(
            "an axis is rotated, but not moved",
            "Which 6 x 6 matrix of a pose transforms both halves of a screw axis?",
            _unmoved,
        ),
    ),
)
