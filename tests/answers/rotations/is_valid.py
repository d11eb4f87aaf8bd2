"""What students write for is_valid(X, kind, tol)."""

import math

import numpy as np

from course_lib import rotations


def _so(R, tol):
    return (
        R.shape in ((2, 2), (3, 3))
        and np.abs(R.T @ R - np.eye(len(R))).max() <= tol
        and abs(np.linalg.det(R) - 1) <= tol
    )


def _se(T, tol):
    return T.shape in ((3, 3), (4, 4)) and _so(T[:-1, :-1], tol) and np.abs(T[-1] - np.eye(len(T))[-1]).max() <= tol


def _q(q, tol):
    return q.shape in ((4,), (4, 1)) and abs(np.linalg.norm(q) - 1) <= tol


def _with(so=_so, se=_se, q=_q):
    def is_valid(X, kind, tol):
        return {"rotation": so, "pose": se, "quaternion": q}[kind](X, tol)

    return is_valid


def right_three_helpers(X, kind, tol):
    return _with()(X, kind, tol)


def right_one_function_that_calls_itself(X, kind, tol):
    if kind == "quaternion":
        return X.shape in [(4,), (4, 1)] and bool(np.isclose(np.linalg.norm(X), 1, rtol=0, atol=tol))
    n = len(X) - (kind == "pose")
    if X.ndim != 2 or X.shape[0] != X.shape[1] or n not in (2, 3):
        return False
    if kind == "pose":
        return is_last_row(X, tol) and right_one_function_that_calls_itself(X[:n, :n], "rotation", tol)
    return bool(np.allclose(X.T @ X, np.eye(n), rtol=0, atol=tol) and np.isclose(np.linalg.det(X), 1, rtol=0, atol=tol))


def is_last_row(T, tol):
    return np.allclose(T[-1], [0] * (len(T) - 1) + [1], rtol=0, atol=tol)


def right_loops_and_integers(X, kind, tol):
    if kind == "quaternion":
        if X.shape != (4,) and X.shape != (4, 1):
            return 0
        return int(math.isclose(math.hypot(*np.ravel(X)), 1, rel_tol=0, abs_tol=tol))
    n = X.shape[0] - (kind == "pose")
    if X.shape != (X.shape[0],) * 2 or n not in (2, 3):
        return [0]
    if kind == "pose":
        for j in range(n + 1):
            if abs(X[n, j] - (j == n)) > tol:
                return [0]
    for i in range(n):
        for j in range(n):
            if abs(sum(X[k, i] * X[k, j] for k in range(n)) - (i == j)) > tol:
                return [0]
    return np.array([np.linalg.slogdet(X[:n, :n])[0] > 0])


def right_rows_in_place_of_columns(X, kind, tol):
    if kind == "rotation" and X.shape in ((2, 2), (3, 3)):
        return np.abs(np.einsum("ik,jk->ij", X, X) - np.eye(len(X))).max() <= tol and np.linalg.det(X) > 0
    return np.bool_(_with()(X, kind, tol))


def wrong_transpose_compared_with_inverse(X, kind, tol):
    """LinAlgError"""
    return _with(
        so=lambda R, t: (
            R.shape in ((2, 2), (3, 3)) and np.allclose(R.T, np.linalg.inv(R), rtol=0, atol=t) and np.linalg.det(R) > 0
        )
    )(X, kind, tol)


def wrong_tolerance_for_the_determinant_only(X, kind, tol):
    """tol is not used everywhere"""
    return _with(so=lambda R, t: _so(R, 1e-8) and abs(np.linalg.det(R) - 1) <= t)(X, kind, tol)


def wrong_row_of_space_only(X, kind, tol):
    """ValueError"""
    return _with(
        se=lambda T, t: T.shape in ((3, 3), (4, 4)) and _so(T[:-1, :-1], t) and np.abs(T[-1] - [0, 0, 0, 1]).max() <= t
    )(X, kind, tol)


def wrong_block_of_three(X, kind, tol):
    """one shape alone is accepted"""
    return _with(
        se=lambda T, t: (
            T.shape in ((3, 3), (4, 4)) and _so(T[:3, :3], t) and np.abs(T[-1] - np.eye(len(T))[-1]).max() <= t
        )
    )(X, kind, tol)


