"""rate_matrix: from the rates of three angles to the angular velocity."""

import itertools

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import ORDINALS
from course_lib.checks.naming import difference
from course_lib.checks.tolerances import SOLVED
from course_lib.checks.vocabulary import X, Y, first_off
from course_lib.lessons.subproblems_damped_ik.exercises.subproblem1 import some_angle
from course_lib.rotations import rot_x, rot_y


def _rotation(b):
    return rot_y(b[0]) @ rot_x(b[1]) @ rot_y(b[2])


def rates(b):
    """The rate matrix: its columns are the axes of the three rotations, as they are now."""
    return np.column_stack([Y, rot_y(b[0]) @ X, rot_y(b[0]) @ rot_x(b[1]) @ Y])


def quadrants(rng):
    """Angles in each of the quadrants, b2 of either sign."""
    found = []
    for far1, far2 in itertools.product((0, 1), repeat=2):
        for sign in (-1, 1):
            near = np.array(
                [some_angle(rng, s) for s in (rng.choice([-1, 1]), sign, rng.choice([-1, 1]))]
            )
            far = np.array([far1, far2, rng.choice([0, 1])])
            found.append(np.where(far, np.copysign(np.pi, near) - near, near))
    return found


def _cases(rng):
    quarter = np.pi / 2
    named = [
        [0, quarter, 0],
        [0, 0, 0],
        [quarter, quarter, 0],
        [0, quarter, quarter],
        [0, 0.5, 0],
        [0.5, quarter, 0],
    ]
    ends = [[0.7, 0.0, -0.4], [-0.9, np.pi, 0.3], [7.0, -8.0, 20.0]]
    return [(np.array(b, float),) for b in named + quadrants(rng) + ends] + [(np.array([1, 2, 3]),)]


def _no_axis(A, b):
    j = int(np.argmax(np.abs(A - rates(b)).max(0) > SOLVED))
    return Mistake(
        f"the {ORDINALS[j]} column is not the axis about which b{j + 1} rotates",
        "About which axis does this factor rotate, and which rotations, to its left, carry that "
        "axis along?",
    )


EXERCISE = Exercise(
    name="rate_matrix",
    points=2,
    arguments=("b",),
    tolerance=SOLVED,
    cases=_cases,
    small=("b",),
    angles=("b",),
    returns=numbers(lambda b: (3, 3)),
    library=rates,
    properties=(
        Property(
            "omega = A b', where [omega] = R' R^T with R = Ry(b1) Rx(b2) Ry(b3)",
            lambda A, b: difference(A, rates(b)) < SOLVED,
            lambda A, b: first_off(A, rates(b)),
            mistake=_no_axis,
        ),
    ),
    hints=(
        "Set b' = (1, 0, 0), then (0, 1, 0), then (0, 0, 1): each column is the axis about which "
        "one angle rotates.",
        "b1 rotates everything to its right about the fixed e_y. The axis of b2 is e_x, rotated by "
        "Ry(b1).",
        "The axis of b3 is e_y, rotated by Rx(b2) and then Ry(b1): Ry(b1) (0, cos b2, sin b2).",
    ),
)


@EXERCISE.mistake(
    "the angular velocity is that seen from the rotating end-effector",
    "Which of R' R^T and R^T R' belongs to the fixed frame?",
)
def seen_from_the_end_effector(b):
    return _rotation(b).T @ rates(b)


@EXERCISE.mistake(
    "an axis is not carried along by the rotations to its left, or by them in the wrong order",
    "Which rotations stand to the left of the one about b2, and of the one about b3? Which of them "
    "acts on the axis first?",
    axes=(
        lambda b: (X, rot_x(b[1]) @ Y),
        lambda b: (X, rot_y(b[0]) @ rot_x(b[1]) @ Y),
        lambda b: (rot_y(b[0]) @ X, Y),
        lambda b: (rot_y(b[0]) @ X, rot_x(b[1]) @ Y),
    ),
)
def axis_not_carried_along(b, axes):
    return np.column_stack([Y, *axes(b)])
