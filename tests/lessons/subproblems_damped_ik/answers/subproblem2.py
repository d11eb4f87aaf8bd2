"""What students write for subproblem2(k1, k2, p1, p2)."""

import math

import numpy as np

from course_lib.lessons.subproblems_damped_ik.exercises.shared import angle_about as turn
from course_lib.lessons.subproblems_damped_ik.exercises.shared import rotated


def _parts(k1, k2, p1, p2):
    """a, b and c squared of the meeting points z = a k1 + b k2 +- c k1 x k2."""
    m, h1, h2 = k1 @ k2, k1 @ p1, k2 @ p2
    a, b = (h1 - m * h2) / (1 - m**2), (h2 - m * h1) / (1 - m**2)
    return a, b, (p1 @ p1 - a**2 - b**2 - 2 * a * b * m) / (1 - m**2)


def _through(a, b, c, k1, k2, p1, p2):
    points = [a * k1 + b * k2 + s * c * np.cross(k1, k2) for s in (1, -1)]
    return [(turn(k1, p1, z), turn(k2, p2, z)) for z in points]


def right_by_subproblem_four(k1, k2, p1, p2):
    """The height of R1 p1 along k2 is that of p2; then theta2 follows."""
    A, B = -k2 @ np.cross(k1, np.cross(k1, p1)), k2 @ np.cross(k1, p1)
    C = k2 @ p2 - (k1 @ k2) * (k1 @ p1)
    if abs(C) > np.hypot(A, B):
        return ()
    middle, aside = math.atan2(B, A), math.acos(C / math.hypot(A, B))
    return tuple(
        [t1, float(turn(k2, p2, rotated(k1, t1, p1)))] for t1 in (middle + aside, middle - aside)
    )


def right_solve_in_a_frame(k1, k2, p1, p2):
    z0 = np.linalg.lstsq(np.array([k1, k2]), np.array([k1 @ p1, k2 @ p2]), rcond=None)[0]
    left = p1 @ p1 - z0 @ z0
    if left < 0:
        return np.empty((0, 2))
    n = np.cross(k1, k2)
    step = np.sqrt(left) * n / np.linalg.norm(n)
    return np.array(
        [[turn(k1, p1, z), turn(k2, p2, z) - 2 * np.pi] for z in (z0 - step, z0 + step)]
    )


def right_that_compares_lengths_and_lets_rounding_touch(k1, k2, p1, p2):
    a, b, square = _parts(k1, k2, p1, p2)
    if abs(np.sqrt(p1 @ p1) - np.sqrt(p2 @ p2)) > 1e-9 or square < -1e-9 * (p1 @ p1):
        return []
    return [
        np.array([[t1], [t2]]) for t1, t2 in _through(a, b, np.sqrt(max(square, 0)), k1, k2, p1, p2)
    ]


def wrong_nearest_where_they_miss(k1, k2, p1, p2):
    """a pair is returned although the circles miss"""
    a, b, square = _parts(k1, k2, p1, p2)
    return _through(a, b, np.sqrt(max(square, 0)), k1, k2, p1, p2)


def wrong_circles_that_nearly_touch(k1, k2, p1, p2):
    """only one of the two solutions is returned"""
    a, b, square = _parts(k1, k2, p1, p2)
    pairs = right_solve_in_a_frame(k1, k2, p1, p2)
    return pairs[:1] if square < 1e-8 * (p1 @ p1) else pairs


def wrong_pairs_that_are_nearly_the_same(k1, k2, p1, p2):
    """only one of the two solutions is returned"""
    pairs = right_by_subproblem_four(k1, k2, p1, p2)
    merge = len(pairs) == 2 and np.allclose(pairs[0], pairs[1], atol=1e-4)
    return pairs[:1] if merge else pairs


def wrong_nearly_parallel_axes(k1, k2, p1, p2):
    """the list is empty although there are solutions"""
    is_parallel = np.linalg.norm(np.cross(k1, k2)) < 0.02
    return [] if is_parallel else right_solve_in_a_frame(k1, k2, p1, p2)


def wrong_small_circles_that_nearly_touch(k1, k2, p1, p2):
    """the list is empty although there are solutions"""
    a, b, c_squared = _parts(k1, k2, p1, p2)
    return [] if c_squared < 1e-12 else right_solve_in_a_frame(k1, k2, p1, p2)


def wrong_without_the_mixed_term(k1, k2, p1, p2):
    """|a k1 + b k2|^2 is taken for a^2 + b^2"""
    a, b, _ = _parts(k1, k2, p1, p2)
    c_squared = (p1 @ p1 - a**2 - b**2) / (1 - (k1 @ k2) ** 2)
    return _through(a, b, math.sqrt(c_squared), k1, k2, p1, p2) if c_squared > 0 else []
