"""What students write for body_screws(screws, M)."""

import numpy as np

from course_lib.rigid import adjoint, inverse


def right_row_by_row(screws, M):
    return np.array([adjoint(inverse(M)) @ S for S in screws])


def right_at_once_as_lists(screws, M):
    return (np.linalg.inv(adjoint(M)) @ screws.T).T.tolist()


def right_by_directions_and_points(screws, M):
    R, p = M[:3, :3], M[:3, 3]
    omega, v = screws[:, :3], screws[:, 3:]
    return np.hstack([omega @ R, (v + np.cross(omega, p)) @ R])


def wrong_not_transposed_back(screws, M):
    """rows and columns have changed places"""
    return np.linalg.inv(adjoint(M)) @ screws.T


def wrong_v_sign(screws, M):
    """unnamed"""
    return right_row_by_row(screws, M) * [1, 1, 1, -1, -1, -1]
