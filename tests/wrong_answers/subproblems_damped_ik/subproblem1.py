"""What students write for subproblem1(k, p, q)."""

import math

import numpy as np
import scipy.optimize

from course_lib import subproblems
from course_lib.rotations import exp_so3, hat


def right_projected(k, p, q):
    a = p - (k @ p) * k
    b = q - (k @ q) * k
    return np.arctan2(k @ np.cross(a, b), a @ b)


def right_by_matrices(k, p, q):
    K = hat(k)
    return float(np.arctan2(q @ K @ p, -q @ K @ K @ p)) + 2 * np.pi


def right_by_components(k, p, q):
    dot = lambda u, v: sum(s * t for s, t in zip(u, v))
    u = [p[i] - dot(k, p) * k[i] for i in range(3)]
    v = [q[i] - dot(k, q) * k[i] for i in range(3)]
    sine = k[0] * (u[1] * v[2] - u[2] * v[1]) + k[1] * (u[2] * v[0] - u[0] * v[2]) + k[2] * (u[0] * v[1] - u[1] * v[0])
    return [math.atan2(sine, dot(u, v))]


def right_in_a_frame_of_its_own(k, p, q):
    e = np.cross(k, np.eye(3)[np.argmin(abs(k))])
    f = np.cross(k, e)
    return np.array([[np.arctan2(f @ q, e @ q) - np.arctan2(f @ p, e @ p)]])


def right_arccos_with_a_sign(k, p, q):
    a, b = p - (k @ p) * k, q - (k @ q) * k
    lengths = np.linalg.norm(a) * np.linalg.norm(b)
    if lengths < 1e-12:
        return 0
    angle = np.arccos(np.clip(a @ b / lengths, -1, 1))
    return angle if k @ np.cross(a, b) >= 0 else -angle


def right_least_squares_of_cosine_and_sine(k, p, q):
    A = np.column_stack([-np.cross(k, np.cross(k, p)), np.cross(k, p)])
    cosine, sine = np.linalg.pinv(A) @ (q - (k @ q) * k)
    return np.arctan2(sine, cosine)


def right_by_half_angles_of_the_directions(k, p, q):
    a, b = np.cross(k, p), np.cross(k, q)
    if not a.any() or not b.any():
        return 3
    a, b = a / np.linalg.norm(a), b / np.linalg.norm(b)
    angle = 2 * np.arctan2(np.linalg.norm(a - b), np.linalg.norm(a + b))
    return -angle if np.linalg.det([k, a, b]) < 0 else angle


def wrong_arccos_without_sign(k, p, q):
    """the sign is lost"""
    a, b = p - (k @ p) * k, q - (k @ q) * k
    lengths = np.linalg.norm(a) * np.linalg.norm(b)
    return np.arccos(np.clip(a @ b / lengths, -1, 1)) if lengths > 0 else 0.0


def wrong_length_of_the_cross_product(k, p, q):
    """the sign is lost"""
    a, b = p - (k @ p) * k, q - (k @ q) * k
    return np.arctan2(np.linalg.norm(np.cross(a, b)), a @ b)


def wrong_not_projected(k, p, q):
    """not projected"""
    return np.arctan2(k @ np.cross(p, q), p @ q)


def wrong_not_projected_and_arccos(k, p, q):
    """not projected"""
    angle = np.arccos(np.clip(p @ q / np.linalg.norm(p) / np.linalg.norm(q), -1, 1))
    return angle if k @ np.cross(p, q) >= 0 else -angle


def wrong_arccos_not_clipped(k, p, q):
    """asked outside its domain"""
    a, b = p - (k @ p) * k, q - (k @ q) * k
    lengths = np.linalg.norm(a) * np.linalg.norm(b)
    if lengths == 0:
        return 0.0
    angle = np.arccos(a @ b / lengths)
    return angle if k @ np.cross(a, b) >= 0 else -angle


def wrong_half_turn_by_sign(k, p, q):
    """np.sign(0) is 0"""
    a, b = p - (k @ p) * k, q - (k @ q) * k
    lengths = np.linalg.norm(a) * np.linalg.norm(b)
    if lengths == 0:
        return 0.0
    return np.sign(k @ np.cross(a, b)) * np.arccos(np.clip(a @ b / lengths, -1, 1))


