"""interpolate_body_screw: from pose to pose with a velocity that is constant in the body's
frame."""

import numpy as np

from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.tolerances import EXACT, HALF_THE_DIGITS
from course_lib.lessons.rigid_motion.exercises import shared
from course_lib.lessons.rigid_motion.exercises.interpolate_body import (
    SWEEPS,
    between,
    plain_cases,
    rotating_cases,
)
from course_lib.planar import interpolate_body_screw, pose_matrix
from course_lib.rigid import exp_se2, inverse, log_se2

# radians: with an angle below that, the pole is far away, and formulas with it may lose digits
SMALL = 1e-2


def _cases(rng):
    tiny = [between(rng, 0.8, 0.8 + angle, 5) for angle in (1e-3, -1e-12)]
    return plain_cases(rng) + rotating_cases(rng) + tiny


def by_screw(start, goal, s, angle):
    """Return the poses from start to goal by one rotation through this angle."""
    R = pose_matrix([0, 0, start[2]])[:2, :2]
    columns = [exp_se2([angle, *v])[:2, 2] for v in np.eye(2)]
    v = np.linalg.solve(np.transpose(columns), R.T @ np.subtract(goal, start)[:2])
    moved = exp_se2(np.multiply.outer(s, np.array([angle, *v])))[:, :2, 2]
    return np.column_stack([start[:2] + moved @ R.T, start[2] + s * angle])


def _angle(start, goal):
    return abs(shared.change(start, goal)[2])


def _rotates(start, goal, n):
    """Return whether there is a rotation that is not tiny."""
    return _angle(start, goal) >= SMALL and shared.one_arc_is_shorter(start, goal, n)


def _pole(start, goal):
    """The point that the displacement from start to goal leaves where it is."""
    R = pose_matrix([0, 0, goal[2] - start[2]])[:2, :2]
    p, q = np.array(start, float)[:2], np.array(goal, float)[:2]
    return np.linalg.solve(np.eye(2) - R, q - R @ p)


def _distances(rows, start, goal):
    return np.linalg.norm(rows[:, :2] - _pole(start, goal), axis=1)


def _seen_from_the_pole(rows, start, goal, n):
    x, y = _pole(start, goal)
    distances = _distances(rows, start, goal)
    return (
        f"The pole is at ({x:.4g}, {y:.4g}); yours is {distances.min():.4g} to "
        f"{distances.max():.4g} m from it."
    )


def _fits(rows, path, start, goal):
    """Return whether the rows are right; with a tiny angle, to the digits that formulas with the
    pole leave."""
    fine = EXACT if _angle(start, goal) >= SMALL else HALF_THE_DIGITS
    return shared.deviation(rows, path) <= fine * shared.size(start, goal)


def _rows(T):
    return np.column_stack([T[:, :2, 2], np.arctan2(T[:, 1, 0], T[:, 0, 0])])


def _by_matrices(start, goal, n, product, s):
    """The poses product(T_start, T_goal, move), where move(T) is exp(s log(T)) for all s of
    s(u)."""

    def move(T):
        return exp_se2(np.multiply.outer(s(np.linspace(0, 1, n)), log_se2(T)))

    return _rows(product(pose_matrix(start), pose_matrix(goal), move))


EXERCISE = Exercise(
    name="interpolate_body_screw",
    points=2,
    sets=1,
    arguments=("start", "goal", "n"),
    tolerance=EXACT,
    cases=_cases,
    small=("start", "goal"),
    returns=shared.read_path,
    properties=(
        *shared.ENDS,
        shared.SHORTER_ARC,
        Property(
            "without rotation, x and y stay on the straight line from start to goal",
            shared.on_a_line,
            where=lambda start, goal, n: _angle(start, goal) == 0,
        ),
        Property(
            "the body rotates about one point, the pole, and stays at the same distance from it",
            lambda rows, start, goal, n: (
                np.ptp(_distances(rows, start, goal))
                <= EXACT * shared.size(start, goal) / _angle(start, goal)
            ),
            says=_seen_from_the_pole,
            where=_rotates,
            mistake=Mistake(
                "the path is not an arc about one point",
                "Which function of a twist gives the poses along an arc?",
            ),
        ),
        *shared.timed(by_screw, _fits),
    ),
    library=interpolate_body_screw,
    hints=(
        "T0 and T1 are given. What start sees of goal is T0^-1 T1.",
        "twist = rigid.log_se2(rigid.inverse(T0) @ T1) is the body's velocity, for one unit of s.",
        "T = T0 @ rigid.exp_se2(s * twist) for each s = 3 u^2 - 2 u^3; x and y are T[0, 2] and "
        "T[1, 2].",
        "theta is start[2] + s * twist[0], or np.arctan2(T[1, 0], T[0, 0]).",
    ),
    alike=shared.same_path,
    distance=shared.distance_of_rows(shared.BODY),
    sweeps=SWEEPS,
    forbidden=("course_lib.planar.interpolate_body_screw",),
)


def _screw(start, goal, n, s):
    """The path by one rotation."""
    return by_screw(start, goal, s, shared.change(start, goal)[2])


@EXERCISE.mistake(
    "x, y and theta are interpolated separately, so that the path is a straight line",
    "Here the velocity is constant in the body's frame. On which curve does such a body move?",
    difference=(shared.change, lambda start, goal: np.subtract(goal, start)),
)
def straight_line(start, goal, n, difference):
    return shared.straight(start, difference(start, goal), shared.scaling(n))


shared.add_path_mistakes(EXERCISE, _screw)


def _is_straight(rows, start, goal, n):
    """Return whether the path of a small rotation is straight, although it is an arc."""
    if not 0 < _angle(start, goal) < 0.1:
        return False
    path = shared.straight(start, shared.change(start, goal), shared.scaling(n))
    return shared.close(rows, path, start, goal)


@EXERCISE.mistake(
    "the path of a small rotation is a straight line",
    "The middle of an arc of length 8 m by 0.001 rad lies 1 mm from the straight line: below "
    "which angle does your function take a rotation for none?",
    seen=_is_straight,
)
def straight_if_small(start, goal, n):
    if not 1e-6 < _angle(start, goal) < 1e-2:
        return None
    return shared.straight(start, shared.change(start, goal), shared.scaling(n))


@EXERCISE.mistake(
    "the displacement is seen from a frame other than the one in which it is applied",
    "T_start^-1 T_goal leads from start to goal, seen from start: where does T_start stand in the "
    "product?",
    product=(
        lambda T0, T1, move: T0 @ move(T1 @ inverse(T0)),
        lambda T0, T1, move: move(inverse(T0) @ T1) @ T0,
        lambda T0, T1, move: T0 @ move(inverse(T1) @ T0),
        lambda T0, T1, move: move(inverse(T0) @ T1),
    ),
    s=(shared.cubic, lambda u: u),
)
def wrong_side(start, goal, n, product, s):
    return _by_matrices(start, goal, n, product, s)
