"""The known mistakes in dh_modified and dh_standard."""

import itertools

import numpy as np

from course_lib.checks.exercise import Mistake
from course_lib.checks.exercises.panda_dh_ik.shared import (
    about_x,
    about_z,
    along_x,
    along_z,
    joined,
    modified,
    standard,
    truncated,
)
from course_lib.checks.vocabulary import argument_degrees, few_digits, inverted, transposed
from course_lib.rigid import transform
from course_lib.rotations import rot_x, rot_y, rot_z

_FORMULAS = {
    modified: "Rot_x(alpha) Trans_x(a) Rot_z(theta) Trans_z(d)",
    standard: "Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha)",
}
_SIGNS = "In Rot_x and Rot_z the minus stands above the diagonal."
_ROW = (0.3, 0.5, 0.7, 0.9)


def _in_order(convention, order):
    return lambda *row: convention(*(row[k] for k in order))


def _at(convention, position):
    """Return an answer: the right rotation, and the origin at position(a, alpha, d, theta)."""
    return lambda *row: transform(convention(*row)[:3, :3], position(*row))


def _rotated(convention, rotation):
    return lambda a, alpha, d, theta: transform(rotation(alpha, theta), convention(a, alpha, d, theta)[:3, 3])


def _other_sign(convention, i, j):
    def answer(*row):
        T = convention(*row)
        T[i, j] *= -1
        return T

    return answer


def _others(known, answers):
    """Return the answers that differ from those known: some of the steps commute, and some entries are 0."""
    known = [answer(*_ROW) for answer in known]
    return [answer for answer in answers if not any(np.allclose(answer(*_ROW), each) for each in known)]


def _halves(convention, a, alpha, d, theta):
    pair = about_x(alpha, a), about_z(theta, d)
    return pair if convention is modified else pair[::-1]


def _own(convention, formula):
    """Return the mistakes that only one of the conventions invites."""
    if convention is modified:
        return (
            Mistake(
                "d goes along the old z",
                "Trans_z(d) is the last step, so it goes along the new z.",
                _at(modified, lambda a, alpha, d, theta: [a, 0, d]),
            ),
            Mistake(
                "the minus of -d sin(alpha) is missing",
                "A positive alpha tilts the new z towards the old -y.",
                _other_sign(modified, 1, 3),
            ),
            Mistake("a is rotated by theta", f"Trans_x(a) is left of Rot_z(theta): {formula}.", joined("XZad")),
            Mistake(
                "Rot_z(theta) is left of Rot_x(alpha)",
                f"First about x, then about z: {formula}.",
                joined("ZXad"),
                joined("aZXd"),
                _rotated(modified, lambda alpha, theta: rot_z(theta) @ rot_x(alpha)),
            ),
        )
    return (
        Mistake(
            "a is not rotated by theta",
            f"Trans_x(a) is right of Rot_z(theta), so it goes along the new x: {formula}.",
            _at(standard, lambda a, alpha, d, theta: [a, 0, d]),
        ),
        Mistake(
            "the components of a along the new x are mixed up",
            "The new x is (cos theta, sin theta, 0).",
            _at(standard, lambda a, alpha, d, theta: [a * np.cos(theta), -a * np.sin(theta), d]),
            _at(standard, lambda a, alpha, d, theta: [a * np.sin(theta), a * np.cos(theta), d]),
        ),
        Mistake("d is rotated by alpha", f"Trans_z(d) is left of Rot_x(alpha): {formula}.", joined("ZaXd")),
        Mistake(
            "Rot_x(alpha) is left of Rot_z(theta)",
            f"First about z, then about x: {formula}.",
            joined("dXZa"),
            _rotated(standard, lambda alpha, theta: rot_x(alpha) @ rot_z(theta)),
        ),
    )


