"""What students write for inverse(T)."""

import numpy as np
import scipy.linalg

from course_lib import rigid


def right_textbook(T):
    R, p = T[:3, :3], T[:3, 3]
    X = np.eye(4)
    X[:3, :3], X[:3, 3] = R.T, -R.T @ p
    return X


def right_numpys(T):
    return np.linalg.inv(T)


def right_written_out(T):
    X = [[0.0] * 4 for _ in range(4)]
    for i in range(3):
        for j in range(3):
            X[i][j] = T[j, i]
            X[i][3] -= T[j, i] * T[j, 3]
    X[3][3] = 1
    return X


def right_solved(T):
    return scipy.linalg.solve(T, np.eye(4)).astype(complex)


def right_translation_undone_then_the_turn(T):
    back, turn = np.eye(4), np.eye(4)
    back[:3, 3] -= T[:3, 3]
    turn[:3, :3] = T[:3, :3].T
    return turn @ back


def right_cross_products(T):
    (x, y, z), p = T[:3, :3].T, T[:3, 3]
    rows = np.array([np.cross(y, z), np.cross(z, x), np.cross(x, y)])
    return np.vstack([np.c_[rows, [-row @ p for row in rows]], [0, 0, 0, 1]])


def wrong_transposed(T):
    """the whole of T is transposed"""
    return T.T


def wrong_as_it_is(T):
    """T itself is returned"""
    return T.copy()


def wrong_minus_T(T):
    """T changes its sign"""
    return -T


def wrong_entry_by_entry(T):
    """divided by zero"""
    return T**-1.0


def wrong_minus_p(T):
    """p changes its sign and is not turned"""
    X = np.eye(4)
    X[:3, :3], X[:3, 3] = T[:3, :3].T, -T[:3, 3]
    return X


def wrong_minus_missing(T):
    """the minus is missing"""
    X = np.eye(4)
    X[:3, :3], X[:3, 3] = T[:3, :3].T, T[:3, :3].T @ T[:3, 3]
    return X


def wrong_minus_R_p(T):
    """p is turned by R, not by R^T"""
    X = np.eye(4)
    X[:3, :3], X[:3, 3] = T[:3, :3].T, -T[:3, :3] @ T[:3, 3]
    return X


def wrong_p_from_the_left(T):
    """p is turned by R, not by R^T"""
    X = np.eye(4)
    X[:3, :3], X[:3, 3] = T[:3, :3].T, -T[:3, 3] @ T[:3, :3].T
    return X


def wrong_block_only(T):
    """p stays as it is"""
    X = T.copy()
    X[:3, :3] = T[:3, :3].T
    return X


def wrong_column_empty(T):
    """the column is left empty"""
    X = np.eye(4)
    X[:3, :3] = T[:3, :3].T
    return X


def wrong_R_not_transposed(T):
    """R is not transposed"""
    X = T.copy()
    X[:3, 3] = -T[:3, :3].T @ T[:3, 3]
    return X


def wrong_minus_p_alone(T):
    """R is not transposed"""
    X = T.copy()
    X[:3, 3] *= -1
    return X


def wrong_minus_R(T):
    """R changes its sign"""
    X = np.eye(4)
    X[:3, :3], X[:3, 3] = -T[:3, :3], -T[:3, 3]
    return X


def wrong_identity_block(T):
    """the block is the identity"""
    X = np.eye(4)
    X[:3, 3] = -T[:3, 3]
    return X


def wrong_product_entry_by_entry(T):
    """entry by entry"""
    X = np.eye(4)
    X[:3, :3], X[:3, 3] = T[:3, :3].T, np.sum(-T[:3, :3].T * T[:3, 3], axis=0)
    return X


def wrong_last_row_zero(T):
    """the last row is zero"""
    X = np.zeros((4, 4))
    X[:3, :3], X[:3, 3] = T[:3, :3].T, -T[:3, :3].T @ T[:3, 3]
    return X


def wrong_transposed_and_then_the_column(T):
    """the last row is that of the whole of T transposed"""
    X = T.T.copy()
    X[:3, 3] = -T[:3, :3].T @ T[:3, 3]
    return X


def wrong_three_rows(T):
    """the last row is missing"""
    R, p = T[:3, :3], T[:3, 3]
    return np.column_stack([R.T, -R.T @ p])


def wrong_column_overwritten_first(T):
    """unnamed"""
    X = T.copy()
    X[:3, 3] = -X[:3, :3].T @ X[:3, 3]
    X[:3, :3] = X[:3, :3].T + np.outer(X[:3, 3], X[:3, 3])
    return X


def wrong_in_place(T):
    """T is changed in place"""
    T[:3, :3] = T[:3, :3].T.copy()
    T[:3, 3] = -T[:3, :3] @ T[:3, 3]
    return T


def wrong_column_as_a_matrix(T):
    """ValueError"""
    X = np.eye(4)
    X[:3, :3], X[:3, 3] = T[:3, :3].T, -T[:3, :3].T @ T[:3, 3:]
    return X


def wrong_the_librarys(T):
    """course_lib.rigid.inverse is called"""
    return rigid.inverse(T)
