"""What students write for nearest_se(T)."""

import numpy as np
import scipy.linalg

import course_lib.rotations as r


def nearest_so(M):
    U, _, Vt = np.linalg.svd(M)
    U[:, -1] *= np.linalg.det(U @ Vt)
    return U @ Vt


def right_copy_and_block(T):
    X = T.copy()
    X[:-1, :-1] = nearest_so(T[:-1, :-1])
    X[-1, :-1] = 0
    X[-1, -1] = 1
    return X


def right_stacked(T):
    n = len(T) - 1
    top = np.hstack([nearest_so(T[:n, :n]), T[:n, n:]])
    return np.vstack([top, [0] * n + [1]]).tolist()


def right_built_on_the_identity(T):
    n = T.shape[0] - 1
    X = np.eye(n + 1)
    U, S, Vt = scipy.linalg.svd(T[:n, :n])
    sign = np.linalg.det(U) * np.linalg.det(Vt)
    X[:n, :n] = sum((sign if i == n - 1 else 1) * np.outer(U[:, i], Vt[i]) for i in range(n))
    for i in range(n):
        X[i, n] = T[i, n]
    return [list(row) for row in X]


def right_product_of_two(T):
    n = len(T) - 1
    turn, shift = np.eye(n + 1), np.eye(n + 1)
    R, P = scipy.linalg.polar(T[:n, :n])
    if np.linalg.det(R) < 0:
        v = np.linalg.eigh(P)[1][:, 0]
        R = R - 2 * np.outer(R @ v, v)
    turn[:n, :n] = R
    shift[:n, n] = T[:n, n]
    return shift @ turn + 0j


def _with_block(T, R):
    X = np.eye(len(T))
    X[:-1, :-1], X[:-1, -1] = R, T[:-1, -1]
    return X


def wrong_row_divided_by_its_last_entry(T):
    """T is divided by its last entry"""
    X = T / T[-1, -1]
    X[:-1, :-1] = nearest_so(X[:-1, :-1])
    return X


def wrong_translation_turned(T):
    """the translation is rotated with the block"""
    R = nearest_so(T[:-1, :-1])
    X = _with_block(T, R)
    X[:-1, -1] = R @ T[:-1, -1]
    return X


def wrong_translation_corrected_too(T):
    """the translation is changed"""
    R = nearest_so(T[:-1, :-1])
    X = _with_block(T, R)
    X[:-1, -1] = R @ np.linalg.pinv(T[:-1, :-1]) @ T[:-1, -1]
    return X


def wrong_columns_of_block_normalised(T):
    """the block is not a rotation"""
    return _with_block(T, T[:-1, :-1] / np.linalg.norm(T[:-1, :-1], axis=0))


def wrong_whole_matrix(T):
    """the whole of T is made a rotation"""
    U, S, Vt = np.linalg.svd(T)
    U[:, -1] *= np.linalg.det(U @ Vt)
    return U @ Vt


def wrong_as_published(T):
    """the last column of U V^T is negated"""
    U, S, Vt = np.linalg.svd(T[:-1, :-1])
    R = U @ Vt
    if np.linalg.det(R) < 0:
        R[:, -1] *= -1
    return _with_block(T, R)


def wrong_block_alone(T):
    """another form"""
    return nearest_so(T[:-1, :-1])


def wrong_space_only(T):
    """IndexError"""
    X = np.eye(4)
    X[:3, :3] = nearest_so(T[:3, :3])
    X[:3, 3] = T[:3, 3]
    return X


def wrong_in_place(T):
    """T is changed in place"""
    n = len(T) - 1
    T[:n, :n] = nearest_so(T[:n, :n])
    T[n] = np.eye(n + 1)[n]
    return T


def wrong_forgotten_return(T):
    """a return is missing"""
    X = T.copy()
    X[:-1, :-1] = nearest_so(T[:-1, :-1])
    X[-1] = np.eye(len(T))[-1]


def wrong_the_librarys(T):
    """course_lib.rotations.nearest_so is called"""
    return _with_block(T, r.nearest_so(T[:-1, :-1]))


def _near(M):
    U, _, Vt = np.linalg.svd(M)
    U[:, -1] *= np.linalg.det(U @ Vt)
    return U @ Vt


def wrong_last_column_written_anew(T):
    """the last row is not that of a pose"""
    X = T.copy()
    X[:-1, :-1] = _near(T[:-1, :-1])
    X[:, -1] = np.eye(len(T))[-1]
    return X


def wrong_block_of_three_always(T):
    """IndexError"""
    X = np.eye(len(T))
    X[:3, :3] = _near(T[:3, :3])
    X[:3, 3] = T[:3, 3]
    return X


def wrong_alias(T):
    """T is changed in place"""
    X = T
    X[:-1, :-1] = _near(X[:-1, :-1])
    X[-1] = np.eye(len(T))[-1]
    return X


def wrong_block_divided_by_its_determinant(T):
    """the block is not a rotation"""
    X = np.eye(len(T))
    X[:-1, :-1] = T[:-1, :-1] / np.linalg.norm(T[:-1, :-1])
    X[:-1, -1] = T[:-1, -1]
    return X


def wrong_translation_in_the_row(T):
    """the last row is not that of a pose"""
    X = np.eye(len(T))
    X[:-1, :-1] = _near(T[:-1, :-1])
    X[-1, :-1] = T[:-1, -1]
    return X


def wrong_row_of_zeros(T):
    """the last row is not that of a pose"""
    X = T.copy()
    X[:-1, :-1] = _near(T[:-1, :-1])
    X[-1] = 0
    return X