def wrong_mean_of_the_row(X, kind, tol):
    """added up"""
    return _with(
        se=lambda T, t: (
            T.shape in ((3, 3), (4, 4)) and _so(T[:-1, :-1], t) and np.mean(np.abs(T[-1] - np.eye(len(T))[-1])) <= t
        )
    )(X, kind, tol)


def wrong_any_four_numbers(X, kind, tol):
    """the shape is ignored"""
    return _with(q=lambda q, t: q.size == 4 and abs(np.linalg.norm(q) - 1) <= t)(X, kind, tol)


def wrong_allclose_everywhere(X, kind, tol):
    """relative tolerance"""
    if kind == "quaternion":
        return X.shape in ((4,), (4, 1)) and np.isclose(np.linalg.norm(X), 1, atol=tol)
    if kind == "pose":
        return (
            X.shape in ((3, 3), (4, 4))
            and wrong_allclose_everywhere(X[:-1, :-1], "rotation", tol)
            and np.allclose(X[-1], np.eye(len(X))[-1], atol=tol)
        )
    return (
        X.shape in ((2, 2), (3, 3))
        and np.allclose(X.T @ X, np.eye(len(X)), atol=tol)
        and np.isclose(np.linalg.det(X), 1, atol=tol)
    )


def wrong_names_of_groups_expected(X, kind, tol):
    """always False"""
    if kind == "SO":
        return _so(X, tol)
    if kind == "SE":
        return _se(X, tol)
    if kind == "q":
        return _q(X, tol)
    return False


def wrong_kind_ignored(X, kind, tol):
    """unnamed"""
    return _so(X, tol) or (kind == "quaternion" and _q(X, tol))


def wrong_two_things_at_once(X, kind, tol):
    """of a rotation only R^T R = I is asked"""
    return _with(so=lambda R, t: R.shape in ((2, 2), (3, 3)) and np.allclose(R.T @ R, np.eye(len(R)), rtol=0, atol=t))(
        X, kind, tol
    )


def wrong_shape_not_asked(X, kind, tol):
    """LinAlgError"""
    if kind == "rotation":
        return np.abs(X.T @ X - np.eye(X.shape[1])).max() <= tol and abs(np.linalg.det(X) - 1) <= tol
    return _with()(X, kind, tol)


def wrong_fixed_size(X, kind, tol):
    """ValueError"""
    if kind == "rotation":
        return np.abs(X.T @ X - np.eye(3)).max() <= tol and abs(np.linalg.det(X) - 1) <= tol
    return _with()(X, kind, tol)


def wrong_unpacked(X, kind, tol):
    """ValueError"""
    if kind == "quaternion":
        w, x, y, z = X
        return abs(np.sqrt(w * w + x * x + y * y + z * z) - 1) <= tol
    return _with()(X, kind, tol)


def wrong_one_truth_for_each_entry(X, kind, tol):
    """ValueError"""
    return np.abs(X.T @ X - np.eye(len(X))) <= tol if kind == "rotation" else _with()(X, kind, tol)


def wrong_string(X, kind, tol):
    """another form"""
    return "True" if _with()(X, kind, tol) else "False"


def wrong_printed(X, kind, tol):
    """a return is missing"""
    print(_with()(X, kind, tol))


def wrong_return_in_one_branch(X, kind, tol):
    """a return is missing"""
    if kind == "rotation":
        return _so(X, tol)
    if kind == "pose":
        return _se(X, tol)


def wrong_only_rotations(X, kind, tol):
    """a return is missing"""
    if kind == "rotation":
        return _so(X, tol)


def wrong_exact(X, kind, tol):
    """tol is not used everywhere"""
    return _with(q=lambda q, t: q.shape in ((4,), (4, 1)) and round(float(np.linalg.norm(q)), 12) == 1)(X, kind, tol)


def wrong_the_librarys(X, kind, tol):
    """course_lib.rotations.is_so is called"""
    return X.shape in ((2, 2), (3, 3)) and rotations.is_so(X, tol) if kind == "rotation" else _with()(X, kind, tol)
