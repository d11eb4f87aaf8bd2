"""twist_in_frames: one motion of the end-effector, as three frames see it."""

import itertools

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.poe_kuka_iiwa.shared import at
from course_lib.checks.exercises.poe_kuka_iiwa.twist_in_frames_mistakes import HYBRID, ROWS, three_twists
from course_lib.checks.vocabulary import X, Y, Z, any_pose, away_from_zero, few_digits, near, whole_numbers
from course_lib.rigid import transform
from course_lib.rotations import exp_so3

_read = numbers(
    lambda V_s, T: (3, 6),
    {
        (6, 3): Mistake("rows and columns are swapped", "One frame a row: the shape is (3, 6)."),
        (18,): Mistake("the three twists stand one after the other", "Three frames, three rows: the shape is (3, 6)."),
        (2, 6): Mistake("one of the three frames is missing", "Space, body and hybrid: three rows."),
        (3, 4, 4): Mistake("the twists are given as matrices", "Each row is (omega, v), six numbers."),
    },
)


def _twist(omega, v):
    return np.concatenate([omega, v])


def _cases(rng):
    tool = transform(exp_so3(np.pi / 2 * Z), [2.0, 0, 0])
    named = [
        (_twist(Z, Y), transform(exp_so3(np.pi / 2 * X), [1.0, 2, 0])),
        (_twist(Z, 0 * X), tool),
        (_twist(0 * X, X), tool),
    ]
    drawn = [(away_from_zero(rng, 6, 0.2, 2.0), any_pose(rng)) for _ in range(4)]
    far = any_pose(rng)
    far[:3, 3] *= 100
    whole = [
        (np.array([1, 2, -1, 0, 3, 1]), any_pose(rng)),
        (away_from_zero(rng, 6, 0.2, 2.0), np.array([[0, -1, 0, 2], [1, 0, 0, 1], [0, 0, 1, 3], [0, 0, 0, 1]])),
    ]
    plain = [(_twist(Z, 0 * X), at(1, 0, 0)), (_twist(Z, X), np.eye(4)), (np.zeros(6), any_pose(rng))]
    return [*named, *drawn, (away_from_zero(rng, 6, 2.0, 9.0), far), *whole, *plain]


_OMEGA, _V = slice(3), slice(3, 6)


def _property(text, k, half):
    def seen(rows, V_s, T):
        right = three_twists(V_s, T)[k, half]
        return f"That is {format_tuple(right)}; yours is {format_tuple(rows[k, half])}."

    return Property(text, lambda rows, V_s, T: near(rows[k, half], three_twists(V_s, T)[k, half]), says=seen)


def _in_another_order(order):
    return lambda V_s, T: three_twists(V_s, T)[list(order)]


EXERCISE = Exercise(
    name="twist_in_frames",
    points=2,
    arguments=("V_s", "T"),
    cases=_cases,
    returns=_read,
    properties=(
        Property(
            "row 0 is the twist as the space frame sees it: V_s itself",
            lambda rows, V_s, T: near(rows[0], V_s),
            says=lambda rows, V_s, T: f"Yours is {format_tuple(rows[0])}.",
        ),
        _property("row 2, omega: the axes are the base's, so omega is that of V_s", HYBRID, _OMEGA),
        _property("row 2, v: the velocity of the end-effector's origin p", HYBRID, _V),
        _property("row 1, omega: seen along the end-effector's axes", 1, _OMEGA),
        _property("row 1, v: the velocity of the end-effector's origin, seen along the end-effector's axes", 1, _V),
    ),
    mistakes=(
        few_digits(three_twists),
        whole_numbers(three_twists),
        Mistake(
            "the rows are in another order",
            "Row 0 is the space twist, row 1 the body twist, row 2 the hybrid one.",
            *(_in_another_order(order) for order in itertools.permutations(range(3)) if order != (0, 1, 2)),
        ),
        Mistake(
            "v stands before omega",
            "Twists are (omega, v) in this course: omega is the first half.",
            lambda V_s, T: np.roll(three_twists(V_s, T), 3, axis=1),
            lambda V_s, T: np.roll(three_twists(np.roll(V_s, 3), T), 3, axis=1),
        ),
        Mistake(
            "the three rows are all V_s",
            "The space frame sees V_s; the other two see other numbers.",
            lambda V_s, T: np.array([V_s] * 3),
        ),
        *ROWS,
    ),
    hints=(
        "Row 0 is V_s. For row 1: which adjoint takes what the base sees to what the end-effector sees?",
        "The hybrid frame has the base's axes, so omega stays. Its origin is the end-effector's, p = T[:3, 3].",
        "Its v is the velocity of the point p of the moving body: v of V_s, plus omega x p.",
    ),
    library=three_twists,
    forbidden=("course_lib.arms.SerialArm",),
)
