"""screw_axes: the screw axes of an arm's joints, from a direction and a point of each."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.poe_kuka_iiwa.shared import KUKA_OMEGA, KUKA_POINTS, axes, drawn_axes, in_part
from course_lib.checks.vocabulary import FINE, X, Y, Z, few_digits, halves_swapped, near, whole_numbers

_APART = Mistake("omega and v do not stand side by side", "Each row is one axis, (omega, v): six numbers.")
_NO_ROWS = Mistake(
    "the axes of the joints do not stand in rows of their own",
    "One row (omega, v) for each joint, also if there is only one: the shape is (n, 6).",
)
_TRANSPOSED = Mistake("rows and columns are swapped", "One axis a row: the shape is (n, 6).")
_HALF = Mistake("only one half of each axis is returned", "A screw axis has six numbers: omega, then v.")


def _known_form(array, omega, points):
    n, shape = len(omega), array.shape
    if shape == (6, n):
        return _TRANSPOSED
    if shape == (n, 3):
        return _HALF
    if shape in ((2, n, 3), (n, 2, 3), (2 * n, 3)):
        return _APART
    return _NO_ROWS if shape in ((6 * n,), (6,)) else None


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


def _at_rest(S, points):
    """The velocity omega x p + v of each axis's point."""
    return np.cross(S[:, :3], points) + S[:, 3:]


def _moving_point(S, omega, points):
    velocity = _at_rest(S, points)
    i = int(np.argmax(np.abs(velocity).max(1) > FINE))
    return f"For row {i}, with p = {format_tuple(points[i])}, it is {format_tuple(velocity[i])}."


def _other_direction(S, omega, points):
    i = int(np.argmax(np.abs(S[:, :3] - omega).max(1) > FINE))
    return f"In row {i} it is {format_tuple(S[i, :3])}; omega[{i}] is {format_tuple(omega[i])}."


def _scaled(omega, points):
    v = np.cross(points, omega)
    size = np.linalg.norm(v, axis=1, keepdims=True)
    return v / np.where(size > 0, size, 1)


_in_v = in_part(axes, (slice(None), slice(3, 6)))
_in_omega = in_part(axes, (slice(None), slice(0, 3)))

EXERCISE = Exercise(
    name="screw_axes",
    points=1,
    arguments=("omega", "points"),
    cases=_cases,
    returns=numbers(lambda omega, points: (len(omega), 6), _known_form),
    properties=(
        Property(
            "the first three numbers of each row are the direction omega of its axis",
            lambda S, omega, points: near(S[:, :3], omega),
            says=_other_direction,
        ),
        Property(
            "a point on the axis does not move: omega x p + v = 0 for each joint",
            lambda S, omega, points: near(_at_rest(S, points), 0),
            says=_moving_point,
        ),
    ),
    mistakes=(
        few_digits(axes),
        whole_numbers(axes),
        halves_swapped(axes, "v stands before omega", "The order in this course is (omega, v).", axis=1),
        _in_v(
            "v has its sign changed: it is omega x p",
            "omega x p + v must be 0 for a point p on the axis.",
            lambda omega, points: np.cross(omega, points),
        ),
        _in_v(
            "the point is taken for v",
            "v is a velocity: that of a point at the origin that moves along when the joint rotates at 1 rad/s.",
            lambda omega, points: points,
            lambda omega, points: -points,
        ),
        _in_v(
            "omega * p, entry by entry, stands for the cross product",
            "In numpy * works entry by entry.",
            lambda omega, points: points * omega,
            lambda omega, points: -points * omega,
        ),
        _in_v(
            "v lies along omega: a dot product stands for the cross product",
            "The velocity of a rotating point is perpendicular to the axis: np.cross(points, omega).",
            lambda omega, points: (omega * points).sum(1, keepdims=True) * omega,
            lambda omega, points: -(omega * points).sum(1, keepdims=True) * omega,
        ),
        _in_v("v is 0 for every axis", "Only an axis through the origin has v = 0.", lambda omega, points: 0 * points),
        _in_v(
            "v is made with the direction of another joint, or with z for all",
            "Each joint has its own direction: row i needs omega[i].",
            lambda omega, points: np.cross(points, Z),
            lambda omega, points: np.cross(points, omega[0]),
            lambda omega, points: np.cross(points, omega[-1]),
        ),
        Mistake(
            "every row has the direction of one joint",
            "Each joint has its own direction: row i needs omega[i].",
            *(lambda omega, points, i=i: axes(0 * omega + omega[i], points) for i in (0, -1)),
        ),
        Mistake(
            "every row is the same joint's",
            "Fill row i in the loop, with omega[i] and points[i].",
            *(lambda omega, points, i=i: axes(omega, points)[[i] * len(omega)] for i in (0, -1)),
        ),
        _in_v(
            "v is made with the point of another joint, or points are added up or subtracted",
            "Each axis has its own point, given in the base frame: row i needs points[i] as it is.",
            lambda omega, points: np.cross(points[0], omega),
            lambda omega, points: np.cross(points[-1], omega),
            lambda omega, points: np.cross(np.diff(points, axis=0, prepend=0), omega),
            lambda omega, points: np.cross(np.cumsum(points, 0), omega),
        ),
        _in_v(
            "v is scaled to length one",
            "Only omega has length one. The length of v is the distance of the axis from the origin.",
            _scaled,
        ),
        _in_v(
            "the cross product is taken twice",
            "One cross product gives the velocity.",
            lambda omega, points: np.cross(omega, np.cross(points, omega)),
            lambda omega, points: np.cross(np.cross(points, omega), omega),
        ),
        _in_omega(
            "the point stands where omega belongs",
            "A row is (omega, v). The point only serves to find v.",
            lambda omega, points: points,
        ),
        _in_omega(
            "omega has its sign changed",
            "The first three numbers are omega as it is given.",
            lambda omega, points: -omega,
        ),
    ),
    hints=(
        "A point p on the axis does not move when the joint rotates. Its velocity is omega x p + v. So what is v?",
        "np.cross works on all rows at once, and np.hstack puts two arrays side by side.",
        "v is p x omega for each joint; np.hstack takes the list of omega and v.",
    ),
    library=axes,
    forbidden=("course_lib.arms.SerialArm",),
)
