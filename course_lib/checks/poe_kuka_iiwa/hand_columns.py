"""body_jacobian: the joints' screw axes seen from the hand."""

import numpy as np

from course_lib.checks.exercise import Exercise, Property
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
from course_lib.checks.poe_kuka_iiwa.columns import columns, jacobian, off_column, reader, with_adjoint
from course_lib.checks.poe_kuka_iiwa.hands import hand
from course_lib.checks.poe_kuka_iiwa.matrices import near
from course_lib.checks.poe_kuka_iiwa.wrong_adjoints import ADJOINTS
from course_lib.checks.rotations.predicates import either
from course_lib.rigid import adjoint, inverse
from course_lib.rotations import hat


@remembered
def seen_from_the_hand(screws, M, theta):
    """The right answer."""
    return adjoint(inverse(hand(screws, M, theta))) @ jacobian(screws, theta)


def _seen_from(pose):
    """The answer of somebody who takes another pose for the hand's: pose(screws, M, theta)."""
    return lambda screws, M, theta: adjoint(inverse(pose(screws, M, theta))) @ jacobian(screws, theta)


def _changed_by(matrix):
    """The answer of somebody with another 6 x 6 matrix before the space Jacobian: matrix(R, p) of the hand's pose."""

    def answer(screws, M, theta):
        T = hand(screws, M, theta)
        return matrix(T[:3, :3], T[:3, 3]) @ jacobian(screws, theta)

    return answer


def _with_adjoint(wrong):
    """The answers of somebody with a wrong adjoint: in the last step, in the space Jacobian, and in both."""

    def last(R, p):
        return wrong(R.T, -R.T @ p)

    def both(screws, M, theta):
        T = hand(screws, M, theta)
        return last(T[:3, :3], T[:3, 3]) @ with_adjoint(wrong)(screws, theta)

    def first(screws, M, theta):
        return adjoint(inverse(hand(screws, M, theta))) @ with_adjoint(wrong)(screws, theta)

    return both, _changed_by(last), first


def _from_the_end(others, sign=-1):
    """The answer of somebody who begins at the hand, with its axes B and the exponentials of B theta with this sign.

    others(turns, i): those that change column i.
    """

    def answer(screws, M, theta):
        B = (adjoint(inverse(M)) @ screws.T).T
        turn = turns(B, sign * theta)
        return columns(adjoint([products(others(turn, i))[-1] for i in range(len(theta))]), B)

    return answer


_HOME = "Joint 1 carries the axis of joint 2 with it. Begin with the space Jacobian at these angles."

