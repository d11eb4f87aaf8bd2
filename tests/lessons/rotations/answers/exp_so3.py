"""What students write for exp_so3(w)."""

import numpy as np
import scipy.linalg

from course_lib.rotations import hat, rot_z


def right_rodrigues(w):
    angle = np.linalg.norm(w)
    if angle == 0:
        return np.eye(3)
    N = hat(w / angle)
    return np.eye(3) + np.sin(angle) * N + (1 - np.cos(angle)) * N @ N


def right_matrix_exponential(w):
    return scipy.linalg.expm(hat(w)).tolist()


def right_rotated_about_z_in_another_frame(w):
    angle = np.linalg.norm(w)
    if not angle:
        return np.eye(3, dtype=int)
    n = w / angle
    x = np.cross(n, np.eye(3)[np.argmin(abs(n))])
    x /= np.linalg.norm(x)
    frame = np.array([x, np.cross(n, x), n]).T
    return np.einsum("ij,jk,lk->il", frame, rot_z(angle), frame)


def wrong_cosine_alone(w):
    """the factor of [n]^2 is cos(a), and not 1 - cos(a)"""
    angle = np.linalg.norm(w)
    N = hat(w / angle) if angle else np.zeros((3, 3))
    return np.eye(3) + N * np.sin(angle) + N @ N * np.cos(angle)


def wrong_fourteen_terms(w):
    """the series of the exponential is cut after some terms"""
    R = term = np.eye(3)
    for k in range(1, 15):
        term = hat(w) @ term / k
        R = R + term
    return R
