"""space_jacobian: the joints' screw axes where the arm has carried them."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.poe_kuka_iiwa.chains import (
    SAME_TWICE,
    arms,
    few_digits,
    products,
    remembered,
    turns,
    whole_axes,
    whole_numbers,
)
from course_lib.checks.poe_kuka_iiwa.matrices import near
from course_lib.checks.poe_kuka_iiwa.wrong_adjoints import ADJOINTS
from course_lib.checks.rotations.predicates import either
from course_lib.rigid import adjoint, inverse
from course_lib.rotations import hat

TRANSPOSED = Mistake(
    "rows and columns are swapped", "One column for each joint: the shape is (6, n). Transpose with .T."
)
_ONE_COLUMN = Mistake("only one column is returned", "Collect the columns of all joints, and stand them side by side.")
_HALF = Mistake("only one half of the Jacobian is returned", "Each column is a twist: omega above, v below.")


def reader(joints):
    """Reads an array (6, n); joints(*arguments) is n."""

    def known(array, *case):
        n = joints(*case)
        if array.shape in ((n, 6), (n, 6, 1)):
            return TRANSPOSED
        if array.shape == (6,):
            return _ONE_COLUMN
        return _HALF if array.shape == (3, n) else None

    return numbers(lambda *case: (6, joints(*case)), known)


@remembered
def before(screws, theta):
    """The products of the exponentials of the joints before each one."""
    return products(turns(screws, theta))[:-1]


def columns(matrices, screws):
    """Matrix i times screw axis i, side by side."""
    return np.einsum("nij,nj->in", matrices, screws)


@remembered
def jacobian(screws, theta):
    """The right answer."""
    return columns(adjoint(before(screws, theta)), screws)


def with_adjoint(matrix_of):
    """The Jacobian of somebody with another adjoint: matrix_of(R, p), 6 x 6."""
    return lambda screws, theta: columns([matrix_of(T[:3, :3], T[:3, 3]) for T in before(screws, theta)], screws)


def _moved_by(others):
    """The Jacobian of somebody who lets other joints carry each axis: others(turns) gives a pose for each."""
    return lambda screws, theta: columns(adjoint(others(turns(screws, theta))), screws)


def off_column(J, right, first=0, last=6):
    """Which column is off first in these rows, in words."""
    i = int(np.argmax([not near(J[first:last, k], right[first:last, k]) for k in range(right.shape[1])]))
    ours, yours = right[first:last, i], J[first:last, i]
    return f"J[{first}:{last}, {i}] should be {format_tuple(ours)}; yours is {format_tuple(yours)}."


SPACE_JACOBIAN = Exercise(
    name="space_jacobian",
    points=2,
    arguments=("screws", "theta"),
    cases=lambda rng: [(screws, theta) for screws, M, theta in arms(rng, whole_axes())],
    returns=reader(lambda screws, theta: len(theta)),
    properties=(
        SAME_TWICE,
        Property(
            "the first column is the first screw axis: no joint stands before it",
            lambda J, screws, theta: near(J[:, 0], screws[0]),
            seen=lambda J, screws, theta: f"That is {format_tuple(screws[0])}; yours is {format_tuple(J[:, 0])}.",
        ),
        Property(
            "with all angles 0 the columns are the screw axes as they are",
            lambda J, screws, theta: near(J, screws.T),
            seen=lambda J, screws, theta: off_column(J, screws.T),
            where=lambda screws, theta: not theta.any(),
        ),
        Property(
            "above, each column has the direction of its axis, turned by all joints before it",
            lambda J, screws, theta: near(J[:3], jacobian(screws, theta)[:3]),
            seen=lambda J, screws, theta: off_column(J, jacobian(screws, theta), 0, 3),
        ),
        Property(
            "below, each column has v = -omega x p, with a point p of its axis where the joints before have moved it, "
            "so that J theta' is the hand's twist: [V] = T' T^-1",
            lambda J, screws, theta: near(J[3:], jacobian(screws, theta)[3:]),
            seen=lambda J, screws, theta: off_column(J, jacobian(screws, theta), 3, 6),
        ),
    ),
    mistakes=(
        few_digits(jacobian),
        *whole_numbers(jacobian),
        Mistake(
            "the screw axes are left as they are at home",
            "An axis is carried by the joints before it (its own leaves it where it is): Ad(exp([S1] theta1)) S2.",
            lambda screws, theta: screws.T,
        ),
        *(mistake for words, wrong in ADJOINTS.items() for mistake in either(words, *map(with_adjoint, wrong))),
        Mistake(
            "each column leaves out the joint just before it",
            "Column i is carried by all the joints before it, joint i - 1 included.",
            _moved_by(lambda turn: [np.eye(4), *products(turn)[:-2]]),
        ),
        Mistake(
            "each column is carried by the joint just before it only",
            "Column i is carried by all the joints before it: multiply their exponentials up.",
            _moved_by(lambda turn: [np.eye(4), *turn[:-1]]),
        ),
        Mistake(
            "the exponentials are multiplied in the reverse order",
            "T = T @ exp_se3(...): the exponential of joint 1 stays on the left.",
            _moved_by(lambda turn: [products(turn[:i][::-1])[-1] for i in range(len(turn))]),
            _moved_by(lambda turn: [products(turn[: i + 1][::-1])[-1] for i in range(len(turn))]),
        ),
        Mistake(
            "every column is carried by all the joints",
            "Column i is carried by the joints before it only.",
            _moved_by(lambda turn: [products(turn)[-1]] * len(turn)),
        ),
        Mistake(
            "each column is carried by the joints behind it",
            "Joint 1 carries joint 2, not the other way round: column i has the exponentials of joints 1 to i - 1.",
            _moved_by(lambda turn: [products(turn[i + 1 :])[-1] for i in range(len(turn))]),
            _moved_by(lambda turn: [products(turn[i:])[-1] for i in range(len(turn))]),
        ),
        Mistake(
            "the body Jacobian is returned",
            "That is seen from the hand. The space Jacobian is seen from the space frame: no inverse is needed.",
            lambda screws, theta: adjoint(inverse(products(turns(screws, theta))[-1])) @ jacobian(screws, theta),
        ),
        Mistake(
            "the adjoint is that of the inverse",
            "Ad(T) with T = exp([S1] theta1) ... as it is, not its inverse.",
            _moved_by(lambda turn: [inverse(T) for T in products(turn)[:-1]]),
        ),
        Mistake(
            "the exponentials are added up",
            "One motion after another is a product: @.",
            lambda screws, theta: columns(
                [
                    np.block([[T[:3, :3], np.zeros((3, 3))], [hat(T[:3, 3]) @ T[:3, :3], T[:3, :3]]])
                    for T in np.cumsum([np.eye(4), *turns(screws, theta)[:-1]], 0)
                ],
                screws,
            ),
        ),
        Mistake(
            "v stands above omega",
            "Twists are (omega, v): the first three rows are omega.",
            lambda screws, theta: np.roll(jacobian(screws, theta), 3, axis=0),
            lambda screws, theta: jacobian(np.roll(screws, 3, axis=1), theta),
        ),
        Mistake(
            "the columns are multiplied by the angles",
            "The Jacobian is multiplied by the speeds theta' later: the angles only say where the axes are.",
            lambda screws, theta: jacobian(screws, theta) * theta,
        ),
        Mistake(
            "degrees and radians are mixed up",
            "Angles are radians everywhere: no np.deg2rad, no np.rad2deg.",
            lambda screws, theta: jacobian(screws, np.deg2rad(theta)),
            lambda screws, theta: jacobian(screws, np.rad2deg(theta)),
        ),
        Mistake(
            "the joints turn the other way round",
            "exp([S] theta), without a minus: counter-clockwise about omega.",
            lambda screws, theta: jacobian(screws, -theta),
        ),
        Mistake(
            "the exponentials are taken without the angles",
            "exp([S] theta): theta times all six numbers of S.",
            lambda screws, theta: jacobian(screws, 0 * theta + 1),
        ),
        Mistake(
            "the numbers are in the right order, but broken into rows wrongly",
            "Transpose with .T, not by reshape.",
            lambda screws, theta: jacobian(screws, theta).T.reshape(6, -1),
        ),
    ),
    hints=(
        "Column 1 is S1. Column 2 is S2 as joint 1 has carried it: Ad(exp([S1] theta1)) S2.",
        "Column i is Ad(T) S_i with T = exp([S1] theta1) ... exp([S_{i-1}] theta_{i-1}), the joints before it.",
        "Begin with T = np.eye(4). For each joint: append adjoint(T) @ screws[i], then T = T @ exp_se3(screws[i] * "
        "theta[i]). At last np.column_stack.",
    ),
    forbidden=("course_lib.arms.SerialArm",),
)
