"""What students write for lost_direction(J)."""

import numpy as np
import scipy.linalg


def right_last_column_of_U(J):
    U, _, _ = np.linalg.svd(J)
    return U[:, -1]


def right_eigenvector_by_svd_of_J_JT(J):
    return -np.linalg.svd(J @ J.T)[0][:, 5]


def right_of_the_transpose_as_list(J):
    return np.linalg.svd(J.T)[2][-1].tolist()


def right_scipys(J):
    U = scipy.linalg.svd(J)[0]
    return U[:, [5]]


def wrong_first_column(J):
    """the largest singular value"""
    return np.linalg.svd(J)[0][:, 0]


def wrong_row_of_U(J):
    """a row of U"""
    return np.linalg.svd(J)[0][-1]


def wrong_right_singular_vector(J):
    """joint velocities"""
    return np.linalg.svd(J)[2][-1]


def wrong_column_of_VT(J):
    """joint velocities"""
    return np.linalg.svd(J)[2][:, -1]


def wrong_thin_svd(J):
    """the last vector but one"""
    return np.linalg.svd(J, full_matrices=False)[0][:, -1]


def wrong_scaled(J):
    """scaled by its singular value"""
    U, s, _ = np.linalg.svd(J)
    return U[:, -1] * (s[5] if len(s) > 5 else 0)


def wrong_whole_U(J):
    """another form"""
    return np.linalg.svd(J)[0]


def wrong_singular_values(J):
    """the singular values are returned"""
    s = np.linalg.svd(J)[1]
    return np.append(s, np.zeros(6 - len(s)))


def wrong_null_space_of_J(J):
    """another form"""
    return scipy.linalg.null_space(J)[:, :0]


def wrong_least_squares(J):
    """unnamed"""
    return np.linalg.pinv(J).sum(0)


def wrong_index_by_rank(J):
    """the last vector but one"""
    U, s, _ = np.linalg.svd(J)
    return U[:, np.sum(s > 1e-3) - 1]
