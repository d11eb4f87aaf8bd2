"""What students write for tool_positions(screws, M, angles)."""

import numpy as np
import scipy.linalg

from course_lib.rigid import exp_se3, hat_se3


def right_M_at_the_end(screws, M, angles):
    path = []
    for q in angles:
        T = np.eye(4)
        for S, angle in zip(screws, q):
            T = T @ exp_se3(S * angle)
        path.append((T @ M)[:3, 3])
    return np.array(path)


def right_beginning_with_M(screws, M, angles):
    path = []
    for q in angles:
        x = M[:, 3]
        for i in reversed(range(len(q))):
            x = scipy.linalg.expm(hat_se3(screws[i]) * q[i]) @ x
        path.append(list(x[:3]))
    return path


def right_all_rows_at_once(screws, M, angles):
    x = np.tile(M[:, 3], (len(angles), 1))
    for i in range(len(screws) - 1, -1, -1):
        x = np.einsum("kij,kj->ki", exp_se3(angles[:, i, None] * screws[i]), x)
    return x[:, :3]


def wrong_z_left_out(screws, M, angles):
    """unnamed"""
    return right_M_at_the_end(screws, M, angles) * [1, 1, 0]
