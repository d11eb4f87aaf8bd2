"""The known ways to go wrong in dh_modified and dh_standard."""

import itertools

import numpy as np

from course_lib.checks.exercise import Mistake
from course_lib.checks.panda_dh_ik.steps import (
    about_x,
    about_z,
    along_x,
    along_z,
    halves,
    joined,
    modified,
    placed,
    standard,
    with_another_turn,
    with_other_sign,
    with_sines_for_cosines,
)
from course_lib.checks.poe_kuka_iiwa.chains import few_digits
from course_lib.rigid import inverse
from course_lib.rotations import rot_x, rot_y, rot_z

FORMULAS = {
    modified: "Rot_x(alpha) Trans_x(a) Rot_z(theta) Trans_z(d)",
    standard: "Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha)",
}
_RADIANS = "Angles are radians everywhere: no np.deg2rad, no np.rad2deg."
_SIGNS = "In Rot_x and Rot_z the minus stands above the diagonal. rotations.rot_x and rotations.rot_z have it there."
_OTHERS = [order for order in itertools.permutations(range(4)) if order != (0, 1, 2, 3)]


def _in_order(convention, order):
    """A prediction: the four arguments taken for one another."""
    return lambda *row: convention(*(row[k] for k in order))


def _own(convention):
    """The mistakes that only one of the conventions invites."""
    formula = FORMULAS[convention]
    if convention is modified:
        return (
            Mistake(
                "d goes along the old z",
                "Trans_z(d) is the last step, so it goes along the new z: (0, -sin alpha, cos alpha).",
                placed(modified, lambda a, alpha, d, theta: [a, 0, d]),
            ),
            Mistake(
                "the minus of -d sin(alpha) is missing",
                "The new z is (0, -sin alpha, cos alpha): d goes along it.",
                with_other_sign(modified, 1, 3),
                placed(modified, lambda a, alpha, d, theta: [a, d * np.sin(alpha), d * np.cos(alpha)]),
            ),
            Mistake(
                "a is turned by theta",
                f"Trans_x(a) stands before Rot_z(theta): T = {formula}.",
                joined("XZad"),
                joined("XdZa"),
            ),
            Mistake(
                "Rot_z(theta) stands before Rot_x(alpha)",
                f"First about x, then about z: T = {formula}.",
                joined("ZXad"),
                joined("aZXd"),
                with_another_turn(modified, lambda alpha, theta: rot_z(theta) @ rot_x(alpha)),
            ),
        )
    return (
        Mistake(
            "a is not turned by theta",
            f"Trans_x(a) stands after Rot_z(theta), so it goes along the new x: (cos theta, sin theta, 0). "
            f"T = {formula}.",
            placed(standard, lambda a, alpha, d, theta: [a, 0, d]),
        ),
        Mistake(
            "a sine of the place has its sign turned",
            "a goes along the new x: (cos theta, sin theta, 0).",
            placed(standard, lambda a, alpha, d, theta: [a * np.cos(theta), -a * np.sin(theta), d]),
        ),
        Mistake("d is turned by alpha", f"Trans_z(d) stands before Rot_x(alpha): T = {formula}.", joined("ZaXd")),
        Mistake(
            "Rot_x(alpha) stands before Rot_z(theta)",
            f"First about z, then about x: T = {formula}.",
            joined("dXZa"),
            with_another_turn(standard, lambda alpha, theta: rot_x(alpha) @ rot_z(theta)),
        ),
    )


