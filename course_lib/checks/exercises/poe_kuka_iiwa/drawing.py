"""Reading an arm off its drawing: directions and points of axes, of which any point is right."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.poe_kuka_iiwa.shared import axes

TOLERANCE = 1e-4  # metres: a tenth of the drawing's last digit


def reading(name, points, arm, hints, mistakes=()):
    """Return the exercise of reading an arm: a row (direction, point) for each joint.

    Parameters
    ----------
    name : str
    points : int
    arm : SerialArm
    hints : tuple of str
    mistakes : tuple of Mistake
        Those that belong to this arm, before the ones of all arms.
    """
    n, right = arm.n, rows_of(arm)
    omega, at = right[:, :3], right[:, 3:]

    def off(rows):
        return np.abs(_velocity(rows) - _velocity(right)).max(1)

    def direction_seen(rows):
        i = int(np.argmax(np.abs(rows[:, :3] - omega).max(1) > 1e-6))
        opposite = " It is the opposite one." if np.allclose(rows[i, :3], -omega[i]) else ""
        return f"Joint {i + 1} has another: yours is {format_tuple(rows[i, :3])}.{opposite}"

    def point_seen(rows):
        i = int(np.argmax(off(rows) > TOLERANCE))
        return (
            f"Your point of joint {i + 1}, {format_tuple(rows[i, 3:])}, is {off(rows)[i] * 1000:.3g} mm from its axis."
        )

    def one_sign(i):
        return lambda: np.hstack([np.where(np.arange(n)[:, None] == i, -omega, omega), at])

    def changed(*change):
        return [lambda f=f: np.hstack(f(omega, at)) for f in change]

    no_points = Mistake("only the directions are returned", "A row is a direction and a point: six numbers.")
    return Exercise(
        name=name,
        points=points,
        arguments=(),
        cases=lambda rng: [()],
        returns=numbers(lambda: (n, 6), {(n, 3): no_points, (3, n): no_points}),
        properties=(
            Property(
                "each direction has length one",
                lambda rows: np.allclose(np.linalg.norm(rows[:, :3], axis=1), 1, atol=1e-6),
                says=lambda rows: f"The lengths are {format_tuple(np.linalg.norm(rows[:, :3], axis=1))}.",
                mistake=Mistake(
                    "a row does not begin with a unit direction", "A row is the direction, then the point."
                ),
            ),
            Property(
                "the axes have the directions of the arrows in the drawing",
                lambda rows: np.allclose(rows[:, :3], omega, atol=1e-6),
                says=direction_seen,
                points=1,
            ),
            Property(
                "each point lies on the axis of its joint",
                lambda rows: (off(rows) <= TOLERANCE).all(),
                says=point_seen,
            ),
        ),
        mistakes=(
            Mistake(
                "the points stand before the directions",
                "A row is the direction, then the point.",
                lambda: np.roll(right, 3, axis=1),
                alike=lambda value, predicted: same_motion(np.roll(value, 3, 1), np.roll(predicted, 3, 1)),
            ),
            Mistake(
                "lengths are in millimetres",
                "The drawing is in millimetres, the task in metres.",
                *changed(lambda omega, at: (omega, 1000 * at)),
            ),
            Mistake(
                "velocities v stand where points belong",
                "This exercise asks for points; screw_axes computes v from them.",
                lambda: arm.screw_axes,
            ),
            Mistake(
                "all directions are reversed",
                "An arrow shows about which direction a positive angle rotates counter-clockwise.",
                *changed(lambda omega, at: (-omega, at)),
            ),
            *mistakes,
            Mistake(
                "the arrows along y are reversed",
                "In the side view y points away from you, or towards you: look at the cross or the dot of its axis.",
                *changed(
                    lambda omega, at: (omega * [1, -1, 1], at), lambda omega, at: (omega * [1, -1, 1], at * [1, -1, 1])
                ),
            ),
            Mistake(
                "the direction of one joint is reversed",
                "Look at the drawing's arrows again, joint by joint.",
                *(one_sign(i) for i in range(n)),
            ),
            Mistake(
                "heights are counted from the shoulder, not from the base",
                "All points are given in the base frame, whose origin is on the floor plate.",
                *changed(lambda omega, at: (omega, at - [0, 0, at[1, 2]])),
            ),
            Mistake(
                "all axes go through the origin",
                "A row needs a point on its axis, in the base frame.",
                *changed(lambda omega, at: (omega, 0 * at)),
            ),
        ),
        hints=hints,
        library=lambda: right,
        alike=same_motion,
    )


def rows_of(arm):
    """Return direction and point of each axis, shape (n, 6): the point that is nearest to the origin."""
    omega = arm.screw_axes[:, :3]
    return np.hstack([omega, np.cross(omega, arm.screw_axes[:, 3:])])


def same_motion(value, predicted):
    """Return whether rows have the same directions and their joints move the arm alike."""
    same_directions = np.allclose(value[:, :3], predicted[:, :3], atol=1e-6)
    return same_directions and np.allclose(_velocity(value), _velocity(predicted), atol=TOLERANCE)


def _velocity(rows):
    """The velocity of the base's origin when each joint rotates at 1 rad/s: the choice of the point does not matter."""
    return axes(rows[:, :3], rows[:, 3:])[:, 3:]
