"""body_jacobian: the joints' screw axes as the end-effector sees them now."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.kinds import OWN_CASES
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import SAME_TWICE, near, products, remembered
from course_lib.lessons.poe_kuka_iiwa.exercises import shared
from course_lib.rigid import adjoint, inverse


@remembered
def _right(screws, M, q):
    return adjoint(inverse(shared.tool_pose(screws, M, q))) @ shared.jacobian(screws, q)


def _otherwise(J, *case):
    right = _right(*case)
    if not near(J[:, -1], right[:, -1]):
        return Question(
            "the last column is not B_n",
            "Compare your last column with B_n = Ad(M^-1) S_n. Along whose axes does this Jacobian "
            "see the last axis, and which joints lie between it and the end-effector?",
        )
    if near(J[:3], right[:3]):
        return None
    return Question(
        "an axis is not moved by all joints between it and the end-effector, each by its own angle",
        "Which exponentials, in which order and by which angles, stand in Ad(...) before the body "
        "screw of the column that is named?",
    )


def _moved_by(joints):
    """Return the answer whose column i is moved by the exponentials joints(each, i)."""

    def answer(screws, M, q):
        B = screws @ adjoint(inverse(M)).T
        each = shared.exponentials(B, -q)
        return shared.columns([adjoint(products(joints(each, i))[-1]) for i in range(len(q))], B)

    return answer


def _hybrid(*case):
    R = shared.tool_pose(*case)[shared.BLOCK]
    return np.kron(np.eye(2), R) @ _right(*case)


EXERCISE = declared(
    "body_jacobian",
    points=3,
    arguments={
        "screws": OWN_CASES.but(free=True),
        "M": OWN_CASES.but(free=True),
        "q": OWN_CASES.but(angle=True, free=True),
    },
    tolerance=EXACT,
    cases=shared.arms,
    library=_right,
    properties=(SAME_TWICE,),
    says="each column is its axis as the end-effector sees it: the direction along the "
    "end-effector's own axes, and below the velocity of its origin; the last one is Ad(M^-1) Sn at "
    "all angles",
    otherwise=_otherwise,
    sweeps=(shared.SMALL_ANGLES, shared.STRAIGHT),
    special=shared.special,
    hints=(
        "Begin at the last joint: its column is the body screw B_n, at all angles.",
        "Column n - 1 is B_{n-1} as joint n has moved it, seen from the end-effector: by "
        "Ad(exp(-[B_n] q_n)).",
        "Go from the last joint to the first and keep T: note the column Ad(T) B_i, then multiply "
        "T on the right by exp(-[B_i] q_i). At the end, put the columns in the joints' order.",
    ),
    forbidden=("course_lib.arms.SerialArm",),
    mistakes=(
        shared.ONE_COLUMN,
        Mistake(
            "the exponentials of the body screws are in the wrong order, or of the wrong joints",
            "Which exponentials change column i, and in which order?",
            _moved_by(lambda each, i: each[i + 1 :]),
            _moved_by(lambda each, i: each[:i]),
            _moved_by(lambda each, i: each[i + 2 :][::-1]),
        ),
        Mistake(
            "the columns are hybrid twists, along the axes of the base",
            "Along the axes of which frame does a body twist see the motion?",
            _hybrid,
        ),
        Mistake(
            "an axis is moved by the next joint only",
            "Which joints lie between axis 1 and the end-effector of an arm with three joints?",
            _moved_by(lambda each, i: each[i + 1 : i + 2]),
        ),
    ),
)
