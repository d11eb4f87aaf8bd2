"""body_jacobian: the joints' screw axes as the end-effector sees them now."""

import numpy as np

from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.poe_kuka_iiwa.shared import (
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
    whole_screws,
)
from course_lib.checks.vocabulary import (
    SAME_TWICE,
    degrees_mixed_up,
    few_digits,
    halves_swapped,
    near,
    products,
    remembered,
)
from course_lib.rigid import adjoint, inverse


@remembered
def _right(screws, M, q):
    return adjoint(inverse(tool_pose(screws, M, q))) @ jacobian(screws, q)


def _seen_from(pose):
    """Return the answer of somebody who takes another pose for the end-effector's: pose(screws, M, q)."""
    return lambda screws, M, q: adjoint(inverse(pose(screws, M, q))) @ jacobian(screws, q)


def _changed_by(matrix):
    """Return the answer with another 6 x 6 matrix before the space Jacobian: matrix(R, p) of the tool's pose."""

    def answer(screws, M, q):
        T = tool_pose(screws, M, q)
        return matrix(T[:3, :3], T[:3, 3]) @ jacobian(screws, q)

    return answer


def _twice(wrong):
    def answer(screws, M, q):
        T = tool_pose(screws, M, q)
        R, p = T[:3, :3], T[:3, 3]
        J = columns([wrong(A[:3, :3], A[:3, 3]) for A in before(screws, q)], screws)
        return wrong(R.T, -R.T @ p) @ J

    return answer


def _from_the_tool(others, sign=-1, wrong=None):
    """Return the answer of somebody who begins at the end-effector, with its axes B and exp(sign [B] q).

    others(exponentials, i): those that change column i. wrong: another adjoint in the columns.
    """

    def answer(screws, M, q):
        B = screws @ adjoint(inverse(M)).T
        each = exponentials(B, sign * q)
        poses = [products(others(each, i))[-1] for i in range(len(q))]
        return columns([wrong(T[:3, :3], T[:3, 3]) for T in poses] if wrong else adjoint(poses), B)

    return answer


def _behind(each, i):
    return each[i + 1 :][::-1]


_HOME = "The joints between this one and the end-effector have moved its axis away, as seen from the end-effector."

