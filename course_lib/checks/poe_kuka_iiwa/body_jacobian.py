"""body_jacobian: the joints' screw axes as the end-effector sees them now."""

import numpy as np

from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.poe_kuka_iiwa.shared import (
    adjoint_mistakes,
    arms,
    before,
    columns,
    exponentials,
    jacobian,
    off_column,
    read_jacobian,
    reshaped,
    tool_pose,
)
from course_lib.checks.vocabulary import (
    SAME_TWICE,
    few_digits,
    halves_swapped,
    near,
    products,
    remembered,
    whole_numbers,
)
from course_lib.rigid import adjoint, inverse


@remembered
def _right(screws, M, theta):
    return adjoint(inverse(tool_pose(screws, M, theta))) @ jacobian(screws, theta)


def _seen_from(pose):
    """The answer of somebody who takes another pose for the end-effector's: pose(screws, M, theta)."""
    return lambda screws, M, theta: adjoint(inverse(pose(screws, M, theta))) @ jacobian(screws, theta)


def _changed_by(matrix):
    """The answer of somebody with another 6 x 6 matrix before the space Jacobian: matrix(R, p) of the tool's pose."""

    def answer(screws, M, theta):
        T = tool_pose(screws, M, theta)
        return matrix(T[:3, :3], T[:3, 3]) @ jacobian(screws, theta)

    return answer


def _in_the_last_step(wrong):
    return _changed_by(lambda R, p: wrong(R.T, -R.T @ p))


def _in_the_space_jacobian(wrong):
    def answer(screws, M, theta):
        J = columns([wrong(T[:3, :3], T[:3, 3]) for T in before(screws, theta)], screws)
        return adjoint(inverse(tool_pose(screws, M, theta))) @ J

    return answer


def _twice(wrong):
    def answer(screws, M, theta):
        T = tool_pose(screws, M, theta)
        R, p = T[:3, :3], T[:3, 3]
        J = columns([wrong(A[:3, :3], A[:3, 3]) for A in before(screws, theta)], screws)
        return wrong(R.T, -R.T @ p) @ J

    return answer


def _from_the_tool(others, sign=-1, wrong=None):
    """The answer of somebody who begins at the end-effector, with its axes B and exp(sign [B] theta).

    others(exponentials, i): those that change column i. wrong: another adjoint in the columns.
    """

    def answer(screws, M, theta):
        B = screws @ adjoint(inverse(M)).T
        each = exponentials(B, sign * theta)
        poses = [products(others(each, i))[-1] for i in range(len(theta))]
        return columns([wrong(T[:3, :3], T[:3, 3]) for T in poses] if wrong else adjoint(poses), B)

    return answer


def _behind(each, i):
    return each[i + 1 :][::-1]


_HOME = "The joints between this one and the end-effector have moved its axis away, as seen from the end-effector."

