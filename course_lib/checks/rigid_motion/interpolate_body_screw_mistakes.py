"""Paths along a screw of the plane, the right ones and those of mistakes in the twist, for interpolate_body_screw.

Predictions are functions of (start, goal, way, n), as paths.like wants them.
"""

import numpy as np

from course_lib.checks.rigid_motion.interpolate_body import BODY
from course_lib.checks.rigid_motion.paths import change, even, miss, rest_to_rest, size, straight, ways
from course_lib.planar import pose_matrix
from course_lib.rigid import exp_se2, log_se2

_SMALL = 1e-2  # radians: with a turn below that, the pole is far away, and formulas with it may lose digits


def rotation(theta):
    return pose_matrix([0, 0, theta])[:2, :2]


def _seen_from(start, goal):
    """The place of goal in start's frame."""
    return rotation(start[2]).T @ np.subtract(goal, start)[:2]


def twist_to(turn, place):
    """The twist (omega, vx, vy) that turns by `turn`, of any size below a whole turn, and leads to this place."""
    columns = [exp_se2([turn, *v])[:2, 2] for v in np.eye(2)]
    return np.array([turn, *np.linalg.solve(np.transpose(columns), place)])


def along(start, twist, s):
    """The poses T_start exp(s twist)."""
    moved = exp_se2(np.multiply.outer(s, twist))[:, :2, 2]
    return np.column_stack([start[:2] + moved @ rotation(start[2]).T, start[2] + s * twist[0]])


def right_screws(start, goal, n):
    """Two paths where the turn is half a turn, else one."""
    turns = [way[2] for way in ways(start, goal, BODY)]
    return [along(start, twist_to(turn, _seen_from(start, goal)), rest_to_rest(even(n))) for turn in turns]


def turns(start, goal, n):
    """Whether there is a turn that is not tiny."""
    return _turn(start, goal) >= _SMALL


def no_turn(start, goal, n):
    return _turn(start, goal) == 0


def _turn(start, goal):
    return abs(change(start, goal, BODY)[2])


def _pole(start, goal):
    """The point that start and goal, as one turn, leave where it is."""
    R = rotation(goal[2] - start[2])
    p, q = np.array(start, float)[:2], np.array(goal, float)[:2]
    return np.linalg.solve(np.eye(2) - R, q - R @ p)


def _distances(rows, start, goal):
    return np.linalg.norm(rows[:, :2] - _pole(start, goal), axis=1)


def on_the_arc(rows, start, goal, n):
    return np.ptp(_distances(rows, start, goal)) <= 1e-9 * size(start, goal) / _turn(start, goal)


def seen_from_the_pole(rows, start, goal, n):
    x, y = _pole(start, goal)
    distances = _distances(rows, start, goal)
    near, far = distances.min(), distances.max()
    return f"The pole is at ({x:.4g}, {y:.4g}); your places are {near:.4g} to {far:.4g} m from it."


def fits(rows, start, goal, n):
    """Whether the rows are right; where the turn is tiny, to the digits that formulas with the pole leave."""
    fine = 1e-9 if _turn(start, goal) >= _SMALL else 1e-7
    return any(miss(rows, path, BODY) <= fine * size(start, goal) for path in right_screws(start, goal, n))


def by_screw(start, goal, way, s):
    return along(start, twist_to(way[2], _seen_from(start, goal)), s)


def with_twist(changed):
    """A prediction: T_start exp(s twist) with changed(twist) for the right twist."""

    def prediction(start, goal, way, n):
        return along(start, changed(twist_to(way[2], _seen_from(start, goal))), rest_to_rest(even(n)))

    return prediction


def by_matrices(product):
    """A prediction: the poses product(T_start, T_goal, move), where move(T) is exp(s log(T)) for all s."""

    def prediction(start, goal, way, n):
        def move(T):
            return exp_se2(np.multiply.outer(rest_to_rest(even(n)), log_se2(T)))

        T = product(pose_matrix(start), pose_matrix(goal), move)
        return np.column_stack([T[:, :2, 2], np.arctan2(T[:, 1, 0], T[:, 0, 0])])

    return prediction


def with_theta(theta):
    """A prediction: places on the right arc, and theta(start, goal, twist, s)."""

    def prediction(start, goal, way, n):
        twist, s = twist_to(way[2], _seen_from(start, goal)), rest_to_rest(even(n))
        return np.column_stack([along(start, twist, s)[:, :2], theta(start, goal, twist, s)])

    return prediction


def with_places(places):
    """A prediction: theta as it should be, and places(start, goal, twist, s)."""

    def prediction(start, goal, way, n):
        twist, s = twist_to(way[2], _seen_from(start, goal)), rest_to_rest(even(n))
        return np.column_stack([places(start, goal, twist, s), start[2] + s * way[2]])

    return prediction


def blended(start, goal, way, n):
    """The matrices are interpolated entry by entry."""
    s = rest_to_rest(even(n))[:, None, None]
    T = (1 - s) * pose_matrix(start) + s * pose_matrix(goal)
    return np.column_stack([T[:, :2, 2], np.arctan2(T[:, 1, 0], T[:, 0, 0])])


def turning_by(turn_of):
    """A prediction: one turn about one point, by turn_of(start, goal, turn) in place of the right turn."""

    def prediction(start, goal, way, n):
        turn = turn_of(start, goal, way[2])
        if abs(turn) > _SMALL and abs(np.sin(turn / 2)) < _SMALL:
            return None  # whole turns lead nowhere
        return along(start, twist_to(turn, _seen_from(start, goal)), rest_to_rest(even(n)))

    return prediction


def _tiny(start, goal):
    return 0 < _turn(start, goal) < _SMALL


def nearly_right(rows, start, goal, n):
    """Whether a tiny turn is all that is not quite right."""
    near = 1e-2 * size(start, goal)
    return _tiny(start, goal) and any(miss(rows, path, BODY) < near for path in right_screws(start, goal, n))


def tiny_turn_for_none(rows, start, goal, n):
    """Whether a body with a tiny turn goes straight."""
    line = straight(start, change(start, goal, BODY), rest_to_rest(even(n)))
    return _tiny(start, goal) and np.abs(rows - line)[:, :2].max() < 1e-9 * size(start, goal)
