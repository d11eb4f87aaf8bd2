"""What students write for is_valid(X, kind, tol)."""

import numpy as np


def _so(R, tol):
    return (
        R.shape in ((2, 2), (3, 3))
        and np.abs(R.T @ R - np.eye(len(R))).max() <= tol
        and abs(np.linalg.det(R) - 1) <= tol
    )


def _se(T, tol):
    return (
        T.shape in ((3, 3), (4, 4))
        and _so(T[:-1, :-1], tol)
        and np.abs(T[-1] - np.eye(len(T))[-1]).max() <= tol
    )


def _q(q, tol):
    return q.shape in ((4,), (4, 1)) and abs(np.linalg.norm(q) - 1) <= tol


def right_three_helpers(X, kind, tol):
    return {"rotation": _so, "pose": _se, "quaternion": _q}[kind](X, tol)


def right_one_function_that_calls_itself(X, kind, tol):
    if kind == "quaternion":
        return X.shape in [(4,), (4, 1)] and bool(
            np.isclose(np.linalg.norm(X), 1, rtol=0, atol=tol)
        )
    n = len(X) - (kind == "pose")
    if X.ndim != 2 or X.shape[0] != X.shape[1] or n not in (2, 3):
        return False
    if kind == "pose":
        return is_last_row(X, tol) and right_one_function_that_calls_itself(
            X[:n, :n], "rotation", tol
        )
    return bool(
        np.allclose(X.T @ X, np.eye(n), rtol=0, atol=tol)
        and np.isclose(np.linalg.det(X), 1, rtol=0, atol=tol)
    )


def is_last_row(T, tol):
    return np.allclose(T[-1], [0] * (len(T) - 1) + [1], rtol=0, atol=tol)


def right_by_einsum(X, kind, tol):
    if kind == "rotation" and X.shape in ((2, 2), (3, 3)):
        return (
            np.abs(np.einsum("ki,kj", X, X) - np.eye(len(X))).max()
            <= tol
            >= abs(np.linalg.det(X) - 1)
        )
    return np.bool_(right_three_helpers(X, kind, tol))


def wrong_tolerance_never_zero(X, kind, tol):
    """the answers to some inputs only are wrong"""
    return right_three_helpers(X, kind, max(tol, 1e-12))


def wrong_three_indices_not_foreseen(X, kind, tol):
    """ValueError"""
    if kind != "quaternion" and X.ndim > 1:
        rows, columns = X.shape
        if rows != columns:
            return False
    return right_three_helpers(X, kind, tol)
