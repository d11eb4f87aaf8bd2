"""body_jacobian: the joints' screw axes as the end-effector sees them now."""

import numpy as np

from course_lib.checks.exercise import Exercise, Mistake
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import SAME_TWICE, part_is, products, remembered
from course_lib.lessons.poe_kuka_iiwa.exercises import shared
from course_lib.rigid import adjoint, inverse


@remembered
def _right(screws, M, q):
    return adjoint(inverse(shared.tool_pose(screws, M, q))) @ shared.jacobian(screws, q)


EXERCISE = Exercise(
    name="body_jacobian",
    points=3,
    arguments=("screws", "M", "q"),
    tolerance=EXACT,
    cases=shared.arms,
    returns=shared.read_jacobian,
    library=_right,
    sweeps=(shared.SMALL_ANGLES, shared.STRAIGHT),
    angles=("q",),
    properties=(
        SAME_TWICE,
        part_is(
            "the last column is Ad(M^-1) Sn at all angles: seen from the end-effector, the last "
            "axis does not move",
            _right,
            np.s_[:, -1],
            Mistake(
                "the last column is not B_n",
                "Which joints lie between the last axis and the end-effector? Along whose axes "
                "does "
                "this Jacobian see the last axis?",
            ),
        ),
        part_is(
            "in the upper three rows, each column has the direction of its axis, along the "
            "end-effector's own axes",
            _right,
            np.s_[:3],
            Mistake(
                "an axis is not moved by all joints between it and the end-effector, each by its "
                "own angle",
                "Which exponentials, in which order, stand in Ad(...) before the body screw of the "
                "column named below?",
            ),
            "The upper half of the {} column",
        ),
        part_is(
            "in the lower three rows, each column has the velocity of the end-effector's origin, "
            "along the end-effector's axes",
            _right,
            np.s_[3:],
            what="The lower half of the {} column",
        ),
    ),
    hints=(
        "Begin at the last joint: its column is the body screw B_n, at all angles.",
        "Column n - 1 is B_{n-1} as joint n has moved it, seen from the end-effector: by "
        "Ad(exp(-[B_n] q_n)).",
        "Go from the last joint to the first and keep T: note the column Ad(T) B_i, then multiply "
        "T on the right by "
        "exp(-[B_i] q_i). At the end, put the columns in the joints' order.",
    ),
    forbidden=("course_lib.arms.SerialArm",),
)

EXERCISE.mistake(shared.ONE_COLUMN, form=(6,))


@EXERCISE.mistake(
    "the exponentials of the body screws are in the wrong order, or of the wrong joints",
    "Which exponentials change column i, and in which order?",
    others=(
        lambda each, i: each[i + 1 :],
        lambda each, i: each[:i],
        lambda each, i: each[i + 2 :][::-1],
    ),
)
def other_joints(screws, M, q, others):
    B = screws @ adjoint(inverse(M)).T
    each = shared.exponentials(B, -q)
    return shared.columns([adjoint(products(others(each, i))[-1]) for i in range(len(q))], B)


@EXERCISE.mistake(
    "the columns are hybrid twists, along the axes of the base",
    "Along the axes of which frame does a body twist see the motion?",
)
def along_the_axes_of_the_base(screws, M, q):
    R = shared.tool_pose(screws, M, q)[shared.BLOCK]
    return np.kron(np.eye(2), R) @ _right(screws, M, q)


@EXERCISE.mistake(
    "an axis is moved by the next joint only",
    "Which joints lie between axis 1 and the end-effector of an arm with three joints?",
)
def next_joint_only(screws, M, q):
    B = screws @ adjoint(inverse(M)).T
    each = [*shared.exponentials(B, -q)[1:], np.eye(4)]
    return shared.columns([adjoint(T) for T in each], B)
