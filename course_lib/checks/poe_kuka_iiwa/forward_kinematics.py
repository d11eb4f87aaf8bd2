"""forward_kinematics: the pose of the end-effector, by the product of exponentials."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.poe_kuka_iiwa.shared import (
    WHOLE,
    WHOLE_ANGLES,
    WHOLE_HOME,
    arms,
    exponentials,
    tool_pose,
)
from course_lib.checks.vocabulary import (
    FINE,
    SAME_TWICE,
    few_digits,
    inverted,
    near,
    orthogonality_error,
    products,
    transposed,
    whole_numbers,
)
from course_lib.rigid import exp_se3

_ONLY_PART = Mistake(
    "only a part of the pose is returned", "The answer is the whole matrix T = [[R, p], [0, 0, 0, 1]], 4 x 4."
)
_EACH = Mistake(
    "a list with a matrix for each joint is returned", "Multiply the exponentials, and return one matrix, 4 x 4."
)


def _known_form(array, screws, M, theta):
    if array.shape in ((3,), (3, 3), (3, 4)):
        return _ONLY_PART
    n = len(theta)
    return _EACH if array.shape in ((n, 4, 4), (n + 1, 4, 4)) else None


def off_the_tool(T, screws, M, theta):
    """Return in words how far the pose T is from the right one."""
    right = tool_pose(screws, M, theta)
    if not near(T[:3, 3], right[:3, 3]):
        return f"It is at {format_tuple(right[:3, 3])}; the last column of yours says {format_tuple(T[:3, 3])}."
    i = int(np.argmax(np.abs(T[:3, :3] - right[:3, :3]).max(0)))
    return (
        f"Your position is right, but not the orientation: the end-effector's {'xyz'[i]} axis, column {i}, is "
        f"{format_tuple(right[:3, i])}; yours is {format_tuple(T[:3, i])}."
    )


def _with(each):
    """The answer of somebody with another matrix for each joint; each(screws, theta) gives them all."""
    return lambda screws, M, theta: products(each(screws, theta))[-1] @ M


def _scaled(omega, v):
    """Exponentials in which theta multiplies only one half of the screw axis, or neither."""

    def each(screws, theta):
        halves = [np.tile(theta if used else 0 * theta + 1, (3, 1)) for used in (omega, v)]
        return exp_se3(screws * np.concatenate(halves).T)

    return _with(each)


def _entry_by_entry(screws, M, theta):
    T = np.eye(4)
    for E in exponentials(screws, theta):
        T = T * E
    return T


def _with_M_each_time(screws, M, theta):
    return products([E @ M for E in exponentials(screws, theta)])[-1]


def _some(part):
    """The answer of somebody who leaves out joints."""
    return lambda screws, M, theta: tool_pose(screws[part], M, theta[part])


def _reversed(screws, theta):
    return exponentials(screws, theta)[::-1]


EXERCISE = Exercise(
    name="forward_kinematics",
    points=2,
    arguments=("screws", "M", "theta"),
    cases=lambda rng: [*arms(rng), (WHOLE, WHOLE_HOME, WHOLE_ANGLES)],
    returns=numbers(lambda *case: (4, 4), _known_form),
    properties=(
        SAME_TWICE,
        Property(
            "with all angles 0 the end-effector is at home: T = M",
            lambda T, screws, M, theta: near(T, M),
            where=lambda screws, M, theta: not theta.any(),
        ),
        Property(
            "the last row of T is (0, 0, 0, 1)",
            lambda T, screws, M, theta: near(T[3], [0, 0, 0, 1]),
            seen=lambda T, screws, M, theta: f"Yours is {format_tuple(T[3])}.",
        ),
        Property(
            "the block R of T is a rotation: R^T R = I and det R = 1",
            lambda T, screws, M, theta: orthogonality_error(T[:3, :3]) < FINE and np.linalg.det(T[:3, :3]) > 0,
            seen=lambda T, screws, M, theta: f"The largest entry of R^T R - I is {orthogonality_error(T[:3, :3]):.2g}.",
        ),
        Property(
            "if only one joint has rotated, T = exp([S] theta) M, with S and theta of that joint",
            lambda T, screws, M, theta: near(T, tool_pose(screws, M, theta)),
            seen=off_the_tool,
            where=lambda screws, M, theta: np.count_nonzero(theta) == 1,
        ),
        Property(
            "T = exp([S1] theta1) exp([S2] theta2) ... exp([Sn] thetan) M",
            lambda T, screws, M, theta: near(T, tool_pose(screws, M, theta)),
            seen=off_the_tool,
        ),
    ),
    mistakes=(
        few_digits(tool_pose),
        whole_numbers(tool_pose),
        Mistake(
            "M is missing",
            "The exponentials only move the end-effector away from home. Where does its pose at home come in?",
            lambda screws, M, theta: products(exponentials(screws, theta))[-1],
        ),
        Mistake(
            "M stands on the left of the exponentials",
            "The screw axes are seen from the base frame. On which side of M does a motion seen from the base act?",
            lambda screws, M, theta: M @ products(exponentials(screws, theta))[-1],
        ),
        Mistake(
            "the exponentials are multiplied in the reverse order",
            "Joint 1 moves all the others: which exponential is applied last?",
            lambda screws, M, theta: products(_reversed(screws, theta))[-1] @ M,
            lambda screws, M, theta: M @ products(_reversed(screws, theta))[-1],
            lambda screws, M, theta: products(_reversed(screws, theta))[-1],
        ),
        Mistake(
            "the exponentials are added up",
            "One motion after another is a product of matrices.",
            lambda screws, M, theta: exponentials(screws, theta).sum(0) @ M,
            lambda screws, M, theta: (np.eye(4) + exponentials(screws, theta).sum(0)) @ M,
        ),
        Mistake(
            "the twists are added up, and one exponential is taken of the sum",
            "For matrices exp(A) exp(B) is not exp(A + B).",
            lambda screws, M, theta: exp_se3(theta @ screws) @ M,
        ),
        Mistake(
            "degrees and radians are mixed up",
            "Angles are in radians throughout.",
            lambda screws, M, theta: tool_pose(screws, M, np.deg2rad(theta)),
            lambda screws, M, theta: tool_pose(screws, M, np.rad2deg(theta)),
        ),
        Mistake(
            "the joints rotate the other way round",
            "A positive angle is counter-clockwise about omega: no minus.",
            lambda screws, M, theta: tool_pose(screws, M, -theta),
        ),
        Mistake(
            "the last joint is left out",
            "range(n) goes from 0 to n - 1 already.",
            _some(slice(-1)),
        ),
        Mistake("the first joint is left out", "In Python counting begins at 0.", _some(slice(1, None))),
        Mistake(
            "only one joint moves the end-effector",
            "In the loop, each joint multiplies what the joints before it have made.",
            _some(slice(-1, None)),
            _some(slice(1)),
        ),
        Mistake(
            "theta multiplies only one half of the screw axis",
            "theta times all six numbers of S.",
            _scaled(True, False),
            _scaled(False, True),
        ),
        Mistake("the angles are not used", "exp([S] theta): where is theta?", _scaled(False, False)),
        Mistake(
            "the halves of the screw axes are swapped",
            "The order in this course is (omega, v).",
            lambda screws, M, theta: tool_pose(np.roll(screws, 3, axis=1), M, theta),
        ),
        Mistake(
            "the product is entry by entry",
            "In numpy * works entry by entry; the product of matrices is @.",
            lambda screws, M, theta: products(exponentials(screws, theta))[-1] * M,
            lambda screws, M, theta: _entry_by_entry(screws, M, theta) * M,
            lambda screws, M, theta: _entry_by_entry(screws, M, theta) @ M,
            lambda screws, M, theta: np.prod(exponentials(screws, theta), axis=0) @ M,
        ),
        inverted(tool_pose, "the inverse of T is returned", "T takes coordinates in the tool frame to the base frame."),
        Mistake(
            "M is inverted",
            "M is the pose at home, as it is.",
            lambda screws, M, theta: tool_pose(screws, np.linalg.inv(M), theta),
        ),
        transposed(tool_pose, "T is transposed", "T = [[R, p], [0, 1]]: p is the last column."),
        Mistake(
            "M comes in more than once",
            "M comes in once, after the last exponential.",
            _with_M_each_time,
            lambda screws, M, theta: _with_M_each_time(screws, M, theta) @ M,
            lambda screws, M, theta: M @ tool_pose(screws, M, theta),
            lambda screws, M, theta: np.linalg.inv(M) @ tool_pose(screws, M, theta),
        ),
        Mistake(
            "the angles go with the wrong joints",
            "screws[i] goes with theta[i].",
            lambda screws, M, theta: tool_pose(screws, M, theta[::-1]),
        ),
        Mistake(
            "the end-effector stays at home",
            "T = M for theta = 0 only. Does the loop change T?",
            lambda screws, M, theta: M,
        ),
        Mistake(
            "the position is right and the orientation is left out",
            "The product of the exponentials and M gives R and p at once.",
            lambda screws, M, theta: np.column_stack([np.eye(4)[:, :3], tool_pose(screws, M, theta)[:, 3]]),
            lambda screws, M, theta: np.column_stack([M[:, :3], tool_pose(screws, M, theta)[:, 3]]),
        ),
    ),
    hints=(
        "Let joint n move the end-effector first, from its pose at home: exp([Sn] thetan) M. Then joint n - 1, "
        "and so on.",
        "One exponential for each joint, of its screw axis times its angle; all are multiplied, joint 1 on the left.",
        "Begin with the identity; in the loop, multiply on the right by the next joint's exponential; M comes last.",
    ),
    library=tool_pose,
    forbidden=("course_lib.arms.SerialArm",),
)