def mistakes(convention):
    """Return the mistakes in one of the conventions, the likely ones first."""
    formula = FORMULAS[convention]
    other, whose = (standard, "standard") if convention is modified else (modified, "modified")
    product = f"One step after the other is a matrix product, @: {formula}."
    order = "The order of the arguments is a, alpha, d, theta: a and alpha belong to x, d and theta to z."
    return (
        few_digits(convention),
        Mistake(f"the {whose} convention is taken", f"Asked for is {formula}.", other),
        *_own(convention),
        Mistake("alpha and theta are swapped", order, _in_order(convention, (0, 3, 2, 1))),
        Mistake("a and d are swapped", order, _in_order(convention, (2, 1, 0, 3))),
        Mistake(
            "the arguments are taken in another order", order, *(_in_order(convention, order) for order in _OTHERS)
        ),
        Mistake("T is transposed", "The origin stands in the last column.", lambda *row: convention(*row).T),
        Mistake("the rotation is transposed", _SIGNS, lambda *row: _turned_back(convention(*row))),
        Mistake(
            "the inverse is returned",
            "T holds the new frame as the one before sees it: its axes in columns, and its origin.",
            lambda *row: inverse(convention(*row)),
            lambda *row: inverse(other(*row)),
        ),
        Mistake(
            "the turn by theta goes the other way round",
            _SIGNS,
            lambda a, alpha, d, theta: convention(a, alpha, d, -theta),
        ),
        Mistake(
            "the turn by alpha goes the other way round",
            _SIGNS,
            lambda a, alpha, d, theta: convention(a, -alpha, d, theta),
        ),
        Mistake(
            "both turns go the other way round", _SIGNS, lambda a, alpha, d, theta: convention(a, -alpha, d, -theta)
        ),
        Mistake(
            "the angles are taken for degrees",
            _RADIANS,
            *(
                lambda a, alpha, d, theta, to=to: convention(a, to(alpha), d, to(theta))
                for to in (np.deg2rad, np.rad2deg)
            ),
            lambda a, alpha, d, theta: convention(a, np.deg2rad(alpha), d, theta),
            lambda a, alpha, d, theta: convention(a, alpha, d, np.deg2rad(theta)),
        ),
        Mistake("the matrices are added up", product, *_added(convention)),
        Mistake("matrices are multiplied entry by entry", product, *_entry_by_entry(convention)),
        Mistake("a is left out", f"T = {formula}.", lambda a, *rest: convention(0, *rest)),
        Mistake("d is left out", f"T = {formula}.", lambda a, alpha, d, theta: convention(a, alpha, 0, theta)),
        Mistake("alpha is left out", f"T = {formula}.", lambda a, alpha, d, theta: convention(a, 0, d, theta)),
        Mistake("theta is left out", f"T = {formula}.", lambda a, alpha, d, theta: convention(a, alpha, d, 0)),
        Mistake("the origin is left out", f"T = {formula}.", lambda a, alpha, d, theta: convention(0, alpha, 0, theta)),
        Mistake(
            "the turn is left out",
            f"T = {formula}.",
            lambda *row: along_x(row[0]) @ along_z(row[2]),
            lambda *row: _unturned(convention(*row)),
        ),
        Mistake("a has its sign turned", f"T = {formula}, with a as it is.", lambda a, *rest: convention(-a, *rest)),
        Mistake(
            "d has its sign turned",
            f"T = {formula}, with d as it is.",
            lambda a, alpha, d, theta: convention(a, alpha, -d, theta),
        ),
        Mistake(
            "alpha turns about y",
            "Rot_x(alpha) leaves the x axis where it is.",
            lambda a, alpha, d, theta: _about_y(convention, a, alpha, d, theta),
        ),
        Mistake(
            "sine and cosine are swapped",
            "At the angle 0 the cosine is 1: it stands on the diagonal.",
            with_sines_for_cosines(convention),
        ),
        Mistake(
            "the four steps are multiplied in another order",
            f"T = {formula}, in this order.",
            *_wrong(convention, map(joined, itertools.permutations("XaZd"))),
        ),
        Mistake(
            "one entry has its sign wrong",
            "Multiply the two halves out again, or let @ do it.",
            *_wrong(convention, (with_other_sign(convention, i, j) for i, j in itertools.product(range(3), range(4)))),
        ),
        Mistake(
            "the last row is not 0, 0, 0, 1",
            "Start from np.eye(4) and fill in the block and the column.",
            lambda *row: np.diag([1.0, 1, 1, 0]) @ convention(*row),
        ),
        Mistake(
            "digits after the point are cut off",
            "np.zeros((4, 4)) has room for digits, with dtype=int it has not.",
            lambda *row: np.trunc(convention(*row)),
        ),
    )


def _wrong(convention, predictions):
    """Those that are no right answer: some of the steps may change places, and some entries are 0."""
    row = (0.3, 0.5, 0.7, 0.9)
    return [answer for answer in predictions if not np.allclose(answer(*row), convention(*row))]


def _turned_back(T):
    T = T.copy()
    T[:3, :3] = T[:3, :3].T
    return T


def _unturned(T):
    T = T.copy()
    T[:3, :3] = np.eye(3)
    return T


def _about_y(convention, a, alpha, d, theta):
    along, turned = along_x(a), along_z(d) @ about_z(theta)
    tilt = about_x(0)
    tilt[:3, :3] = rot_y(alpha)
    return along @ tilt @ turned if convention is modified else turned @ along @ tilt


def _added(convention):
    order = "XaZd" if convention is modified else "ZdaX"
    return (
        joined(order, np.add),
        halves(convention, np.add),
        lambda *row: joined(order, np.add)(*row) - 3 * np.eye(4),
        lambda *row: halves(convention, np.add)(*row) - np.eye(4),
        lambda *row: halves(convention, np.add)(*row) / 2,
    )


def _entry_by_entry(convention):
    return joined("XaZd", np.multiply), halves(convention, np.multiply)
