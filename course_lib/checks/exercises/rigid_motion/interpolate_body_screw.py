"""interpolate_body_screw: from pose to pose with a velocity that is constant in the body's frame."""

import numpy as np

from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.exercises.rigid_motion.interpolate_body import between, plain_cases, rotating_cases
from course_lib.checks.exercises.rigid_motion.interpolate_body_screw_mistakes import MISTAKES, SMALL, by_screw, rotation
from course_lib.checks.exercises.rigid_motion.shared import (
    ENDS,
    SHORTER_ARC,
    change,
    deviation,
    on_a_line,
    one_arc_is_shorter,
    read_path,
    same_path,
    size,
    timed,
)
from course_lib.planar import interpolate_body_screw


def _cases(rng):
    tiny = [between(rng, 0.8, 0.8 + angle, 5) for angle in (1e-3, -1e-12)]
    return plain_cases(rng) + rotating_cases(rng) + tiny


def _angle(start, goal):
    return abs(change(start, goal)[2])


def _rotates(start, goal, n):
    """Return whether there is a rotation that is not tiny."""
    return _angle(start, goal) >= SMALL and one_arc_is_shorter(start, goal, n)


def _pole(start, goal):
    """The point that the displacement from start to goal leaves where it is."""
    R = rotation(goal[2] - start[2])
    p, q = np.array(start, float)[:2], np.array(goal, float)[:2]
    return np.linalg.solve(np.eye(2) - R, q - R @ p)


def _distances(rows, start, goal):
    return np.linalg.norm(rows[:, :2] - _pole(start, goal), axis=1)


def _seen_from_the_pole(rows, start, goal, n):
    x, y = _pole(start, goal)
    distances = _distances(rows, start, goal)
    return f"The pole is at ({x:.4g}, {y:.4g}); yours is {distances.min():.4g} to {distances.max():.4g} m from it."


def _fits(rows, path, start, goal):
    """Return whether the rows are right; with a tiny angle, to the digits that formulas with the pole leave."""
    fine = 1e-9 if _angle(start, goal) >= SMALL else 1e-7
    return deviation(rows, path) <= fine * size(start, goal)


EXERCISE = Exercise(
    name="interpolate_body_screw",
    points=2,
    arguments=("start", "goal", "n"),
    cases=_cases,
    returns=read_path,
    properties=(
        *ENDS,
        SHORTER_ARC,
        Property(
            "without rotation, x and y stay on the straight line from start to goal",
            on_a_line,
            where=lambda start, goal, n: _angle(start, goal) == 0,
        ),
        Property(
            "the body rotates about one point, the pole, and stays at the same distance from it",
            lambda rows, start, goal, n: (
                np.ptp(_distances(rows, start, goal)) <= 1e-9 * size(start, goal) / _angle(start, goal)
            ),
            says=_seen_from_the_pole,
            where=_rotates,
        ),
        *timed(by_screw, _fits),
    ),
    mistakes=MISTAKES,
    library=interpolate_body_screw,
    hints=(
        "As matrices: T0 = pose_matrix(start) and T1 = pose_matrix(goal). What start sees of goal is T0^-1 T1.",
        "twist = rigid.log_se2(rigid.inverse(T0) @ T1) is the body's velocity, for one unit of s.",
        "T = T0 @ rigid.exp_se2(s * twist) for each s = 3 u^2 - 2 u^3; x and y are T[0, 2] and T[1, 2].",
        "theta is start[2] + s * twist[0], or np.arctan2(T[1, 0], T[0, 0]).",
    ),
    alike=same_path,
    forbidden=("course_lib.planar.interpolate_body_screw",),
)
