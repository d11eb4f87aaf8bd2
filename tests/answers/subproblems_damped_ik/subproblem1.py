"""What students write for subproblem1(k, p, g)."""

import math

import numpy as np
import scipy.optimize

from course_lib import subproblems
from course_lib.rotations import exp_so3, hat


def right_projected(k, p, g):
    a = p - (k @ p) * k
    b = g - (k @ g) * k
    return np.arctan2(k @ np.cross(a, b), a @ b)


def right_by_matrices(k, p, g):
    K = hat(k)
    return float(np.arctan2(g @ K @ p, -g @ K @ K @ p)) + 2 * np.pi


def right_by_components(k, p, g):
    dot = lambda u, v: sum(s * t for s, t in zip(u, v))
    u = [p[i] - dot(k, p) * k[i] for i in range(3)]
    v = [g[i] - dot(k, g) * k[i] for i in range(3)]
    sine = k[0] * (u[1] * v[2] - u[2] * v[1]) + k[1] * (u[2] * v[0] - u[0] * v[2]) + k[2] * (u[0] * v[1] - u[1] * v[0])
    return [math.atan2(sine, dot(u, v))]


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
    return angle if k @ np.cross(a, b) >= 0 else -angle


def right_least_squares_of_cosine_and_sine(k, p, g):
    A = np.column_stack([-np.cross(k, np.cross(k, p)), np.cross(k, p)])
    cosine, sine = np.linalg.pinv(A) @ (g - (k @ g) * k)
    return np.arctan2(sine, cosine)


def right_by_half_angles_of_the_directions(k, p, g):
    a, b = np.cross(k, p), np.cross(k, g)
    if not a.any() or not b.any():
        return 3
    a, b = a / np.linalg.norm(a), b / np.linalg.norm(b)
    angle = 2 * np.arctan2(np.linalg.norm(a - b), np.linalg.norm(a + b))
    return -angle if np.linalg.det([k, a, b]) < 0 else angle


def wrong_arccos_without_sign(k, p, g):
    """the sign is lost"""
    a, b = p - (k @ p) * k, g - (k @ g) * k
    lengths = np.linalg.norm(a) * np.linalg.norm(b)
    return np.arccos(np.clip(a @ b / lengths, -1, 1)) if lengths > 0 else 0.0


def wrong_length_of_the_cross_product(k, p, g):
    """the sign is lost"""
    a, b = p - (k @ p) * k, g - (k @ g) * k
    return np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b)


def wrong_not_projected(k, p, g):
    """not projected"""
    return np.arctan2(k @ np.cross(p, g), p @ g)


def wrong_not_projected_and_arccos(k, p, g):
    """not projected"""
    angle = np.arccos(np.clip(p @ g / np.linalg.norm(p) / np.linalg.norm(g), -1, 1))
    return angle if k @ np.cross(p, g) >= 0 else -angle


def wrong_arccos_not_clipped(k, p, g):
    """arccos is asked for a number above 1"""
    a, b = p - (k @ p) * k, g - (k @ g) * k
    lengths = np.linalg.norm(a) * np.linalg.norm(b)
    if lengths == 0:
        return 0.0
    angle = np.arccos(a @ b / lengths)
    return angle if k @ np.cross(a, b) >= 0 else -angle


def wrong_half_turn_by_sign(k, p, g):
    """np.sign(0) is 0"""
    a, b = p - (k @ p) * k, g - (k @ g) * k
    lengths = np.linalg.norm(a) * np.linalg.norm(b)
    if lengths == 0:
        return 0.0
    return np.sign(k @ np.cross(a, b)) * np.arccos(np.clip(a @ b / lengths, -1, 1))


def wrong_sign(k, p, g):
    """the sign is wrong"""
    a, b = p - (k @ p) * k, g - (k @ g) * k
    return np.arctan2(k @ np.cross(b, a), a @ b)


def wrong_arctan(k, p, g):
    """the angle is wrong beyond 90 degrees"""
    a, b = p - (k @ p) * k, g - (k @ g) * k
    return np.arctan(k @ np.cross(a, b) / (a @ b)) if a @ b else np.sign(k @ np.cross(a, b)) * np.pi / 2


def wrong_arcsin(k, p, g):
    """the angle is wrong beyond 90 degrees"""
    a, b = p - (k @ p) * k, g - (k @ g) * k
    lengths = np.linalg.norm(a) * np.linalg.norm(b)
    return np.arcsin(np.clip(k @ np.cross(a, b) / lengths, -1, 1)) if lengths else 0


