"""dh_modified: the pose of a frame in the previous frame by Craig's convention."""

import functools
import itertools

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.special_cases import SMALL, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import COLUMNS, LAST_ROW, near, part_is
from course_lib.lessons.panda_dh_ik.exercises.shared import (
    about_x,
    about_z,
    modified,
    standard,
)
from course_lib.rigid import transform

_STEPS = Mistake(
    "the steps are returned, not their product",
    "The answer is one pose. Which product joins the steps?",
)


def _cases(rng):
    quarter = np.pi / 2
    simple = [
        (0.1, 0, 0.3, 0),
        (0.1, quarter, 0.3, 0),
        (0.1, 0, 0.3, quarter),
        (0.1, 0.5, 0.3, 2.0),
        (2, 1, 3, -2),
    ]
    one_each = [(0, 0, 0, 0), (1, 0, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1), (0, 1, 0, 0)]
    # Rows as the Panda's, with joint angles of any arm.
    first, second = np.round(rng.uniform([0.3, -0.9], [0.6, -0.5]), 2)
    panda = [(0.0825, quarter, 0, first), (-0.0825, -quarter, 0.384, second)]
    sizes = rng.uniform([0.2, 0.3, 1.0, 0.4], [0.8, 1.2, 1.9, 1.3], (3, 4))
    drawn = [
        *np.round(sizes * [(1, 1, 1, 1), (1, -1, 1, 1), (-1, 1, -1, -1)], 2),
        np.round([*rng.uniform([-3.5, -2.4, 0.4], [-2.5, -2.1, 0.6]), rng.uniform(7.2, 7.7)], 2),
    ]
    return [tuple(float(number) for number in row) for row in (*simple, *one_each, *panda, *drawn)]


EXERCISE = Exercise(
    name="dh_modified",
    points=1,
    arguments=("a", "alpha", "d", "theta"),
    cases=_cases,
    returns=numbers(lambda *case: (4, 4)),
    properties=(
        LAST_ROW,
        Property(
            "if both angles are 0, the axes are parallel to the old ones and the origin is at (a, "
            "0, d)",
            lambda T, *row: near(T, modified(*row)),
            says=lambda T, *row: f"Yours is at {format_tuple(T[:3, 3])}.",
            where=lambda a, alpha, d, theta: alpha == theta == 0,
        ),
        part_is(
            "the x axis, the first column, is rotated by theta about z, then alpha about x",
            modified,
            COLUMNS[0],
        ),
        part_is(
            "the z axis, the third column, is rotated by alpha about x, not by theta",
            modified,
            COLUMNS[2],
        ),
        part_is(
            "the y axis, the second column, is the cross product of the z and the x axis",
            modified,
            COLUMNS[1],
        ),
        part_is(
            "the origin, the last column, is a along the old x, then d along the new z",
            modified,
            COLUMNS[3],
        ),
    ),
    hints=(
        "Make two poses: one rotates about x and moves along x, the other rotates about z and "
        "moves along z.",
        "rigid.transform(rotations.rot_x(alpha), [a, 0, 0]) is the first of them.",
        "In the modified convention the pose along x is the left factor: along_x @ along_z.",
    ),
    library=modified,
    sweeps=(
        Sweep("small angles", lambda rng, size: (0.3, size, 0.5, -2 * size), SMALL),
        Sweep("small lengths", lambda rng, size: (size, 0.7, -2 * size, 1.1), SMALL),
    ),
    angles=("alpha", "theta"),
    forbidden=("course_lib.arms.SerialArm", "course_lib.arms._dh_frames"),
)

EXERCISE.mistake(_STEPS, form=(4, 4, 4))
EXERCISE.mistake(_STEPS, form=(2, 4, 4))


def _product(order, a, alpha, d, theta):
    steps = {
        "X": about_x(alpha),
        "a": transform(np.eye(3), [a, 0, 0]),
        "Z": about_z(theta),
        "d": about_z(0.0, d),
    }
    return functools.reduce(np.matmul, [steps[name] for name in order])


def _orders():
    """Return the orders of Rot_x, Trans_x, Rot_z, Trans_z whose products differ, and from both
    conventions."""
    row, orders = (0.3, 0.5, 0.7, 0.9), []
    known = [modified(*row), standard(*row)]
    for order in itertools.permutations("XaZd"):
        if not any(np.allclose(_product(order, *row), T) for T in known):
            known.append(_product(order, *row))
            orders.append(order)
    return orders


@EXERCISE.mistake(
    "the pose, its rotation or its position is that of the standard convention",
    "Which pair of steps comes first in the modified convention, that of x or that of z?",
    columns=(slice(4), slice(3), slice(3, 4)),
)
def other_convention(*row, columns):
    T = modified(*row)
    T[:, columns] = standard(*row)[:, columns]
    return T


@EXERCISE.mistake(
    "the steps are multiplied in another order",
    "Each factor acts along the axes that the factors to its left have made. Which of a and d is "
    "measured along an old axis, and which along a new axis?",
    order=_orders(),
)
def other_order(a, alpha, d, theta, order):
    return _product(order, a, alpha, d, theta)


@EXERCISE.mistake(
    "the two poses are multiplied entry by entry",
    "A * B multiplies each entry of A by one entry of B. Which operator is the product of two "
    "matrices?",
)
def entry_by_entry(a, alpha, d, theta):
    return _product("Xa", a, alpha, d, theta) * _product("Zd", a, alpha, d, theta)


@EXERCISE.mistake(
    "the angles are taken for degrees, or converted to degrees",
    "In which unit are the angles given?",
    convert=(np.deg2rad, np.rad2deg),
)
def in_degrees(a, alpha, d, theta, convert):
    return modified(a, convert(alpha), d, convert(theta))


@EXERCISE.mistake(
    "small entries are set to 0, or rounded",
    "How far does an angle of 0.0005 rad move the end of an arm of 1 m?",
    recognises=True,
)
def small_entries_lost(T, *row):
    wrong = np.abs(T - modified(*row)) > EXACT
    return bool(wrong.any() and (np.abs(modified(*row))[wrong] < 0.02).all() and not T[wrong].any())