def mistakes(convention):
    """Return the mistakes in one of the conventions, the likely ones first."""
    formula = _FORMULAS[convention]
    other, whose = (standard, "standard") if convention is modified else (modified, "modified")
    order = "The order of the arguments is a, alpha, d, theta: a and alpha belong to x, d and theta to z."
    order_x = "XaZd" if convention is modified else "ZdaX"
    rest = [each for each in itertools.permutations(range(4)) if each not in ((0, 1, 2, 3), (0, 3, 2, 1), (2, 1, 0, 3))]

    def back(T):
        return transform(T[:3, :3].T, T[:3, 3])

    def about_y(a, alpha, d, theta):
        tilt, along = transform(rot_y(alpha), [0, 0, 0]), about_z(theta, d)
        return along_x(a) @ tilt @ along if convention is modified else along @ along_x(a) @ tilt

    own = _own(convention, formula)
    named = [other, *(answer for mistake in own for answer in mistake.answers)]
    named += [lambda a, *rest: convention(-a, *rest), lambda a, al, d, th: convention(a, al, -d, th)]
    return (
        few_digits(convention),
        Mistake(f"the {whose} convention is taken", f"The task asks for {formula}.", other),
        *own,
        Mistake("alpha and theta are swapped", order, _in_order(convention, (0, 3, 2, 1))),
        Mistake("a and d are swapped", order, _in_order(convention, (2, 1, 0, 3))),
        Mistake("the arguments are taken in another order", order, *(_in_order(convention, each) for each in rest)),
        transposed(convention, "T is transposed", "The origin is the last column."),
        Mistake("the rotation is transposed", _SIGNS, lambda *row: back(convention(*row))),
        inverted(convention),
        inverted(other),
        Mistake("theta has the wrong sign", _SIGNS, lambda a, alpha, d, theta: convention(a, alpha, d, -theta)),
        Mistake("alpha has the wrong sign", _SIGNS, lambda a, alpha, d, theta: convention(a, -alpha, d, theta)),
        Mistake("both angles have the wrong sign", _SIGNS, lambda a, al, d, th: convention(a, -al, d, -th)),
        argument_degrees(
            lambda a, al, d, th: convention(a, np.deg2rad(al), d, th), 3, "the angles are taken for degrees"
        ),
        argument_degrees(convention, 1, "one of the angles is taken for degrees"),
        argument_degrees(convention, 3, "one of the angles is taken for degrees"),
        truncated(convention),
        Mistake(
            "the matrices are added",
            "One step after the other is a matrix product, @.",
            joined(order_x, np.add),
            lambda *row: sum(_halves(convention, *row)),
        ),
        Mistake(
            "matrices are multiplied entry by entry",
            "In numpy the product of matrices is @.",
            joined(order_x, np.multiply),
            lambda *row: np.multiply(*_halves(convention, *row)),
        ),
        *(
            Mistake(
                f"{name} is left out",
                f"T = {formula}.",
                lambda *row, k=k: convention(*np.where(np.arange(4) == k, 0, row)),
            )
            for k, name in enumerate(("a", "alpha", "d", "theta"))
        ),
        Mistake("the origin is left out", f"T = {formula}.", lambda a, al, d, th: convention(0, al, 0, th)),
        Mistake("the rotation is left out", f"T = {formula}.", lambda a, al, d, th: along_x(a) @ along_z(d)),
        Mistake("a has the wrong sign", f"T = {formula}, with a as it is.", named[-2]),
        Mistake(
            "d has the wrong sign", f"T = {formula}, with d as it is.", lambda a, al, d, th: convention(a, al, -d, th)
        ),
        Mistake("alpha rotates about y", "Rot_x(alpha) leaves the x axis unchanged.", about_y),
        Mistake(
            "the four steps are multiplied in another order",
            f"T = {formula}, in this order.",
            *_others([convention, *named], map(joined, itertools.permutations("XaZd"))),
        ),
        Mistake(
            "one entry has the wrong sign",
            "Multiply the two halves out again, or let @ do it.",
            *_others(
                [convention, *named], (_other_sign(convention, i, j) for i, j in itertools.product(range(3), range(4)))
            ),
        ),
    )
