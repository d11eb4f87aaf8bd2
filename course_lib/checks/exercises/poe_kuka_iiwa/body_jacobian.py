"""body_jacobian: the joints' screw axes as the end-effector sees them now."""

import numpy as np

from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.exercises.poe_kuka_iiwa.shared import (
    arms,
    columns,
    exponentials,
    first_off,
    jacobian,
    read_jacobian,
    tool_pose,
)
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.vocabulary import SAME_TWICE, near, products, remembered
from course_lib.rigid import adjoint, inverse


@remembered
def _right(screws, M, q):
    return adjoint(inverse(tool_pose(screws, M, q))) @ jacobian(screws, q)


EXERCISE = Exercise(
    name="body_jacobian",
    points=3,
    arguments=("screws", "M", "q"),
    cases=arms,
    returns=read_jacobian,
    library=_right,
    properties=(
        SAME_TWICE,
        Property(
            "the last column is Ad(M^-1) Sn at all angles: seen from the end-effector, the last axis does not move",
            lambda J, screws, M, q: near(J[:, -1], adjoint(inverse(M)) @ screws[-1]),
            says=lambda J, screws, M, q: (
                f"That is {format_tuple(adjoint(inverse(M)) @ screws[-1])}; yours is {format_tuple(J[:, -1])}, "
                f"off by {np.abs(J[:, -1] - adjoint(inverse(M)) @ screws[-1]).max():.2g}."
            ),
        ),
        Property(
            "above, each column has the direction of its axis, along the end-effector's own axes",
            lambda J, *arm: near(J[:3], _right(*arm)[:3]),
            says=lambda J, *arm: first_off(J[:3], _right(*arm)[:3], "The upper half of column"),
        ),
        Property(
            "below, each column has the velocity of the end-effector's origin, along the end-effector's own axes",
            lambda J, *arm: near(J[3:], _right(*arm)[3:]),
            says=lambda J, *arm: first_off(J[3:], _right(*arm)[3:], "The lower half of column"),
        ),
    ),
    hints=(
        "Begin at the last joint: its column is B_n, your body screw, at all angles.",
        "Column n - 1 is B_{n-1} as joint n has moved it, seen from the end-effector: by Ad(exp(-[B_n] q_n)).",
        "Go from the last joint to the first and keep T: note the column Ad(T) B_i, then multiply T on the right by "
        "exp(-[B_i] q_i). At the end, put the columns in the joints' order.",
    ),
    forbidden=("course_lib.arms.SerialArm",),
)


@EXERCISE.mistake(change=(adjoint, lambda T: np.eye(6)))
def other_direction(screws, M, q, change):
    """nothing, or Ad(T), stands where Ad(T^-1) belongs. T takes what the end-effector sees to what the base sees."""
    return change(tool_pose(screws, M, q)) @ jacobian(screws, q)


@EXERCISE.mistake(
    pose=(
        lambda each, M: products(each)[-1],
        lambda each, M: M @ products(each)[-1],
        lambda each, M: products(each[::-1])[-1] @ M,
        lambda each, M: M,
    )
)
def another_pose(screws, M, q, pose):
    """the pose that is inverted is not that of the end-effector at q. Compare it with your forward_kinematics."""
    return adjoint(inverse(pose(exponentials(screws, q), M))) @ jacobian(screws, q)


@EXERCISE.mistake(change=(lambda R, J, body: R.T @ J, lambda R, J, body: R @ J, lambda R, J, body: R @ body))
def half_way(screws, M, q, change):
    """the columns are only rotated, or only moved. Which axes and which origin has the end-effector?"""
    R = np.kron(np.eye(2), tool_pose(screws, M, q)[:3, :3])
    return change(R, jacobian(screws, q), _right(screws, M, q))


def _from_the_tool(screws, M, q, others=lambda each, i: each[i + 1 :][::-1], sign=-1, move=adjoint):
    """Return the columns of somebody who begins at the end-effector: others(exponentials, i) move column i."""
    B = screws @ adjoint(inverse(M)).T
    each = exponentials(B, sign * q)
    return columns([move(products(others(each, i))[-1]) for i in range(len(q))], B)


@EXERCISE.mistake
def minus_missing(screws, M, q):
    """the exponentials of the body screws lack their minus. Seen from the end-effector, how does the arm move?"""
    return _from_the_tool(screws, M, q, sign=1)


@EXERCISE.mistake(others=(lambda each, i: each[i + 1 :], lambda each, i: each[:i], lambda each, i: each[i + 2 :][::-1]))
def other_joints(screws, M, q, others):
    """the exponentials of the body screws are in the wrong order, or of the wrong joints. Which move column i?"""
    return _from_the_tool(screws, M, q, others)
