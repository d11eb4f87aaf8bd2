"""Reading an arm off its drawing: directions and points of axes, of which any point is right."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.poe_kuka_iiwa.shared import axes
from course_lib.checks.format_numbers import format_tuple

_TOLERANCE = 1e-4  # metres: a tenth of the drawing's last digit
_NO_POINTS = Mistake("only the directions are returned", "A row is a direction and a point: six numbers.")
_NO_DIRECTION = Mistake("a row does not begin with a unit direction", "A row is the direction, then the point.")


def reading(name, points, arm, hints):
    """Return the exercise of reading an arm, a row (direction, point) for each joint, with mistakes of any arm."""
    n, right = arm.n, rows_of(arm)
    omega = right[:, :3]

    def off(rows):
        return np.abs(_velocity(rows) - _velocity(right)).max(1)

    def direction_off(rows):
        i = int(np.argmax(np.abs(rows[:, :3] - omega).max(1) > 1e-6))
        opposite = " It is the opposite one." if np.allclose(rows[i, :3], -omega[i]) else ""
        return f"Joint {i + 1} has another: yours is {format_tuple(rows[i, :3])}.{opposite}"

    def point_off(rows):
        i = int(np.argmax(off(rows) > _TOLERANCE))
        return (
            f"Your point of joint {i + 1}, {format_tuple(rows[i, 3:])}, is {off(rows)[i] * 1000:.3g} mm off its axis."
        )

    exercise = Exercise(
        name=name,
        points=points,
        arguments=(),
        cases=lambda rng: [()],
        returns=numbers(lambda: (n, 6), {(n, 3): _NO_POINTS, (3, n): _NO_POINTS}),
        library=lambda: right,
        properties=(
            Property(
                "each direction has length one",
                lambda rows: np.allclose(np.linalg.norm(rows[:, :3], axis=1), 1, atol=1e-6),
                says=lambda rows: f"The lengths are {format_tuple(np.linalg.norm(rows[:, :3], axis=1))}.",
                mistake=_NO_DIRECTION,
            ),
            Property(
                "the axes have the directions of the arrows in the drawing",
                lambda rows: np.allclose(rows[:, :3], omega, atol=1e-6),
                says=direction_off,
                points=1,
            ),
            Property(
                "each point lies on the axis of its joint",
                lambda rows: (off(rows) <= _TOLERANCE).all(),
                says=point_off,
            ),
        ),
        hints=hints,
        alike=_same_motion,
    )
    _add_mistakes(exercise, arm)
    return exercise


def _add_mistakes(exercise, arm):
    """Add the mistakes that the drawing of any arm invites."""
    right = rows_of(arm)
    omega, points = right[:, :3], right[:, 3:]

    def halves_swapped_alike(value, predicted):
        return _same_motion(np.roll(value, 3, 1), np.roll(predicted, 3, 1))

    @exercise.mistake(alike=halves_swapped_alike)
    def points_first():
        """the points stand before the directions. A row is the direction, then the point."""
        return np.hstack([points, omega])

    @exercise.mistake
    def millimetres():
        """lengths are in millimetres. The drawing is in millimetres: in which unit does the task want them?"""
        return np.hstack([omega, 1000 * points])

    @exercise.mistake
    def velocities():
        """velocities v stand where points belong. This exercise asks for points; screw_axes computes v from them."""
        return arm.screw_axes

    @exercise.mistake(of_points=([1, 1, 1], [1, -1, 1]))
    def y_reversed(of_points):
        """the arrows along y are reversed. In the side view, does y point away from you or towards you, and what do a
        dot and a cross stand for?"""
        return np.hstack([omega * [1, -1, 1], points * of_points])

    @exercise.mistake(joints=(*range(arm.n), slice(None)))
    def reversed_directions(joints):
        """the direction of a joint is reversed, or of all. Go through the arrows of the drawing, joint by joint."""
        rows = right.copy()
        rows[joints, :3] *= -1
        return rows

    @exercise.mistake
    def heights_from_the_shoulder():
        """heights are counted from the shoulder, not from the base. Where is the origin of the base frame?"""
        return np.hstack([omega, points - [0, 0, points[1, 2]]])


def rows_of(arm):
    """Return direction and point of each axis, shape (n, 6): the point that is nearest to the origin."""
    omega = arm.screw_axes[:, :3]
    return np.hstack([omega, np.cross(omega, arm.screw_axes[:, 3:])])


def _same_motion(value, predicted):
    """Return whether rows have the same directions and their joints move the arm alike."""
    same_directions = np.allclose(value[:, :3], predicted[:, :3], atol=1e-6)
    return same_directions and np.allclose(_velocity(value), _velocity(predicted), atol=_TOLERANCE)


def _velocity(rows):
    """The velocity of the base's origin when each joint rotates at 1 rad/s: the choice of the point does not matter."""
    return axes(rows[:, :3], rows[:, 3:])[:, 3:]