BODY_JACOBIAN = Exercise(
    name="body_jacobian",
    points=2,
    arguments=("screws", "M", "theta"),
    cases=lambda rng: arms(rng, whole_axes()),
    returns=reader(lambda screws, M, theta: len(theta)),
    properties=(
        SAME_TWICE,
        Property(
            "the last column is Ad(M^-1) Sn at all angles: the last joint does not move in the hand's frame",
            lambda J, screws, M, theta: near(J[:, -1], adjoint(inverse(M)) @ screws[-1]),
            seen=lambda J, screws, M, theta: (
                f"That is {format_tuple(adjoint(inverse(M)) @ screws[-1])}; yours is {format_tuple(J[:, -1])}."
            ),
        ),
        Property(
            "above, each column has its axis's direction as the hand sees it: R^T times that in the space Jacobian",
            lambda J, screws, M, theta: near(J[:3], seen_from_the_hand(screws, M, theta)[:3]),
            seen=lambda J, *arm: off_column(J, seen_from_the_hand(*arm), 0, 3),
        ),
        Property(
            "below, each column has the velocity of the hand's origin, along the hand's own axes, "
            "so that J theta' is the hand's twist: [V] = T^-1 T'",
            lambda J, screws, M, theta: near(J[3:], seen_from_the_hand(screws, M, theta)[3:]),
            seen=lambda J, *arm: off_column(J, seen_from_the_hand(*arm), 3, 6),
        ),
    ),
    mistakes=(
        few_digits(seen_from_the_hand),
        *whole_numbers(seen_from_the_hand),
        Mistake(
            "the space Jacobian is returned",
            "That is seen from the space frame. Ad(T^-1) takes it to the hand's.",
            lambda screws, M, theta: jacobian(screws, theta),
        ),
        Mistake(
            "Ad(T) stands where Ad(T^-1) belongs",
            "T takes coordinates in the hand to those in space. Here it goes the other way: Ad(T^-1).",
            lambda screws, M, theta: adjoint(hand(screws, M, theta)) @ jacobian(screws, theta),
        ),
        Mistake(
            "M is missing in T",
            "T = exp([S1] theta1) ... exp([Sn] thetan) M, with M last.",
            _seen_from(lambda screws, M, theta: products(turns(screws, theta))[-1]),
        ),
        Mistake(
            "M stands on the left in T",
            "T = exp([S1] theta1) ... exp([Sn] thetan) M, with M last.",
            _seen_from(lambda screws, M, theta: M @ products(turns(screws, theta))[-1]),
        ),
        Mistake(
            "the exponentials in T are multiplied in the reverse order",
            "Joint 1 carries all the others: its exponential stands first, on the left.",
            _seen_from(lambda screws, M, theta: products(turns(screws, theta)[::-1])[-1] @ M),
        ),
        Mistake(
            "the hand is taken where it is at home",
            "T = exp([S1] theta1) ... exp([Sn] thetan) M: M alone is the hand's pose at theta = 0.",
            _seen_from(lambda screws, M, theta: M),
        ),
        Mistake("the Jacobian is the one at home", _HOME, lambda screws, M, theta: adjoint(inverse(M)) @ screws.T),
        Mistake(
            "the screw axes are left as they are at home",
            _HOME,
            lambda screws, M, theta: adjoint(inverse(hand(screws, M, theta))) @ screws.T,
            lambda screws, M, theta: screws.T,
        ),
        Mistake(
            "the columns are only rotated, not moved to the hand's origin",
            "The matrix is Ad(T^-1), all of it: its block on the lower left brings v to the hand's origin.",
            _changed_by(lambda R, p: np.kron(np.eye(2), R.T)),
            _changed_by(lambda R, p: np.kron(np.eye(2), R)),
        ),
        Mistake(
            "the columns are only moved to the hand's origin, not turned into its frame",
            "The body Jacobian has the hand's own directions: R^T is left to do. Ad(T^-1) does both.",
            _changed_by(lambda R, p: np.block([[np.eye(3), 0 * R], [-hat(p), np.eye(3)]])),
        ),
        Mistake(
            "Ad(T) is transposed where it is to be inverted",
            "For rotations R^T is R^-1; for Ad(T) it is not so.",
            lambda screws, M, theta: adjoint(hand(screws, M, theta)).T @ jacobian(screws, theta),
            lambda screws, M, theta: adjoint(inverse(hand(screws, M, theta))).T @ jacobian(screws, theta),
        ),
        *(
            mistake
            for words, wrong in ADJOINTS.items()
            for one in wrong
            for mistake in either(words, *_with_adjoint(one))
        ),
        Mistake(
            "v stands above omega",
            "Twists are (omega, v): the first three rows are omega.",
            lambda screws, M, theta: np.roll(seen_from_the_hand(screws, M, theta), 3, axis=0),
            lambda screws, M, theta: seen_from_the_hand(np.roll(screws, 3, axis=1), M, theta),
        ),
        Mistake(
            "the exponentials of the hand's axes lack their minus",
            "Begun at the hand, column i is Ad(exp(-[Bn] thetan) ... exp(-[B_{i+1}] theta_{i+1})) B_i.",
            _from_the_end(lambda turn, i: turn[i + 1 :][::-1], 1),
        ),
        Mistake(
            "the exponentials of the hand's axes are in the wrong order",
            "Begun at the hand, column i is Ad(exp(-[Bn] thetan) ... exp(-[B_{i+1}] theta_{i+1})) B_i.",
            _from_the_end(lambda turn, i: turn[i + 1 :]),
            _from_the_end(lambda turn, i: turn[:i]),
            _from_the_end(lambda turn, i: turn[:i], 1),
            _from_the_end(lambda turn, i: turn[i + 1 :], 1),
        ),
        Mistake(
            "degrees and radians are mixed up",
            "Angles are radians everywhere: no np.deg2rad, no np.rad2deg.",
            lambda screws, M, theta: seen_from_the_hand(screws, M, np.deg2rad(theta)),
            lambda screws, M, theta: seen_from_the_hand(screws, M, np.rad2deg(theta)),
        ),
        Mistake(
            "the joints turn the other way round",
            "exp([S] theta), without a minus: counter-clockwise about omega.",
            lambda screws, M, theta: seen_from_the_hand(screws, M, -theta),
        ),
        Mistake(
            "the columns are multiplied by the angles",
            "The Jacobian is multiplied by the speeds theta' later: the angles only say where the axes are.",
            lambda screws, M, theta: seen_from_the_hand(screws, M, theta) * theta,
        ),
        Mistake(
            "the numbers are in the right order, but broken into rows wrongly",
            "Transpose with .T, not by reshape.",
            lambda screws, M, theta: seen_from_the_hand(screws, M, theta).T.reshape(6, -1),
        ),
    ),
    hints=(
        "It is the space Jacobian, each column as the hand sees it: Ad(T^-1) times the columns of your space_jacobian.",
        "T is where the hand is: forward_kinematics(screws, M, theta).",
        "adjoint(inverse(T)) @ space_jacobian(screws, theta).",
    ),
    forbidden=("course_lib.arms.SerialArm",),
)
