"""What students write for space_jacobian(screws, q)."""

import numpy as np

from course_lib.rigid import adjoint, exp_se3, hat_se3
from course_lib.rotations import exp_so3


def right_column_by_column(screws, q):
    T, columns = np.eye(4), []
    for S, angle in zip(screws, q):
        columns.append(adjoint(T) @ S)
        T = T @ exp_se3(S * angle)
    return np.column_stack(columns)


def right_by_conjugation(screws, q):
    T, J = np.eye(4), []
    for S, angle in zip(screws, q):
        V = T @ hat_se3(S) @ np.linalg.inv(T)
        J.append((V[2, 1], V[0, 2], V[1, 0], *V[:3, 3]))
        T = T @ exp_se3(S * angle)
    return list(zip(*J))


def right_points_and_directions(screws, q):
    omega, points = (
        screws[:, :3].astype(float),
        np.cross(screws[:, :3], screws[:, 3:]).astype(float),
    )
    for i in range(len(q)):
        R = exp_so3(omega[i] * q[i])
        omega[i + 1 :] = omega[i + 1 :] @ R.T
        points[i + 1 :] = points[i] + (points[i + 1 :] - points[i]) @ R.T
    return np.vstack([omega.T, np.cross(points, omega).T])


def wrong_last_column_only(screws, q):
    """one column is returned"""
    return right_column_by_column(screws, q)[:, -1]
