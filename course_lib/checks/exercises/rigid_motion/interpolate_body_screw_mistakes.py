"""What students get wrong in interpolate_body_screw."""

import numpy as np

from course_lib.checks.exercise import Mistake
from course_lib.checks.exercises.rigid_motion.shared import REVOLUTION, change, deviation, known, scaling, size, straight
from course_lib.checks.exercises.rigid_motion.shared_mistakes import path_mistakes
from course_lib.planar import pose_matrix
from course_lib.rigid import exp_se2, inverse, log_se2

SMALL = 1e-2  # radians: with an angle below that, the pole is far away, and formulas with it may lose digits


def rotation(theta):
    """Return the rotation matrix (2, 2)."""
    return pose_matrix([0, 0, theta])[:2, :2]


def _seen_from(start, goal):
    """The position of goal in start's frame."""
    return rotation(start[2]).T @ np.subtract(goal, start)[:2]


def _twist_to(angle, position):
    """The twist (omega, vx, vy) that rotates by `angle`, of any size below a revolution, and leads to the position."""
    columns = [exp_se2([angle, *v])[:2, 2] for v in np.eye(2)]
    return np.array([angle, *np.linalg.solve(np.transpose(columns), position)])


def _along(start, twist, s):
    """The poses T_start exp(s twist)."""
    moved = exp_se2(np.multiply.outer(s, twist))[:, :2, 2]
    return np.column_stack([start[:2] + moved @ rotation(start[2]).T, start[2] + s * twist[0]])


def by_screw(start, goal, s, angle):
    """Return the poses from start to goal by one rotation through this angle."""
    return _along(start, _twist_to(angle, _seen_from(start, goal)), s)


def _with_twist(changed):
    """The poses T_start exp(s twist) with changed(twist, start, goal) for the twist."""

    def answer(start, goal, n):
        twist = _twist_to(change(start, goal)[2], _seen_from(start, goal))
        return _along(start, changed(twist, start, goal), scaling(n))

    return known(answer)


def _by_matrices(product):
    """The poses product(T_start, T_goal, move), where move(T) is exp(s log(T)) for all s."""

    def answer(start, goal, n):
        def move(T):
            return exp_se2(np.multiply.outer(scaling(n), log_se2(T)))

        T = product(pose_matrix(start), pose_matrix(goal), move)
        return np.column_stack([T[:, :2, 2], np.arctan2(T[:, 1, 0], T[:, 0, 0])])

    return known(answer)


def _with(theta=None, position=None, s_of=scaling):
    """The right poses with other theta(start, goal, twist, s), or another position(start, goal, twist, s)."""

    def answer(start, goal, n):
        twist, s = _twist_to(change(start, goal)[2], _seen_from(start, goal)), s_of(n)
        rows = _along(start, twist, s)
        if theta:
            rows[:, 2] = theta(start, goal, twist, s)
        if position:
            rows[:, :2] = position(start, goal, twist, s)
        return rows

    return known(answer)


def _blended(start, goal, n):
    """The matrices are interpolated entry by entry."""
    s = scaling(n)[:, None, None]
    T = (1 - s) * pose_matrix(start) + s * pose_matrix(goal)
    return np.column_stack([T[:, :2, 2], np.arctan2(T[:, 1, 0], T[:, 0, 0])])


def _logarithms_blended(start, goal, n):
    first, last = log_se2(pose_matrix(start)), log_se2(pose_matrix(goal))
    T = exp_se2(first + np.multiply.outer(scaling(n), last - first))
    return np.column_stack([T[:, :2, 2], np.arctan2(T[:, 1, 0], T[:, 0, 0])])


def _entrywise(start, goal, twist, s):
    return (pose_matrix(start) * exp_se2(np.multiply.outer(s, twist)))[:, :2, 2]


def _exponential_scaled(start, goal, twist, s):
    return (pose_matrix(start) @ (s[:, None, None] * exp_se2(twist)))[:, :2, 2]


