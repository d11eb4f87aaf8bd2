"""interpolate_body_screw: from pose to pose with a velocity that is constant in the body's
frame."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.kinds import OWN_CASES
from course_lib.checks.mistake import Mistake
from course_lib.checks.tolerances import EXACT, HALF_THE_DIGITS
from course_lib.lessons.rigid_motion.exercises import shared
from course_lib.lessons.rigid_motion.exercises.interpolate_body import (
    SWEEPS,
    between,
    plain_cases,
    rotating_cases,
    special,
)
from course_lib.planar import interpolate_body_screw, pose_matrix
from course_lib.rigid import exp_se2, inverse, log_se2

# radians: with an angle below that, the pole is far away, and formulas with it may lose digits
SMALL = 1e-2
_NO_ARC = Mistake(
    "the path is not an arc about one point",
    "Which function of a twist gives the poses along an arc?",
)


def _cases(rng):
    tiny = [between(rng, 0.8, 0.8 + angle, 5) for angle in (1e-3, -1e-12)]
    return plain_cases(rng) + rotating_cases(rng) + tiny


def _angle(start, goal):
    return abs(shared.change(start, goal)[2])


def _allowed(start, goal, n):
    fine = EXACT if _angle(start, goal) >= SMALL else HALF_THE_DIGITS
    return fine * shared.size(start, goal)


def _pole(start, goal):
    """Return the point that the displacement from start to goal leaves where it is."""
    R = pose_matrix([0, 0, goal[2] - start[2]])[:2, :2]
    p, q = np.array(start, float)[:2], np.array(goal, float)[:2]
    return np.linalg.solve(np.eye(2) - R, q - R @ p)


def _distances(rows, start, goal):
    return np.linalg.norm(rows[:, :2] - _pole(start, goal), axis=1)


def _found(rows, start, goal, n):
    said = shared.first_wrong_row(interpolate_body_screw)(rows, start, goal, n)
    if _angle(start, goal) < SMALL:
        return said
    x, y = _pole(start, goal)
    distances = _distances(rows, start, goal)
    return (
        f"{said} The pole, about which the body rotates, is at ({x:.4g}, {y:.4g}); your rows are "
        f"{distances.min():.4g} to {distances.max():.4g} m from it."
    )


def _otherwise(rows, start, goal, n):
    """Return the Mistake of a path on the longer arc, or about no pole; None for another."""
    longer = shared.longer_arc(rows, start, goal, n)
    if longer or _angle(start, goal) < SMALL:
        return longer
    off = np.ptp(_distances(rows, start, goal))
    is_arc = off <= EXACT * shared.size(start, goal) / _angle(start, goal)
    return None if is_arc else _NO_ARC


def _is_straight(rows, start, goal, n):
    """Return whether the path of a small rotation is straight, although it is an arc."""
    if not 0 < _angle(start, goal) < 0.1:
        return False
    path = shared.straight(start, shared.change(start, goal), shared.scaling(n))
    return shared.deviation(rows, path) <= EXACT * shared.size(start, goal)


def _screw(start, goal, n, s):
    """Return the rows on the right path at these parts s of the way."""
    twist = log_se2(inverse(pose_matrix(start)) @ pose_matrix(goal))
    T = pose_matrix(start) @ exp_se2(np.multiply.outer(s, twist))
    return np.column_stack([T[:, :2, 2], start[2] + s * twist[0]])


def _straight_line(difference):
    return lambda start, goal, n: shared.straight(start, difference(start, goal), shared.scaling(n))


def _straight_if_small(start, goal, n):
    if not 1e-6 < _angle(start, goal) < SMALL:
        return None
    return shared.straight(start, shared.change(start, goal), shared.scaling(n))


def _by_arctan2(T):
    return np.arctan2(T[:, 1, 0], T[:, 0, 0])


def _by_arccos(T):
    return np.arccos(np.clip(T[:, 0, 0], -1, 1))


def _by_matrices(product, s=shared.cubic, angle=_by_arctan2):
    """Return the answer with the poses product(T_start, T_goal, move), where move(T) is exp(s(u)
    log(T)) for all u."""

    def answer(start, goal, n):
        def move(T):
            return exp_se2(np.multiply.outer(s(np.linspace(0, 1, n)), log_se2(T)))

        T = product(pose_matrix(start), pose_matrix(goal), move)
        return np.column_stack([T[:, :2, 2], angle(T)])

    return answer


def _right_product(T0, T1, move):
    return T0 @ move(inverse(T0) @ T1)


_WRONG_PRODUCTS = (
    lambda T0, T1, move: T0 @ move(T1 @ inverse(T0)),
    lambda T0, T1, move: move(inverse(T0) @ T1) @ T0,
    lambda T0, T1, move: T0 @ move(inverse(T1) @ T0),
    lambda T0, T1, move: move(inverse(T0) @ T1),
)


EXERCISE = declared(
    "interpolate_body_screw",
    points=2,
    sets=1,
    arguments={
        "start": OWN_CASES.but(small=True, free=True),
        "goal": OWN_CASES.but(small=True, free=True),
        "n": OWN_CASES.but(free=True),
    },
    cases=_cases,
    sweeps=SWEEPS,
    special=special,
    tolerance=EXACT,
    allowed=_allowed,
    library=interpolate_body_screw,
    alike=shared.same_path,
    distance=shared.distance_of_paths,
    says="at evenly spaced u from 0 to 1, the body has made the part s = 3 u^2 - 2 u^3 of one "
    "rotation about a fixed point, the pole, or of one translation if start and goal are parallel",
    found=_found,
    otherwise=_otherwise,
    hints=(
        "T0 and T1 are given. What start sees of goal is T0^-1 T1.",
        "twist = rigid.log_se2(rigid.inverse(T0) @ T1) is the body's velocity, for one unit of s.",
        "T = T0 @ rigid.exp_se2(s * twist) for each s = 3 u^2 - 2 u^3; x and y are T[0, 2] and "
        "T[1, 2].",
        "theta is start[2] + s * twist[0], or np.arctan2(T[1, 0], T[0, 0]).",
    ),
    forbidden=("course_lib.planar.interpolate_body_screw",),
    mistakes=(
        shared.MATRICES,
        *shared.path_mistakes(_screw),
        Mistake(
            "x, y and theta are interpolated separately, so that the path is a straight line",
            "Here the velocity is constant in the body's frame. On which curve does such a body "
            "move?",
            _straight_line(shared.change),
            _straight_line(lambda start, goal: np.subtract(goal, start)),
        ),
        Mistake(
            "the path of a small rotation is a straight line",
            "The middle of an arc of length 8 m by 0.001 rad lies 1 mm from the straight line: "
            "below which angle does your function take a rotation for none?",
            _straight_if_small,
            seen=_is_straight,
        ),
        Mistake(
            "the displacement is seen from a frame other than the one in which it is applied",
            "T_start^-1 T_goal leads from start to goal, seen from start: where does T_start stand "
            "in the product?",
            *map(_by_matrices, _WRONG_PRODUCTS),
        ),
        shared.lost_sign(_by_matrices(_right_product, angle=_by_arccos)),
    ),
)