EXERCISE = Exercise(
    name="body_jacobian",
    points=2,
    arguments=("screws", "M", "q"),
    cases=arms,
    returns=read_jacobian(lambda screws, M, q: len(q)),
    properties=(
        SAME_TWICE,
        Property(
            "the last column is Ad(M^-1) Sn at all angles: seen from the end-effector, the last axis does not move",
            lambda J, screws, M, q: near(J[:, -1], adjoint(inverse(M)) @ screws[-1]),
            says=lambda J, screws, M, q: (
                f"That is {format_tuple(adjoint(inverse(M)) @ screws[-1])}; yours is {format_tuple(J[:, -1])}."
            ),
        ),
        Property(
            "above, each column has the direction of its axis, along the end-effector's own axes",
            lambda J, *arm: near(J[:3], _right(*arm)[:3]),
            says=lambda J, *arm: off_column(J, _right(*arm), 0, 3),
        ),
        Property(
            "below, each column has the velocity of the end-effector's origin, along the end-effector's own axes",
            lambda J, *arm: near(J[3:], _right(*arm)[3:]),
            says=lambda J, *arm: off_column(J, _right(*arm), 3, 6),
        ),
    ),
    mistakes=(
        few_digits(_right),
        whole_screws(_right),
        Mistake(
            "the space Jacobian is returned",
            "That is seen from the base frame, not from the end-effector.",
            lambda screws, M, q: jacobian(screws, q),
        ),
        Mistake(
            "Ad(T) stands where Ad(T^-1) belongs",
            "T takes what the end-effector sees to what the base sees. Here you need the opposite direction.",
            lambda screws, M, q: adjoint(tool_pose(screws, M, q)) @ jacobian(screws, q),
        ),
        Mistake(
            "M is missing in T",
            "The pose of the end-effector ends with M.",
            _seen_from(lambda screws, M, q: products(exponentials(screws, q))[-1]),
        ),
        Mistake(
            "M stands on the left in T",
            "The pose of the end-effector ends with M.",
            _seen_from(lambda screws, M, q: M @ products(exponentials(screws, q))[-1]),
        ),
        Mistake(
            "the exponentials in T are multiplied in the reverse order",
            "The exponential of joint 1 stays on the left.",
            _seen_from(lambda screws, M, q: products(exponentials(screws, q)[::-1])[-1] @ M),
        ),
        Mistake("the end-effector is taken where it is at home", _HOME, _seen_from(lambda screws, M, q: M)),
        Mistake(
            "the columns are the body screws at home",
            _HOME,
            lambda screws, M, q: adjoint(inverse(M)) @ screws.T,
        ),
        Mistake(
            "the screw axes are left as they are at home",
            "The joints before have moved them, as in the space Jacobian.",
            lambda screws, M, q: adjoint(inverse(tool_pose(screws, M, q))) @ screws.T,
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
            lambda screws, M, q: np.kron(np.eye(2), tool_pose(screws, M, q)[:3, :3]) @ _right(screws, M, q),
        ),
        Mistake(
            "the adjoint of T is transposed where it is to be inverted",
            "The inverse of a rotation is its transpose; that of an adjoint is not.",
            lambda screws, M, q: adjoint(tool_pose(screws, M, q)).T @ jacobian(screws, q),
            lambda screws, M, q: adjoint(inverse(tool_pose(screws, M, q))).T @ jacobian(screws, q),
        ),
        *adjoint_mistakes(_twice, lambda wrong: _from_the_tool(_behind, wrong=wrong)),
        halves_swapped(_right, "v stands above omega", "Twists are (omega, v): the first three rows are omega."),
        Mistake(
            "the exponentials of the body screws lack their minus sign, or the joints rotate in the opposite direction",
            "Seen from the end-effector, the arm behind it moves backwards.",
            _from_the_tool(_behind, 1),
        ),
        Mistake(
            "the exponentials of the body screws are in the wrong order, or those of the wrong joints",
            "Column i is moved by the joints between it and the end-effector; the last joint's exponential is on "
            "the left.",
            _from_the_tool(lambda each, i: each[i + 1 :]),
            _from_the_tool(lambda each, i: each[:i]),
            _from_the_tool(lambda each, i: each[i + 1 :], 1),
            _from_the_tool(lambda each, i: each[i + 2 :][::-1]),
        ),
        degrees_mixed_up(_right, 2),
        Mistake(
            "the columns are multiplied by the angles",
            "The Jacobian is multiplied by joint velocities later; the angles only say where the axes are.",
            lambda screws, M, q: _right(screws, M, q) * q,
        ),
        Mistake(
            "the columns stand in the reverse order",
            "The first joint's column is the first: after a loop from the last joint on, reverse the list.",
            lambda screws, M, q: _right(screws, M, q)[:, ::-1],
        ),
        Mistake(
            "Ad(M) stands where Ad(M^-1) belongs",
            "M takes what the end-effector sees to what the base sees. The body screws need the other direction.",
            lambda screws, M, q: _from_the_tool(_behind)(screws @ adjoint(M @ M).T, M, q),
        ),
        reshaped(_right),
    ),
    hints=(
        "Begin at the last joint: its column is B_n, your body screw, at all angles.",
        "Column n - 1 is B_{n-1} as joint n has moved it, seen from the end-effector: by Ad(exp(-[B_n] q_n)).",
        "Go from the last joint to the first and keep T: note the column Ad(T) B_i, then multiply T on the right by "
        "exp(-[B_i] q_i). At the end, put the columns in the joints' order.",
    ),
    library=_right,
    forbidden=("course_lib.arms.SerialArm",),
)
