"""rotate_point: a point of the plane, rotated about the origin."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.exercise import Property
from course_lib.checks.kinds import ANGLE, vector
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import compared


def _matrix(a):
    return np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]])


def _right(p, a):
    return _matrix(a) @ p


def _new_x_used(p, a):
    x = np.cos(a) * p[0] - np.sin(a) * p[1]
    return np.array([x, np.sin(a) * x + np.cos(a) * p[1]])


def _direction_by_arctan(p, a):
    return np.sign(p[0] or 1) * _right(p, a)


def _straight_up_if_x_is_0(p, a):
    return _right(p, a) * (-1 if p[0] == 0 and p[1] < 0 else 1)


def _direction_by_arccos(p, a):
    return np.array([1, np.sign(p[1] or 1)]) * p @ _matrix(a).T


def _found(image, p, a):
    point = f"a is {np.rad2deg(a):.4g} degrees. The right point is "
    return point + compared(_right(p, a), image) + "."


EXERCISE = declared(
    "rotate_point",
    points=1,
    arguments={"p": vector(2, small=True), "a": ANGLE},
    cases=(
        (np.array([1.0, 0.0]), np.pi / 2),
        (np.array([0.0, 1.0]), np.pi / 2),
        (np.array([2.0, 1.0]), np.pi),
        (np.array([-2.0, 0.0]), 0.5),
        (np.array([0.0, -2.0]), 0.5),
        (np.array([3, -2]), 0.5),
        (np.array([2, 1]), 0.5),
    ),
    tolerance=EXACT,
    library=_right,
    says="the point moves counter-clockwise by the angle a",
    found=_found,
    properties=(
        Property(
            "the distance from the origin does not change",
            lambda image, p, a: abs(np.linalg.norm(image) - np.linalg.norm(p)) < EXACT,
            says=lambda image, p, a: (
                "The right distance is " + compared(np.linalg.norm(p), np.linalg.norm(image)) + "."
            ),
            otherwise=Question(
                "the point comes nearer to the origin, or moves away",
                "Each new coordinate is made of both old ones: where do (1, 0) and (0, 1) go in "
                "your code?",
                of_the_formula=True,
            ),
        ),
    ),
    hints=(
        "Where do (1, 0) and (0, 1) go? Draw them, rotated by a.",
        "Their images are the columns of the rotation matrix: (cos a, sin a) and (-sin a, cos a).",
        "x' = x cos a - y sin a, y' = x sin a + y cos a.",
    ),
    mistakes=(
        Mistake(
            "the new x is used to compute the new y",
            "Both new coordinates come from the old ones.",
            _new_x_used,
        ),
        Mistake(
            "the direction of p comes from arctan or arccos, which know half of the circle only",
            "Which function of x and y tells p from -p?",
            _direction_by_arccos,
            _direction_by_arctan,
            _straight_up_if_x_is_0,
        ),
    ),
)