def _rotating_by(angle_of):
    """One rotation about one point, by angle_of(start, goal, angle) instead of the right angle."""

    def answer(start, goal, n):
        angle = angle_of(start, goal, change(start, goal)[2])
        if abs(angle) > SMALL and abs(np.sin(angle / 2)) < SMALL:
            return None  # whole revolutions lead nowhere
        return by_screw(start, goal, scaling(n), angle)

    return known(answer)


def _tiny(start, goal):
    return 0 < abs(change(start, goal)[2]) < SMALL


def _nearly_right(rows, start, goal, n):
    right = by_screw(start, goal, scaling(n), change(start, goal)[2])
    return _tiny(start, goal) and deviation(rows, right) < 1e-2 * size(start, goal)


def _straight_with_a_tiny_angle(rows, start, goal, n):
    line = straight(start, change(start, goal), scaling(n))
    return _tiny(start, goal) and np.abs(rows - line)[:, :2].max() < 1e-9 * size(start, goal)


_READ_THETA = "theta is start's plus s omega, or read from T by arctan2."

MISTAKES = (
    Mistake(
        "a small rotation is taken for none",
        "Only for omega = 0 is the path straight. A rotation by 0.001 rad bends it by a millimetre or so.",
        seen=_straight_with_a_tiny_angle,
    ),
    Mistake(
        "digits are lost where the rotation is tiny",
        "The pole lies very far away then, and large numbers cancel. rigid.exp_se2 does not need the pole.",
        seen=_nearly_right,
    ),
    Mistake(
        "x, y and theta are interpolated each by itself: a straight line",
        "Here the velocity is constant in the body's frame: T_start exp(s log(T_start^-1 T_goal)).",
        known(lambda start, goal, n: straight(start, change(start, goal), scaling(n))),
        known(lambda start, goal, n: straight(start, np.subtract(goal, start), scaling(n))),
    ),
    Mistake(
        "the matrices are interpolated entry by entry",
        "Halfway between two rotations that is no rotation. Scale the logarithm, the twist.",
        known(_blended),
    ),
    Mistake(
        "the logarithms of the two poses are interpolated",
        "Take one logarithm, of the pose of goal in start's frame, T_start^-1 T_goal.",
        known(_logarithms_blended),
    ),
    Mistake(
        "the displacement is in the world's frame, T_goal T_start^-1, but applied in the body's",
        "To the right of T_start belongs the goal as seen from start: T_start^-1 T_goal.",
        _by_matrices(lambda T0, T1, move: T0 @ move(T1 @ inverse(T0))),
    ),
    Mistake(
        "the twist of the body is applied to the left of T_start, in the world",
        "T_start^-1 T_goal is seen from start: its exponential belongs to the right of T_start.",
        _by_matrices(lambda T0, T1, move: move(inverse(T0) @ T1) @ T0),
    ),
    Mistake(
        "the displacement is from goal to start",
        "T_start^-1 T_goal: the inverse is that of start.",
        _by_matrices(lambda T0, T1, move: T0 @ move(inverse(T1) @ T0)),
        _by_matrices(lambda T0, T1, move: T0 @ move(T0 @ inverse(T1))),
        _by_matrices(lambda T0, T1, move: move(T0 @ inverse(T1)) @ T0),
    ),
    Mistake(
        "the logarithm of T_goal alone is taken",
        "The displacement that remains is T_start^-1 T_goal.",
        _by_matrices(lambda T0, T1, move: T0 @ move(T1)),
        _by_matrices(lambda T0, T1, move: move(T1)),
        _by_matrices(lambda T0, T1, move: move(T1) @ T0),
    ),
    Mistake(
        "T_start is left out",
        "exp(s twist) is the pose as start sees it: T_start exp(s twist).",
        _by_matrices(lambda T0, T1, move: move(inverse(T0) @ T1)),
        _by_matrices(lambda T0, T1, move: move(T1 @ inverse(T0))),
    ),
    Mistake(
        "the numbers of the twist are taken in another order",
        "(omega, vx, vy): the angular velocity comes first, in log_se2 and in exp_se2.",
        *(_with_twist(lambda twist, *ends, order=order: twist[order]) for order in ([1, 2, 0], [2, 0, 1], [0, 2, 1])),
        _with(theta=lambda start, goal, twist, s: start[2] + s * twist[2]),
    ),
    Mistake("the product is entry by entry", "In numpy the matrix product is @.", _with(position=_entrywise)),
    Mistake(
        "the exponential is multiplied by s, and not the twist",
        "exp(s twist): part of the twist gives part of the motion.",
        _with(position=_exponential_scaled),
    ),
    Mistake(
        "the velocities of the twist are added to x and y as they are",
        "They are given in the body's frame, which rotates. exp_se2 takes that into account.",
        _with(position=lambda start, goal, twist, s: start[:2] + np.multiply.outer(s, twist[1:])),
        _with(position=lambda start, goal, twist, s: start[:2] + np.multiply.outer(s, rotation(start[2]) @ twist[1:])),
    ),
    Mistake(
        "the translation is not rotated from start's frame into the world's",
        "T_start @ exp(...) does both.",
        _with(position=lambda start, goal, twist, s: start[:2] + exp_se2(np.multiply.outer(s, twist))[:, :2, 2]),
    ),
    Mistake(
        "the translation is not rotated into start's frame",
        "As start sees it, goal lies at R(theta)^T (p_goal - p_start).",
        _with_twist(lambda twist, start, goal: _twist_to(twist[0], np.subtract(goal, start)[:2])),
    ),
    Mistake(
        "only theta is interpolated",
        "x and y change too: they stand in the last column of T.",
        _with(position=lambda start, goal, twist, s: np.tile(start[:2], (len(s), 1))),
    ),
    Mistake(
        "theta is not interpolated",
        _READ_THETA,
        _with(theta=lambda start, goal, twist, s: start[2] + 0 * s),
        _with(theta=lambda start, goal, twist, s: goal[2] + 0 * s),
    ),
    Mistake("start's theta is not added", _READ_THETA, _with(theta=lambda start, goal, twist, s: s * twist[0])),
    Mistake(
        "the difference of theta is not wrapped, so the body takes the longer arc",
        "log_se2 wraps: its omega lies between -pi and pi. Take theta from there.",
        _with(theta=lambda start, goal, twist, s: start[2] + s * (goal[2] - start[2])),
        _rotating_by(lambda start, goal, angle: goal[2] - start[2]),
        _rotating_by(lambda start, goal, angle: angle - np.copysign(REVOLUTION, angle)),
    ),
    Mistake(
        "the twist is scaled by s twice, or not at all",
        "exp(s log(...)): s once, in front of the logarithm.",
        _with(s_of=lambda n: scaling(n) ** 2),
        _with(s_of=np.ones),
    ),
    Mistake(
        "arctan2 has sine and cosine swapped",
        "theta = np.arctan2(T[1, 0], T[0, 0]): the sine comes first.",
        _with(theta=lambda start, goal, twist, s: np.pi / 2 - start[2] - s * twist[0]),
    ),
    Mistake(
        "arccos, arcsin or arctan is used, which know the angle on half of the circle only",
        "theta = np.arctan2(T[1, 0], T[0, 0]).",
        *(
            _with(theta=lambda start, goal, twist, s, f=f: f(start[2] + s * twist[0]))
            for f in (lambda a: np.arccos(np.cos(a)), lambda a: np.arcsin(np.sin(a)), lambda a: np.arctan(np.tan(a)))
        ),
    ),
    Mistake(
        "theta has the opposite sign",
        "theta = np.arctan2(T[1, 0], T[0, 0]), not T[0, 1].",
        _with(theta=lambda start, goal, twist, s: -start[2] - s * twist[0]),
    ),
    *path_mistakes(lambda start, goal, s, change: by_screw(start, goal, s, change[2])),
)