def wrong_sign(k, p, q):
    """the sign is wrong"""
    a, b = p - (k @ p) * k, q - (k @ q) * k
    return np.arctan2(k @ np.cross(b, a), a @ b)


def wrong_arctan(k, p, q):
    """arctan and arcsin end there"""
    a, b = p - (k @ p) * k, q - (k @ q) * k
    return np.arctan(k @ np.cross(a, b) / (a @ b)) if a @ b else np.sign(k @ np.cross(a, b)) * np.pi / 2


def wrong_arcsin(k, p, q):
    """arctan and arcsin end there"""
    a, b = p - (k @ p) * k, q - (k @ q) * k
    lengths = np.linalg.norm(a) * np.linalg.norm(b)
    return np.arcsin(np.clip(k @ np.cross(a, b) / lengths, -1, 1)) if lengths else 0


def wrong_math_atan(k, p, q):
    """ZeroDivisionError"""
    a, b = p - (k @ p) * k, q - (k @ q) * k
    return math.atan(float(k @ np.cross(a, b)) / float(a @ b))


def wrong_degrees(k, p, q):
    """degrees"""
    a, b = p - (k @ p) * k, q - (k @ q) * k
    return np.degrees(np.arctan2(k @ np.cross(a, b), a @ b))


def wrong_k_ignored(k, p, q):
    """k is not used"""
    return np.arccos(np.clip(p @ q / (np.linalg.norm(p) * np.linalg.norm(q)), -1, 1))


def wrong_always_about_z(k, p, q):
    """k is not used"""
    return np.arctan2(q[1], q[0]) - np.arctan2(p[1], p[0])


def wrong_arctan2_swapped(k, p, q):
    """the arguments of arctan2 are swapped"""
    a, b = p - (k @ p) * k, q - (k @ q) * k
    return np.arctan2(a @ b, k @ np.cross(a, b))


def wrong_divided_on_the_axis(k, p, q):
    """the length of the part across the axis is divided by"""
    a, b = p - (k @ p) * k, q - (k @ q) * k
    a, b = a / np.linalg.norm(a), b / np.linalg.norm(b)
    return np.arctan2(k @ np.cross(a, b), a @ b)


def wrong_lengths_not_divided(k, p, q):
    """not divided out before arccos"""
    a, b = p - (k @ p) * k, q - (k @ q) * k
    angle = np.arccos(np.clip(a @ b, -1, 1))
    return angle if k @ np.cross(a, b) >= 0 else -angle


def wrong_none_where_missed(k, p, q):
    """a return is missing"""
    theta = right_projected(k, p, q)
    if np.allclose(exp_so3(theta * k) @ p, q):
        return theta


def wrong_nan_where_missed(k, p, q):
    """something is divided by zero"""
    theta = right_projected(k, p, q)
    return theta if np.allclose(exp_so3(theta * k) @ p, q) else np.nan


def wrong_halved(k, p, q):
    """the angle is halved"""
    a, b = p - (k @ p) * k, q - (k @ q) * k
    return np.arctan2(k @ np.cross(a, b), a @ b) / 2


def wrong_the_matrix(k, p, q):
    """another form"""
    return exp_so3(right_projected(k, p, q) * k)


def wrong_local_search(k, p, q):
    """unnamed"""
    return scipy.optimize.minimize_scalar(
        lambda t: np.linalg.norm(exp_so3(t * k) @ p - q), bounds=(0, np.pi), method="bounded"
    ).x


def wrong_changed_in_place(k, p, q):
    """p is changed in place"""
    p -= (k @ p) * k
    return np.arctan2(k @ np.cross(p, q), p @ q)


def wrong_projected_once_too_little(k, p, q):
    """unnamed"""
    a = p - k
    return np.arctan2(k @ np.cross(a, q), a @ q)


def wrong_the_librarys(k, p, q):
    """course_lib.subproblems.subproblem1 is called"""
    return float(subproblems.subproblem1(k, p, q).theta)
