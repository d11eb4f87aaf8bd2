"""What students write for exp_se3(twist)."""

import math

import numpy as np
import scipy.linalg

from course_lib.rotations import exp_so3, hat


def _matrix(R, p):
    return np.vstack([np.column_stack([R, p]), [0, 0, 0, 1]])


def right_series_below_1e_5(twist):
    W, v = hat(twist[:3]), twist[3:]
    if np.abs(twist[:3]).max() < 1e-5:
        return _matrix(np.eye(3) + W + W @ W / 2, v + W @ v / 2)
    a = np.linalg.norm(twist[:3])
    G = np.eye(3) * a + (1 - np.cos(a)) * W / a + (a - np.sin(a)) * W @ W / a**2
    return _matrix(exp_so3(twist[:3]), G @ v / a)


def _along_and_across(a, twist):
    n, v = twist[:3] / a, twist[3:]
    along = (n @ v) * n
    p = along + np.sin(a) / a * (v - along) + 2 * np.sin(a / 2) ** 2 / a * np.cross(n, v)
    return _matrix(exp_so3(twist[:3]), p).tolist()


def right_along_and_across_the_axis(twist):
    a = math.hypot(*twist[:3])
    return _along_and_across(a, twist) if a else _matrix(np.eye(3), twist[3:])


def right_matrix_exponential(twist):
    V = np.zeros((4, 4))
    V[:3, :3], V[:3, 3] = hat(twist[:3]), twist[3:]
    return scipy.linalg.expm(V).astype(complex)


def right_textbook_without_a_series(twist):
    """Its sideways step is 0 below 1.5e-8 rad, and so off by 7.5e-9 of v at most."""
    a, W = np.linalg.norm(twist[:3]), hat(twist[:3])
    if a == 0:
        return _matrix(np.eye(3), twist[3:])
    G = np.eye(3) + (1 - np.cos(a)) / a**2 * W + (a - np.sin(a)) / a**3 * W @ W
    return _matrix(exp_so3(twist[:3]), G @ twist[3:])


def right_v_below_1e_8(twist):
    """Its p is off by half of omega x v, which is 5e-9 of v at most."""
    if np.linalg.norm(twist[:3]) < 1e-8:
        return _matrix(exp_so3(twist[:3]), twist[3:])
    return right_along_and_across_the_axis(twist)


def wrong_v_below_1e_7(twist):
    """the answer is right to its first digits only"""
    if np.linalg.norm(twist[:3]) < 1e-7:
        return _matrix(exp_so3(twist[:3]), twist[3:])
    return right_along_and_across_the_axis(twist)


def wrong_origin_for_omega_zero(twist):
    """the answers to some inputs only are wrong"""
    T = right_matrix_exponential(twist)
    return (
        T if twist[:3].any() else _matrix(np.eye(3), twist[3:] / (np.linalg.norm(twist[3:]) or 1))
    )
