"""dh_modified: the pose of a frame in the one before by Craig's convention."""

import functools
import itertools

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.vocabulary import COLUMNS, LAST_ROW, near, part_is
from course_lib.lessons.panda_dh_ik.exercises.shared import about_x, about_z, modified, standard
from course_lib.rigid import transform

_STEPS = Mistake(
    "the steps are returned, not their product",
    "The answer is one pose: which product joins the steps?",
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
    "this is the pose by the other convention, or its rotation or position is",
    "Which pair of steps comes first here, that of x or that of z?",
    columns=(slice(4), slice(3), slice(3, 4)),
)
def other_convention(*row, columns):
    T = modified(*row)
    T[:, columns] = standard(*row)[:, columns]
    return T


@EXERCISE.mistake(
    "the steps are multiplied in another order",
    "Each factor acts along the axes that the factors left of it made: which of a and d is along "
    "an old axis, and which along a new one?",
    order=_orders(),
)
def other_order(a, alpha, d, theta, order):
    return _product(order, a, alpha, d, theta)


@EXERCISE.mistake(
    "the angles are taken for degrees, or converted to degrees",
    "In which unit do they come?",
    convert=(np.deg2rad, np.rad2deg),
)
def in_degrees(a, alpha, d, theta, convert):
    return modified(a, convert(alpha), d, convert(theta))
