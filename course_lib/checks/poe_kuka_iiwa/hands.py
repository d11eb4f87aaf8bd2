"""forward_kinematics: the pose of the hand, by the product of exponentials."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.poe_kuka_iiwa.chains import (
    SAME_TWICE,
    WHOLE,
    WHOLE_ANGLES,
    WHOLE_HOME,
    arms,
    few_digits,
    products,
    remembered,
    turns,
    whole_numbers,
)
from course_lib.checks.poe_kuka_iiwa.matrices import FINE, near
from course_lib.checks.rotations.predicates import orthogonality_error
from course_lib.rigid import exp_se3

_ONLY_PART = Mistake(
    "only a part of the pose is returned", "The answer is the whole matrix T = [[R, p], [0, 0, 0, 1]], 4 x 4."
)
_EACH = Mistake(
    "a list with a matrix for each joint is returned", "Multiply the exponentials, and return one matrix, 4 x 4."
)
_PARTS = ((3,), (3, 3), (3, 4))


def _known_form(array, screws, M, theta):
    if array.shape in _PARTS:
        return _ONLY_PART
    n = len(theta)
    return _EACH if array.shape in ((n, 4, 4), (n + 1, 4, 4)) else None


@remembered
def hand(screws, M, theta):
    """The right pose."""
    return products(turns(screws, theta))[-1] @ M


def _off_the_hand(T, screws, M, theta):
    right = hand(screws, M, theta)
    if not near(T[:3, 3], right[:3, 3]):
        return f"The hand is at {format_tuple(right[:3, 3])}; the last column of yours says {format_tuple(T[:3, 3])}."
    i = int(np.argmax(np.abs(T[:3, :3] - right[:3, :3]).max(0)))
    return (
        f"Your hand is where it should be, but is not turned as it should: its {'xyz'[i]} axis, column {i}, is "
        f"{format_tuple(right[:3, i])}; yours is {format_tuple(T[:3, i])}."
    )


def _with(turn):
    """The answer of somebody with another matrix for each joint; turn(screws, theta) gives them all."""
    return lambda screws, M, theta: products(turn(screws, theta))[-1] @ M


def _scaled(omega, v):
    """Exponentials in which theta multiplies only one half, or neither."""

    def turn(screws, theta):
        factors = [
            np.repeat([theta if omega else 1 + 0 * theta], 3, 0),
            np.repeat([theta if v else 1 + 0 * theta], 3, 0),
        ]
        return exp_se3(screws * np.concatenate(factors).T)

    return _with(turn)


def _entry_by_entry(screws, M, theta):
    T = np.eye(4)
    for turn in turns(screws, theta):
        T = T * turn
    return T


def _with_M_each_time(screws, M, theta):
    return products([turn @ M for turn in turns(screws, theta)])[-1]


def _some(part):
    """The answer of somebody who leaves out joints."""
    return lambda screws, M, theta: hand(screws[part], M, theta[part])


def _swapped(screws):
    return np.roll(screws, 3, axis=1)


FORWARD_KINEMATICS = Exercise(
    name="forward_kinematics",
    points=2,
    arguments=("screws", "M", "theta"),
    cases=lambda rng: arms(
        rng, [(WHOLE.astype(float), WHOLE_HOME, np.array([0.4, -0.9, 1.1])), (WHOLE, WHOLE_HOME, WHOLE_ANGLES)]
    ),
    returns=numbers(lambda *case: (4, 4), _known_form),
    properties=(
        SAME_TWICE,
        Property(
            "with all angles 0 the hand is at home: T = M",
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
            "where only one joint turns, T = exp([S] theta) M, with S and theta of that joint",
            lambda T, screws, M, theta: near(T, hand(screws, M, theta)),
            seen=_off_the_hand,
            where=lambda screws, M, theta: np.count_nonzero(theta) == 1,
        ),
        Property(
            "T = exp([S1] theta1) exp([S2] theta2) ... exp([Sn] thetan) M",
            lambda T, screws, M, theta: near(T, hand(screws, M, theta)),
            seen=_off_the_hand,
        ),
    ),
    mistakes=(
        few_digits(hand),
        *whole_numbers(hand),
        Mistake(
            "M is missing, as in the formula that the report prints",
            "The exponentials only move the hand away from home. Its pose at home is M: ... exp([Sn] thetan) M.",
            lambda screws, M, theta: products(turns(screws, theta))[-1],
        ),
        Mistake(
            "M stands on the left of the exponentials",
            "The screw axes are seen from the space frame, so they act on M from the left: M comes last.",
            lambda screws, M, theta: M @ products(turns(screws, theta))[-1],
        ),
        Mistake(
            "the exponentials are multiplied in the reverse order",
            "Joint 1 carries all the others: its exponential stands first, on the left.",
            lambda screws, M, theta: products(turns(screws, theta)[::-1])[-1] @ M,
            lambda screws, M, theta: M @ products(turns(screws, theta)[::-1])[-1],
            lambda screws, M, theta: products(turns(screws, theta)[::-1])[-1],
        ),
        Mistake(
            "the exponentials are added up",
            "One motion after another is a product: @.",
            lambda screws, M, theta: turns(screws, theta).sum(0) @ M,
            lambda screws, M, theta: (np.eye(4) + turns(screws, theta).sum(0)) @ M,
        ),
        Mistake(
            "the twists are added up, and one exponential is taken of the sum",
            "For matrices exp(A) exp(B) is not exp(A + B): one exponential for each joint, then the product.",
            lambda screws, M, theta: exp_se3(theta @ screws) @ M,
        ),
        Mistake(
            "degrees and radians are mixed up",
            "Angles are radians everywhere: no np.deg2rad, no np.rad2deg.",
            lambda screws, M, theta: hand(screws, M, np.deg2rad(theta)),
            lambda screws, M, theta: hand(screws, M, np.rad2deg(theta)),
        ),
        Mistake(
            "the joints turn the other way round",
            "exp([S] theta), without a minus: counter-clockwise about omega.",
            lambda screws, M, theta: hand(screws, M, -theta),
        ),
        Mistake(
            "the last joint is left out",
            "range(n) goes from 0 to n - 1: do not take 1 off once more.",
            _some(slice(-1)),
        ),
        Mistake("the first joint is left out", "In Python counting begins at 0: screws[0].", _some(slice(1, None))),
        Mistake(
            "only one joint turns the hand",
            "T = T @ exp(...) in the loop, so that each joint adds its turn.",
            _some(slice(-1, None)),
            _some(slice(1)),
        ),
        Mistake(
            "theta multiplies only one half of the screw axis",
            "exp([S] theta): theta times all six numbers of S.",
            _scaled(True, False),
            _scaled(False, True),
        ),
        Mistake("the angles are not used", "exp([S] theta): theta times all six numbers of S.", _scaled(False, False)),
        Mistake(
            "the halves of the screw axes are swapped",
            "The order in this course is (omega, v): S[:3] is omega, S[3:] is v.",
            lambda screws, M, theta: hand(_swapped(screws), M, theta),
        ),
        Mistake(
            "the product is entry by entry",
            "In numpy the matrix product is @.",
            lambda screws, M, theta: products(turns(screws, theta))[-1] * M,
            lambda screws, M, theta: _entry_by_entry(screws, M, theta) * M,
            lambda screws, M, theta: _entry_by_entry(screws, M, theta) @ M,
            lambda screws, M, theta: np.prod(turns(screws, theta), axis=0) @ M,
            lambda screws, M, theta: np.prod(turns(screws, theta), axis=0) * M,
        ),
        Mistake(
            "the inverse of T is returned",
            "T takes coordinates in the hand to those in space: no inverse is needed.",
            lambda screws, M, theta: np.linalg.inv(hand(screws, M, theta)),
        ),
        Mistake(
            "M is inverted",
            "M is the hand's pose at home, as it is.",
            lambda screws, M, theta: hand(screws, np.linalg.inv(M), theta),
        ),
        Mistake(
            "T is transposed",
            "T = [[R, p], [0, 1]]: p is the last column.",
            lambda screws, M, theta: hand(screws, M, theta).T,
        ),
        Mistake(
            "M comes in once for each joint",
            "M comes in once, after the last exponential.",
            _with_M_each_time,
            lambda screws, M, theta: _with_M_each_time(screws, M, theta) @ M,
        ),
        Mistake(
            "M is multiplied on both sides",
            "M comes in once, after the last exponential.",
            lambda screws, M, theta: M @ hand(screws, M, theta),
            lambda screws, M, theta: np.linalg.inv(M) @ hand(screws, M, theta),
        ),
        Mistake(
            "the angles go with the wrong joints",
            "screws[i] goes with theta[i].",
            lambda screws, M, theta: hand(screws, M, theta[::-1]),
        ),
        Mistake(
            "the hand stays at home", "T = M for theta = 0 only. Does the loop change T?", lambda screws, M, theta: M
        ),
        Mistake(
            "the place is right and the turn is left out",
            "The product of the exponentials and M gives R and p at once.",
            lambda screws, M, theta: np.column_stack([np.eye(4)[:, :3], hand(screws, M, theta)[:, 3]]),
            lambda screws, M, theta: np.column_stack([M[:, :3], hand(screws, M, theta)[:, 3]]),
        ),
    ),
    hints=(
        "Let joint n move the hand first, from its pose at home: exp([Sn] thetan) M. Then joint n - 1, and so on.",
        "One exponential for each joint: exp_se3(screws[i] * theta[i]).",
        "T = np.eye(4), then T = T @ exp_se3(screws[i] * theta[i]) for each joint in turn, and at last T @ M.",
    ),
    forbidden=("course_lib.arms.SerialArm",),
)