EXERCISE = Exercise(
    name="body_jacobian",
    points=2,
    arguments=("screws", "M", "theta"),
    cases=arms,
    returns=read_jacobian(lambda screws, M, theta: len(theta)),
    properties=(
        SAME_TWICE,
        Property(
            "the last column is Ad(M^-1) Sn at all angles: seen from the end-effector, the last axis does not move",
            lambda J, screws, M, theta: near(J[:, -1], adjoint(inverse(M)) @ screws[-1]),
            seen=lambda J, screws, M, theta: (
                f"That is {format_tuple(adjoint(inverse(M)) @ screws[-1])}; yours is {format_tuple(J[:, -1])}."
            ),
        ),
        Property(
            "above, each column has the direction of its axis, along the end-effector's own axes",
            lambda J, *arm: near(J[:3], _right(*arm)[:3]),
            seen=lambda J, *arm: off_column(J, _right(*arm), 0, 3),
        ),
        Property(
            "below, each column has the velocity of the end-effector's origin, along the end-effector's own axes",
            lambda J, *arm: near(J[3:], _right(*arm)[3:]),
            seen=lambda J, *arm: off_column(J, _right(*arm), 3, 6),
        ),
    ),
    mistakes=(
        few_digits(_right),
        whole_numbers(_right),
        Mistake(
            "the space Jacobian is returned",
            "That is seen from the base frame, not from the end-effector.",
            lambda screws, M, theta: jacobian(screws, theta),
        ),
        Mistake(
            "Ad(T) stands where Ad(T^-1) belongs",
            "T takes what the end-effector sees to what the base sees. Here it goes the other way.",
            lambda screws, M, theta: adjoint(tool_pose(screws, M, theta)) @ jacobian(screws, theta),
        ),
        Mistake(
            "M is missing in T",
            "The pose of the end-effector ends with M.",
            _seen_from(lambda screws, M, theta: products(exponentials(screws, theta))[-1]),
        ),
        Mistake(
            "M stands on the left in T",
            "The pose of the end-effector ends with M.",
            _seen_from(lambda screws, M, theta: M @ products(exponentials(screws, theta))[-1]),
        ),
        Mistake(
            "the exponentials in T are multiplied in the reverse order",
            "The exponential of joint 1 stays on the left.",
            _seen_from(lambda screws, M, theta: products(exponentials(screws, theta)[::-1])[-1] @ M),
        ),
        Mistake("the end-effector is taken where it is at home", _HOME, _seen_from(lambda screws, M, theta: M)),
        Mistake(
            "the columns are the body screws at home",
            _HOME,
            lambda screws, M, theta: adjoint(inverse(M)) @ screws.T,
        ),
        Mistake(
            "the screw axes are left as they are at home",
            "The joints before have moved them, as in the space Jacobian.",
            lambda screws, M, theta: adjoint(inverse(tool_pose(screws, M, theta))) @ screws.T,
        ),
        Mistake(
            "the columns are only rotated, not moved to the end-effector's origin",
            "v is the velocity at the origin of the frame, and that is another point now.",
            _changed_by(lambda R, p: np.kron(np.eye(2), R.T)),
            _changed_by(lambda R, p: np.kron(np.eye(2), R)),
        ),
        Mistake(
            "the columns are only moved to the end-effector's origin, not rotated into its axes",
            "The end-effector sees omega and v along its own axes.",
            lambda screws, M, theta: np.kron(np.eye(2), tool_pose(screws, M, theta)[:3, :3]) @ _right(screws, M, theta),
        ),
        Mistake(
            "the adjoint of T is transposed where it is to be inverted",
            "The inverse of a rotation is its transpose; that of an adjoint is not.",
            lambda screws, M, theta: adjoint(tool_pose(screws, M, theta)).T @ jacobian(screws, theta),
            lambda screws, M, theta: adjoint(inverse(tool_pose(screws, M, theta))).T @ jacobian(screws, theta),
        ),
        *adjoint_mistakes(
            _in_the_last_step,
            _in_the_space_jacobian,
            _twice,
            lambda wrong: _from_the_tool(_behind, wrong=wrong),
        ),
        halves_swapped(_right, "v stands above omega", "Twists are (omega, v): the first three rows are omega."),
        Mistake(
            "the exponentials of the body screws lack their minus",
            "Seen from the end-effector, the arm behind it moves backwards.",
            _from_the_tool(_behind, 1),
        ),
        Mistake(
            "the exponentials of the body screws are in the wrong order, or those of the wrong joints",
            "Column i is moved by the joints between it and the end-effector; the last joint's exponential is on "
            "the left.",
            _from_the_tool(lambda each, i: each[i + 1 :]),
            _from_the_tool(lambda each, i: each[:i]),
            _from_the_tool(lambda each, i: each[:i], 1),
            _from_the_tool(lambda each, i: each[i + 1 :], 1),
            _from_the_tool(lambda each, i: each[i + 2 :][::-1]),
        ),
        Mistake(
            "degrees and radians are mixed up",
            "Angles are in radians throughout.",
            lambda screws, M, theta: _right(screws, M, np.deg2rad(theta)),
            lambda screws, M, theta: _right(screws, M, np.rad2deg(theta)),
        ),
        Mistake(
            "the joints rotate the other way round",
            "A positive angle is counter-clockwise about omega: no minus.",
            lambda screws, M, theta: _right(screws, M, -theta),
        ),
        Mistake(
            "the columns are multiplied by the angles",
            "The Jacobian is multiplied by joint velocities later; the angles only say where the axes are.",
            lambda screws, M, theta: _right(screws, M, theta) * theta,
        ),
        reshaped(_right),
    ),
    hints=(
        "Begin at the last joint: its column is B_n, your body screw, at all angles.",
        "Column n - 1 is B_{n-1} as joint n has moved it, seen from the end-effector: by Ad(exp(-[B_n] theta_n)).",
        "Go from the last joint to the first and keep T: note the column Ad(T) B_i, then multiply T on the right by "
        "exp(-[B_i] theta_i). At the end, put the columns in the joints' order.",
    ),
    library=_right,
    forbidden=("course_lib.arms.SerialArm",),
)
