"""What students write for subproblem1(k, p, g)."""

import math

import numpy as np

from course_lib.rotations import hat


def right_by_matrices(k, p, g):
    K = hat(k)
    return float(np.arctan2(g @ K @ p, -g @ K @ K @ p)) + 2 * np.pi


def right_in_a_frame_of_its_own(k, p, g):
    e = np.cross(k, np.eye(3)[np.argmin(abs(k))])
    f = np.cross(k, e)
    return np.array([[np.arctan2(f @ g, e @ g) - np.arctan2(f @ p, e @ p)]])


def right_arccos_with_a_sign(k, p, g):
    a, b = p - (k @ p) * k, g - (k @ g) * k
    lengths = np.linalg.norm(a) * np.linalg.norm(b)
    if lengths < 1e-12:
        return 0
    angle = np.arccos(np.clip(a @ b / lengths, -1, 1))
    return [angle if k @ np.cross(a, b) >= 0 else -angle]


def wrong_math_atan(k, p, g):
    """ZeroDivisionError"""
    a, b = p - (k @ p) * k, g - (k @ g) * k
    return math.atan(float(k @ np.cross(a, b)) / float(a @ b))


def wrong_points_near_the_axis(k, p, g):
    """the answers to some inputs only are wrong"""
    if np.linalg.norm(np.cross(k, p)) < 1e-6 or np.linalg.norm(np.cross(k, g)) < 1e-6:
        return 0.0
    return right_by_matrices(k, p, g)


def wrong_allclose_to_the_axis(k, p, g):
    """the answers to some inputs only are wrong"""
    a, b = p - (k @ p) * k, g - (k @ g) * k
    return 0.0 if np.allclose(a, 0) or np.allclose(b, 0) else right_by_matrices(k, p, g)


def wrong_parts_across_of_the_type_of_the_points(k, p, g):
    """the answer is wrong for arrays of integers only"""
    a, b = np.empty_like(p), np.empty_like(g)
    a[:], b[:] = p - (k @ p) * k, g - (k @ g) * k
    return np.arctan2(k @ np.cross(a, b), a @ b)