def wrong_math_atan(k, p, g):
    """ZeroDivisionError"""
    a, b = p - (k @ p) * k, g - (k @ g) * k
    return math.atan(float(k @ np.cross(a, b)) / float(a @ b))


def wrong_degrees(k, p, g):
    """degrees"""
    a, b = p - (k @ p) * k, g - (k @ g) * k
    return np.degrees(np.arctan2(k @ np.cross(a, b), a @ b))


def wrong_k_ignored(k, p, g):
    """k is not used"""
    return np.arccos(np.clip(p @ g / (np.linalg.norm(p) * np.linalg.norm(g)), -1, 1))


def wrong_always_about_z(k, p, g):
    """k is not used"""
    return np.arctan2(g[1], g[0]) - np.arctan2(p[1], p[0])


def wrong_arctan2_swapped(k, p, g):
    """the arguments of arctan2 are swapped"""
    a, b = p - (k @ p) * k, g - (k @ g) * k
    return np.arctan2(a @ b, k @ np.cross(a, b))


def wrong_divided_on_the_axis(k, p, g):
    """the length of the part perpendicular to the axis is divided by"""
    a, b = p - (k @ p) * k, g - (k @ g) * k
    a, b = a / np.linalg.norm(a), b / np.linalg.norm(b)
    return np.arctan2(k @ np.cross(a, b), a @ b)


def wrong_lengths_not_divided(k, p, g):
    """not divided out before arccos"""
    a, b = p - (k @ p) * k, g - (k @ g) * k
    angle = np.arccos(np.clip(a @ b, -1, 1))
    return angle if k @ np.cross(a, b) >= 0 else -angle


def wrong_none_where_missed(k, p, g):
    """a return is missing"""
    theta = right_projected(k, p, g)
    if np.allclose(exp_so3(theta * k) @ p, g):
        return theta


def wrong_nan_where_missed(k, p, g):
    """nothing is returned where no angle"""
    theta = right_projected(k, p, g)
    return theta if np.allclose(exp_so3(theta * k) @ p, g) else np.nan


def wrong_halved(k, p, g):
    """the angle is halved"""
    a, b = p - (k @ p) * k, g - (k @ g) * k
    return np.arctan2(k @ np.cross(a, b), a @ b) / 2


def wrong_the_matrix(k, p, g):
    """another form"""
    return exp_so3(right_projected(k, p, g) * k)


def wrong_local_search(k, p, g):
    """unnamed"""
    return scipy.optimize.minimize_scalar(
        lambda t: np.linalg.norm(exp_so3(t * k) @ p - g), bounds=(0, np.pi), method="bounded"
    ).x


def wrong_changed_in_place(k, p, g):
    """p is changed in place"""
    p -= (k @ p) * k
    return np.arctan2(k @ np.cross(p, g), p @ g)


def wrong_projected_once_too_little(k, p, g):
    """unnamed"""
    a = p - k
    return np.arctan2(k @ np.cross(a, g), a @ g)


def wrong_the_librarys(k, p, g):
    """course_lib.subproblems.subproblem1 is called"""
    return float(subproblems.subproblem1(k, p, g).theta)


def wrong_only_p_projected(k, p, g):
    """only one of the two points is projected"""
    p_across = p - (k @ p) * k
    return np.arctan2(k @ np.cross(p_across, g), np.linalg.norm(p_across) * np.linalg.norm(g))


def wrong_zero_if_out_of_reach(k, p, g):
    """0 is returned where no angle"""
    if abs(np.linalg.norm(p) - np.linalg.norm(g)) > 1e-9 or abs(k @ (p - g)) > 1e-9:
        return 0.0
    return np.arctan2(k @ np.cross(p, g), (p - (k @ p) * k) @ g)


def wrong_bare_arccos(k, p, g):
    """the sign is lost"""
    p_across, g_across = p - (k @ p) * k, g - (k @ g) * k
    return np.arccos(p_across @ g_across / np.linalg.norm(p_across) / np.linalg.norm(g_across))


def wrong_arccos_with_its_sign(k, p, g):
    """arccos is asked for a number above 1"""
    p_across, g_across = p - (k @ p) * k, g - (k @ g) * k
    angle = np.arccos(p_across @ g_across / np.linalg.norm(p_across) / np.linalg.norm(g_across))
    return angle if k @ np.cross(p, g) >= 0 else -angle
