"""screw_axes: the screw axes of an arm's joints, from a direction and a point of each."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.poe_kuka_iiwa.shared import KUKA_OMEGA, KUKA_POINTS, axes, drawn_axes, first_off
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.vocabulary import FINE, X, Y, Z, near

_APART = Mistake("omega and v do not stand side by side", "Each row is one axis, (omega, v): six numbers.")
_HALF = Mistake("only one half of each axis is returned", "A screw axis has six numbers: omega, then v.")
_OMEGA, _V = (slice(None), slice(0, 3)), (slice(None), slice(3, 6))


def _known_form(array, omega, points):
    n = len(omega)
    if array.shape in ((2, n, 3), (n, 2, 3), (2 * n, 3)):
        return _APART
    return _HALF if array.shape == (n, 3) else None


def _cases(rng):
    named = [
        (np.array([Y, Z]), np.array([[0, 0, 0.36], [1.0, 0, 0]])),
        (np.array([Z, 0.6 * X + 0.8 * Y]), np.array([[0.5, 0, 0], [1.0, -2.0, 0.5]])),
        (KUKA_OMEGA, KUKA_POINTS),
        (np.array([Z, Z, Z]), np.array([X + Y, X + Y + 2 * Z, X + Y - 3 * Z])),
    ]
    whole = [
        (np.array([[0, 0, 1], [0, -1, 0]]), np.array([[0.5, 0.25, 0], [0.75, 0, 1.5]])),
        (np.array([[0.6, 0.8, 0], [0, 0.6, -0.8]]), np.array([[1, 2, 3], [2, 1, 1]])),
    ]
    through_origin = [(np.array([Y, Z]), np.zeros((2, 3)))]
    return [*named, *(drawn_axes(rng, n) for n in (1, 3, 6, 7)), *whole, *through_origin, drawn_axes(rng, 2)]


def _moving(S, omega, points):
    """Return the velocity omega x p + v of each axis's point."""
    return np.cross(S[:, :3], points) + S[:, 3:]


def _moving_point(S, omega, points):
    velocity = _moving(S, omega, points)
    i = int(np.argmax(np.abs(velocity).max(1) > FINE))
    return f"For row {i}, with p = {format_tuple(points[i])}, it is {format_tuple(velocity[i])}."


EXERCISE = Exercise(
    name="screw_axes",
    points=1,
    arguments=("omega", "points"),
    cases=_cases,
    returns=numbers(lambda omega, points: (len(omega), 6), _known_form),
    library=axes,
    properties=(
        Property(
            "the first three numbers of each row are the direction omega of its axis",
            lambda S, omega, points: near(S[:, :3], omega),
            says=lambda S, omega, points: first_off(S[:, :3].T, omega.T, "omega of row"),
        ),
        Property(
            "a point on the axis does not move: omega x p + v = 0 for each joint",
            lambda S, *case: near(_moving(S, *case), 0),
            says=_moving_point,
        ),
    ),
    hints=(
        "A point p on the axis does not move when the joint rotates. Its velocity is omega x p + v. So what is v?",
        "np.cross works on all rows at once, and np.hstack puts two arrays side by side.",
        "v is p x omega for each joint; np.hstack takes the list of omega and v.",
    ),
    forbidden=("course_lib.arms.SerialArm",),
)


@EXERCISE.mistake
def v_first(omega, points):
    """v stands before omega. Which half of a twist comes first in this course?"""
    return np.roll(axes(omega, points), 3, axis=1)


@EXERCISE.mistake(part=_V)
def sign_of_v(omega, points):
    """v has its sign changed: it is omega x p. What must omega x p + v be for a point p on the axis?"""
    return np.cross(omega, points)
