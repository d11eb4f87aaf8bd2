"""What students write for lost_direction(J)."""

import numpy as np


def right_last_column_of_U(J):
    U, _, _ = np.linalg.svd(J)
    return U[:, -1]


def right_eigenvector_by_svd_of_J_JT(J):
    return -np.linalg.svd(J @ J.T)[0][:, 5]


def right_of_the_transpose_as_list(J):
    return np.linalg.svd(J.T)[2][-1].tolist()


def wrong_least_squares(J):
    """unnamed"""
    return np.linalg.pinv(J).sum(0)
