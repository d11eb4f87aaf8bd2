"""twist_in_frames: one motion of the hand, as three frames see it."""

import itertools

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.poe_kuka_iiwa.chains import (
    X,
    Y,
    Z,
    at,
    away_from_zero,
    few_digits,
    turned_hand,
    whole_numbers,
)
from course_lib.checks.poe_kuka_iiwa.matrices import near
from course_lib.checks.poe_kuka_iiwa.wrong_views import MISTAKES
from course_lib.rigid import adjoint, inverse, transform
from course_lib.rotations import exp_so3

_read = numbers(
    lambda V_s, T: (3, 6),
    {
        (6, 3): Mistake("rows and columns are swapped", "One frame a row: the shape is (3, 6)."),
        (18,): Mistake(
            "the three twists stand one after the other", "One frame a row: np.array([first, second, third])."
        ),
        (6,): Mistake("only one twist is returned", "Three frames, three rows: np.array([first, second, third])."),
        (2, 6): Mistake(
            "one of the three frames is missing", "The space frame, the hand's, and the third: three rows."
        ),
        (3, 4, 4): Mistake("the twists are given as matrices", "Each row is (omega, v), six numbers."),
    },
)


def _twist(omega, v):
    return np.concatenate([omega, v])


def _cases(rng):
    hand = transform(exp_so3(np.pi / 2 * Z), [2.0, 0, 0])
    named = [
        (_twist(0 * X, X), at(1, 0, 0)),
        (_twist(Z, 0 * X), at(1, 0, 0)),
        (_twist(0 * X, X), hand),
        (_twist(Z, 0 * X), hand),
        (_twist(Z, Y), transform(exp_so3(np.pi / 2 * X), [1.0, 2, 0])),
        (np.zeros(6), turned_hand(rng)),
        (_twist(Z, X), np.eye(4)),
        (_twist(Z, np.cross(X, Z)), at(1, 0, 0)),
    ]
    drawn = [(away_from_zero(rng, 6, 0.2, 2.0), turned_hand(rng)) for _ in range(5)]
    far = turned_hand(rng)
    far[:3, 3] *= 100
    whole = [
        (np.array([1, 2, -1, 0, 3, 1]), turned_hand(rng)),
        (away_from_zero(rng, 6, 0.2, 2.0), np.array([[0, -1, 0, 2], [1, 0, 0, 1], [0, 0, 1, 3], [0, 0, 0, 1]])),
    ]
    return [*named, *drawn, (away_from_zero(rng, 6, 2.0, 9.0), far), *whole]


def three_views(V_s, T):
    """The right answer."""
    return np.array([V_s, _of_the_hand(V_s, T), _of_the_third(V_s, T)], float)


def _of_the_hand(V_s, T):
    return adjoint(inverse(T)) @ V_s


def _of_the_third(V_s, T):
    return _twist(V_s[:3], V_s[3:] + np.cross(V_s[:3], T[:3, 3]))


def _is(rows, k, half, right):
    return f"That is {format_tuple(right[k, half])}; yours is {format_tuple(rows[k, half])}."


_OMEGA, _V = slice(3), slice(3, 6)


def _property(text, k, half):
    return Property(
        text,
        lambda rows, V_s, T: near(rows[k, half], three_views(V_s, T)[k, half]),
        seen=lambda rows, V_s, T: _is(rows, k, half, three_views(V_s, T)),
    )


TWIST_IN_FRAMES = Exercise(
    name="twist_in_frames",
    points=2,
    arguments=("V_s", "T"),
    cases=_cases,
    returns=_read,
    properties=(
        Property(
            "row 0 is the twist as the space frame sees it: V_s itself",
            lambda rows, V_s, T: near(rows[0], V_s),
            seen=lambda rows, V_s, T: f"Yours is {format_tuple(rows[0])}.",
        ),
        _property("row 2, omega: the third frame is turned as the space frame is, so omega is the same", 2, _OMEGA),
        _property("row 2, v: the velocity of the hand's origin p, which is p' = v + omega x p", 2, _V),
        _property("row 1, omega: seen along the axes of the hand, R^T omega", 1, _OMEGA),
        _property(
            "row 1, v: the velocity of the hand's origin, seen along the axes of the hand: R^T (v + omega x p)", 1, _V
        ),
    ),
    mistakes=(
        few_digits(three_views),
        *whole_numbers(three_views)[:2],
        Mistake(
            "the rows are in another order",
            "Row 0 is the space frame, row 1 the hand's, row 2 the third.",
            *(
                lambda V_s, T, order=order: three_views(V_s, T)[list(order)]
                for order in itertools.permutations(range(3))
                if order != (0, 1, 2)
            ),
        ),
        Mistake(
            "v stands before omega",
            "Twists are (omega, v) in this course: V_s[:3] is omega.",
            lambda V_s, T: np.roll(three_views(V_s, T), 3, axis=1),
            lambda V_s, T: np.roll(three_views(np.roll(V_s, 3), T), 3, axis=1),
        ),
        Mistake(
            "the three rows are all V_s",
            "The space frame sees V_s; the other two see other numbers.",
            lambda V_s, T: np.array([V_s] * 3),
        ),
        *MISTAKES,
    ),
    hints=(
        "Row 0 is V_s. Row 1 is Ad(T^-1) V_s: adjoint(inverse(T)) @ V_s.",
        "The third frame is turned as the space frame, so omega stays. Its origin is the hand's, p = T[:3, 3].",
        "Its v is the velocity of the point p of the moving hand: v + omega x p, with np.cross(omega, p).",
    ),
    forbidden=("course_lib.arms.SerialArm",),
)
