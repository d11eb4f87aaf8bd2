"""rotate_point: a point of the plane, rotated about the origin."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.naming import difference
from course_lib.checks.special_cases import ON_BOTH_SIDES, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import away_from_zero, compared


def _matrix(a):
    return np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]])


def _right(p, a):
    return _matrix(a) @ p


def _cases(rng):
    named = [
        ([1.0, 0.0], np.pi / 2),
        ([0.0, 1.0], np.pi / 2),
        ([2.0, 1.0], np.pi),
        (-away_from_zero(rng, 2), 0.5),
    ]
    angles = np.round(rng.uniform([0.6, -1.3, 2.3, 6.8], [0.9, -1.1, 2.7, 7.2]), 2)
    drawn = [(away_from_zero(rng, 2), float(a)) for a in angles]
    drawn += [(np.array([3.0, -2.0]), 0.0), (np.zeros(2), float(angles[0]))]
    named += [([3, -2], 0.5), ([2, 1], 0.5)]  # whole numbers
    return [(np.array(p), a) for p, a in named] + drawn


EXERCISE = Exercise(
    name="rotate_point",
    points=1,
    arguments=("p", "a"),
    tolerance=EXACT,
    cases=_cases,
    small=("p", "a"),
    angles=("a",),
    sweeps=(Sweep("a tiny angle", lambda rng, gap: (away_from_zero(rng, 2), gap), ON_BOTH_SIDES),),
    returns=numbers(lambda p, a: (2,)),
    library=_right,
    properties=(
        Property(
            "the distance from the origin does not change",
            lambda image, p, a: abs(np.linalg.norm(image) - np.linalg.norm(p)) < EXACT,
            says=lambda image, p, a: (
                f"The right distance is {compared(np.linalg.norm(p), np.linalg.norm(image))}."
            ),
            mistake=Mistake(
                "the point comes nearer to the origin, or moves away",
                "Each new coordinate is made of both old ones: where do (1, 0) and (0, 1) go?",
            ),
        ),
        Property(
            "the point moves counter-clockwise by the angle a",
            lambda image, p, a: difference(image, _right(p, a)) <= EXACT,
            says=lambda image, p, a: f"a is {np.rad2deg(a):.4g} degrees.",
        ),
    ),
    hints=(
        "Where do (1, 0) and (0, 1) go? Draw them, rotated by a.",
        "Their images are the columns of the rotation matrix: (cos a, sin a) and (-sin a, cos a).",
        "x' = x cos a - y sin a, y' = x sin a + y cos a.",
    ),
)


@EXERCISE.mistake(
    "the new x is used to compute the new y",
    "Both new coordinates come from the old ones.",
)
def new_x_used(p, a):
    x = np.cos(a) * p[0] - np.sin(a) * p[1]
    return np.array([x, np.sin(a) * x + np.cos(a) * p[1]])


@EXERCISE.mistake(
    "the direction of p comes from arctan or arccos, which know half of the circle only",
    "Which function of x and y tells p from -p?",
    of_x=(True, False),
)
def half_of_the_circle(p, a, of_x):
    return (
        np.array([1, np.sign(p[1] or 1)]) * p @ _matrix(a).T
        if of_x
        else np.sign(p[0] or 1) * _right(p, a)
    )
