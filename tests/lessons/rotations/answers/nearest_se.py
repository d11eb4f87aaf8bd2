"""What students write for nearest_se(T)."""

import numpy as np
import scipy.linalg


def nearest_so(M):
    U, _, Vt = np.linalg.svd(M)
    U[:, -1] *= np.linalg.det(U @ Vt)
    return U @ Vt


def right_copy_and_block(T):
    X = T.astype(float)
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


def wrong_copy_of_whole_numbers(T):
    """digits after the point are cut off"""
    X = T.copy()
    X[:-1, :-1] = nearest_so(T[:-1, :-1])
    X[-1] = np.eye(len(T))[-1]
    return X


def wrong_nearly_a_pose_left_as_it_is(T):
    """T is returned as it came"""
    X = right_copy_and_block(T)
    return T if np.allclose(X, T, rtol=0, atol=1e-6) else X
