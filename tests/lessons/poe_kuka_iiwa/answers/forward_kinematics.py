"""What students write for forward_kinematics(screws, M, q)."""

from functools import reduce

import numpy as np
import scipy.linalg

from course_lib.rigid import exp_se3, hat_se3


def right_loop(screws, M, q):
    T = np.eye(4)
    for S, angle in zip(screws, q):
        T = T @ exp_se3(S * angle)
    return T @ M


def right_by_series_of_matrices(screws, M, q):
    return reduce(
        np.matmul, [scipy.linalg.expm(hat_se3(S) * angle) for S, angle in zip(screws, q)] + [M]
    )


def right_points_and_rotations_apart(screws, M, q):
    R, p = M[:3, :3], M[:3, 3]
    for S, angle in list(zip(screws, q))[::-1]:
        w, v = S[:3], S[3:]
        q = np.cross(w, v)
        turn = lambda x: (
            np.cos(angle) * x + np.sin(angle) * np.cross(w, x) + (1 - np.cos(angle)) * (w @ x) * w
        )
        R, p = np.column_stack([turn(column) for column in R.T]), q + turn(p - q)
    return [[*R[0], p[0]], [*R[1], p[1]], [*R[2], p[2]], [0, 0, 0, 1]]


def wrong_small_angles_left_out(screws, M, q):
    """small angles are left out"""
    T = np.eye(4)
    for screw, angle in zip(screws, q, strict=True):
        if abs(angle) > 1e-4:
            T = T @ exp_se3(screw * angle)
    return T @ M
