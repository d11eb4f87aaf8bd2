"""screw_axes: the screw axes of an arm's joints, from a direction and a point of each."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.poe_kuka_iiwa.chains import (
    KUKA_OMEGA,
    KUKA_POINTS,
    X,
    Y,
    Z,
    axes,
    drawn_axes,
    few_digits,
    whole_numbers,
)
from course_lib.checks.poe_kuka_iiwa.matrices import FINE, near

_APART = Mistake(
    "omega and v do not stand side by side", "Each row is one axis, (omega, v): np.hstack([omega, v]) does that."
)
_NO_ROWS = Mistake(
    "the axes of the joints do not stand in rows of their own",
    "One row (omega, v) for each joint, also where there is a single one: the shape is (n, 6).",
)
_TRANSPOSED = Mistake("rows and columns are swapped", "One axis a row: the shape is (n, 6). Transpose with .T.")
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
        (Z[None], X[None]),
        (X[None], 2 * Y[None]),
        (np.array([Y, Z]), np.zeros((2, 3))),
        (np.array([Z, Z]), np.array([0 * X, X])),
        (np.array([Z, 0.6 * X + 0.8 * Y]), np.array([[0.5, 0, 0], [1.0, -2.0, 0.5]])),
        (KUKA_OMEGA, KUKA_POINTS),
        (np.array([Z, Z, Z]), np.array([X + Y, X + Y + 2 * Z, X + Y - 3 * Z])),
    ]
    whole = [
        (np.array([[0, 0, 1], [0, -1, 0]]), np.array([[0.5, 0.25, 0], [0.75, 0, 1.5]])),
        (np.array([[0.6, 0.8, 0], [0, 0.6, -0.8]]), np.array([[1, 2, 3], [2, 1, 1]])),
    ]
    return [*named, *(drawn_axes(rng, n) for n in (1, 3, 4, 6, 7)), *whole, drawn_axes(rng, 2)]


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


def _with(v_of, omega_of=lambda omega, points: omega):
    """The answer of somebody with another v, or another omega."""
    return lambda omega, points: np.hstack([omega_of(omega, points), v_of(omega, points)])


def _right_v(omega, points):
    return np.cross(points, omega)


def _steps(points):
    """The way from each point to the next, beginning at the origin."""
    return np.diff(points, axis=0, prepend=0)


def _scaled(v):
    length = np.linalg.norm(v, axis=1, keepdims=True)
    return v / np.where(length > 0, length, 1)


SCREW_AXES = Exercise(
    name="screw_axes",
    points=1,
    arguments=("omega", "points"),
    cases=_cases,
    returns=numbers(lambda omega, points: (len(omega), 6), _known_form),
    properties=(
        Property(
            "the first three numbers of each row are the direction omega of its axis",
            lambda S, omega, points: near(S[:, :3], omega),
            seen=_other_direction,
        ),
        Property(
            "for axes through the origin v is 0: the origin does not move",
            lambda S, omega, points: near(S[:, 3:], 0),
            where=lambda omega, points: not points.any(),
            mistake=Mistake("v is not 0 for an axis through the origin", "v = -omega x p, which is 0 where p is."),
        ),
        Property(
            "a point on the axis does not move: omega x p + v = 0 for each joint",
            lambda S, omega, points: near(_at_rest(S, points), 0),
            seen=_moving_point,
        ),
    ),
    mistakes=(
        few_digits(axes),
        *whole_numbers(axes),
        Mistake(
            "v has its sign turned: it is omega x p",
            "omega x p + v must be 0 for a point p on the axis. So v = -omega x p, or p x omega.",
            _with(lambda omega, points: np.cross(omega, points)),
        ),
        Mistake(
            "v stands before omega",
            "The order in this course is (omega, v).",
            lambda omega, points: np.hstack([_right_v(omega, points), omega]),
            lambda omega, points: np.hstack([np.cross(omega, points), omega]),
        ),
        Mistake(
            "the point is taken for v",
            "v is a velocity: that of the point at the origin when the joint turns with 1 rad/s. v = -omega x p.",
            _with(lambda omega, points: points),
            _with(lambda omega, points: -points),
            lambda omega, points: np.hstack([points, omega]),
        ),
        Mistake(
            "omega * p, entry by entry, stands for the cross product",
            "In numpy the cross product is np.cross.",
            _with(lambda omega, points: points * omega),
            _with(lambda omega, points: -points * omega),
        ),
        Mistake(
            "v is 0 for every axis",
            "Only an axis through the origin has v = 0: v = -omega x p.",
            _with(lambda omega, points: 0 * points),
        ),
        Mistake(
            "every axis is taken for one along z",
            "Each joint has its own direction: omega[i].",
            _with(lambda omega, points: np.cross(points, Z)),
            _with(lambda omega, points: np.cross(points, Z), lambda omega, points: 0 * omega + Z),
            _with(_right_v, lambda omega, points: 0 * omega + Z),
        ),
        Mistake(
            "every row has the direction of one joint",
            "Each joint has its own direction: omega[i].",
            *(_with(lambda omega, points, i=i: np.cross(points, omega[i])) for i in (0, -1)),
            *(lambda omega, points, i=i: axes(0 * omega + omega[i], points) for i in (0, -1)),
        ),
        Mistake(
            "every row has the point of one joint",
            "Each axis goes through its own point: points[i].",
            *(lambda omega, points, i=i: axes(omega, 0 * points + points[i]) for i in (0, -1)),
        ),
        Mistake(
            "every row is the same joint's",
            "Fill row i in the loop, with omega[i] and points[i].",
            *(lambda omega, points, i=i: axes(omega, points)[[i] * len(omega)] for i in (0, -1)),
        ),
        Mistake(
            "the points are counted from the joint before",
            "All points are given in the space frame already: use points[i] as it is.",
            lambda omega, points: axes(omega, _steps(points)),
        ),
        Mistake(
            "the points are added up",
            "All points are given in the space frame already: use points[i] as it is.",
            lambda omega, points: axes(omega, np.cumsum(points, 0)),
        ),
        Mistake(
            "v is scaled to length one",
            "Only omega has length one. The length of v is how far the axis is away.",
            _with(lambda omega, points: _scaled(_right_v(omega, points))),
        ),
        Mistake(
            "the point stands where omega belongs",
            "A row is (omega, v). The point only serves to find v.",
            _with(_right_v, lambda omega, points: points),
        ),
        Mistake(
            "the cross product is taken twice",
            "v = -omega x p: once is enough.",
            _with(lambda omega, points: np.cross(omega, np.cross(points, omega))),
            _with(lambda omega, points: np.cross(np.cross(points, omega), omega)),
        ),
        Mistake(
            "omega has its sign turned",
            "The first three numbers are omega as it is given.",
            _with(_right_v, lambda omega, points: -omega),
        ),
    ),
    hints=(
        "A point p on the axis does not move when the joint turns. Its velocity is omega x p + v.",
        "So v = -omega x p, which is p x omega: np.cross works on all rows at once.",
        "omega and v side by side: np.hstack([omega, v]).",
    ),
    forbidden=("course_lib.arms.SerialArm",),
)
