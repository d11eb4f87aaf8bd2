"""read_ur5e: the student reads the axes of a UR5e off a drawing; any point on an axis is right."""

import numpy as np

from course_lib.arms import ur5e
from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.poe_kuka_iiwa.shared import axes

_TOLERANCE = 1e-4  # metres: a tenth of the drawing's last digit
_ARM = ur5e()
_OMEGA = _ARM.screw_axes[:, :3]
_POINTS = np.cross(_OMEGA, _ARM.screw_axes[:, 3:])  # the point of each axis that is nearest to the origin
_TRANSPOSED = Mistake("rows and columns are swapped", "One joint a row: the shape is (6, 6).")
_NO_POINTS = Mistake("only the directions are returned", "A row is a direction and a point: six numbers.")

_LAST = np.arange(6)[:, None] == 4
_DROP = np.outer(np.arange(6) == 5, [False, False, True])


def _right():
    return np.hstack([_OMEGA, _POINTS])


def _velocity(rows):
    """The velocity of the base's origin when each joint rotates at 1 rad/s: what the choice of point leaves alone."""
    return axes(rows[:, :3], rows[:, 3:])[:, 3:]


def _off(rows):
    """The distance of each axis from the right one, where the direction is right."""
    return np.abs(_velocity(rows) - _velocity(_right())).max(1)


def _direction_seen(rows):
    i = int(np.argmax(np.abs(rows[:, :3] - _OMEGA).max(1) > 1e-6))
    name = "axis" if np.allclose(np.abs(rows[i, :3]), np.abs(_OMEGA[i])) else "direction"
    sign = " It is the opposite one." if name == "axis" else ""
    return f"Joint {i + 1} has another: yours is {format_tuple(rows[i, :3])}.{sign}"


def _point_seen(rows):
    i = int(np.argmax(_off(rows) > _TOLERANCE))
    return (
        f"Your point of joint {i + 1}, {format_tuple(rows[i, 3:])}, lies {_off(rows)[i] * 1000:.3g} mm beside its axis."
    )


def _alike(value, predicted):
    same_directions = np.allclose(value[:, :3], predicted[:, :3], atol=1e-6)
    return same_directions and np.allclose(_velocity(value), _velocity(predicted), atol=_TOLERANCE)


def _with(change):
    """The answer of somebody whose rows are changed: change(omega, points)."""
    return lambda: np.hstack(change(_OMEGA.copy(), _POINTS.copy()))


def _one_sign(i):
    return lambda omega, points: (np.where(np.arange(6)[:, None] == i, -omega, omega), points)


def _heights_from_shoulder(omega, points):
    return omega, points - [0, 0, 0.1625]


EXERCISE = Exercise(
    name="read_ur5e",
    points=3,
    arguments=(),
    cases=lambda rng: [()],
    returns=numbers(lambda: (6, 6), {(6, 3): _NO_POINTS, (3, 6): _NO_POINTS, (7, 6): None}),
    properties=(
        Property(
            "each direction has length one",
            lambda rows: np.allclose(np.linalg.norm(rows[:, :3], axis=1), 1, atol=1e-6),
            seen=lambda rows: f"The lengths are {format_tuple(np.linalg.norm(rows[:, :3], axis=1))}.",
            mistake=Mistake("a row does not begin with a unit direction", "A row is the direction, then the point."),
        ),
        Property(
            "the axes have the directions of the arrows in the drawing",
            lambda rows: np.allclose(rows[:, :3], _OMEGA, atol=1e-6),
            seen=_direction_seen,
            points=1,
        ),
        Property(
            "each point lies on the axis of its joint",
            lambda rows: (_off(rows) <= _TOLERANCE).all(),
            seen=_point_seen,
        ),
    ),
    mistakes=(
        Mistake(
            "the points stand before the directions",
            "A row is the direction, then the point.",
            lambda: np.roll(_right(), 3, axis=1),
            alike=lambda value, predicted: _alike(np.roll(value, 3, 1), np.roll(predicted, 3, 1)),
        ),
        Mistake(
            "lengths are in millimetres",
            "The drawing is in millimetres, the task in metres.",
            _with(lambda omega, points: (omega, 1000 * points)),
        ),
        Mistake(
            "velocities v stand where points belong",
            "This exercise asks for points; screw_axes makes v of them.",
            lambda: _ARM.screw_axes,
        ),
        Mistake(
            "all directions are reversed",
            "An arrow shows about which direction a positive angle rotates counter-clockwise.",
            _with(lambda omega, points: (-omega, points)),
        ),
        Mistake(
            "the arrows along y are reversed",
            "In the side view y points away from you, or towards you: look at the cross or the dot of its axis.",
            _with(lambda omega, points: (omega * [1, -1, 1], points)),
            _with(lambda omega, points: (omega * [1, -1, 1], points * [1, -1, 1])),
        ),
        Mistake(
            "the direction of one joint is reversed",
            "Look at the drawing's arrows again, joint by joint.",
            *(_with(_one_sign(i)) for i in range(6)),
        ),
        Mistake(
            "x is reversed: the arm points along +x",
            "Which way does the base's x axis point in the drawing?",
            _with(lambda omega, points: (omega, points * [-1, 1, 1])),
        ),
        Mistake(
            "y is reversed in the points",
            "Which way does the base's y axis point in the drawing?",
            _with(lambda omega, points: (omega, points * [1, -1, 1])),
        ),
        Mistake(
            "heights are counted from the shoulder, not from the base",
            "All points are given in the base frame, whose origin is on the floor plate.",
            _with(_heights_from_shoulder),
        ),
        Mistake(
            "dimensions are not added up from the base",
            "Dimensions are distances between neighbours; a point's coordinates are counted from the base.",
            _with(lambda omega, points: (omega, np.where(points < -0.8, -0.3922, points))),
            _with(lambda omega, points: (omega, np.where(_LAST & (points < -0.8), 0, points))),
        ),
        Mistake(
            "axis 6 is at the height of axes 2 to 4, or at twice the drop",
            "Axis 6 lies below the upper arm: look at the side view.",
            *(_with(lambda omega, points, z=z: (omega, np.where(_DROP, z, points))) for z in (0.1625, 0.2622)),
        ),
        Mistake(
            "all axes go through the origin",
            "A row needs a point on its axis, in the base frame.",
            _with(lambda omega, points: (omega, 0 * points)),
        ),
    ),
    hints=(
        "Go joint by joint. An axis along z needs x and y from the top view; an axis along y needs x and z from the "
        "side view. The third coordinate of the point is up to you.",
        "Dimensions are distances between neighbours: add them up from the base. Mind the signs: the arm points "
        "along -x.",
        "Axes 2, 3 and 4 are parallel, at the same height; axis 5 hangs down beside them, axis 6 is parallel to "
        "them, lower.",
    ),
    library=_right,
    alike=_alike,
)
