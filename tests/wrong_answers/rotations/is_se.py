"""What students write for is_se(T, tol)."""

import numpy as np

from course_lib.rigid import is_se as library


def is_so(R, tol):
    if R.shape not in [(2, 2), (3, 3)]:
        return False
    return np.abs(R.T @ R - np.eye(len(R))).max() <= tol and abs(np.linalg.det(R) - 1) <= tol


def right_block_and_row(T, tol):
    if T.shape not in [(3, 3), (4, 4)]:
        return False
    return is_so(T[:-1, :-1], tol) and np.abs(T[-1] - np.eye(len(T))[-1]).max() <= tol


def right_allclose(T, tol):
    n = T.shape[0] - 1
    if T.shape != (n + 1, n + 1) or n not in (2, 3):
        return 0
    R, row = T[:n, :n], T[n, :]
    row_is_fine = np.allclose(row, [0] * n + [1], rtol=0, atol=tol)
    return int(is_so(R, tol) and row_is_fine)


def right_entry_by_entry(T, tol):
    rows = T.tolist()
    n = len(rows) - 1
    if n not in (2, 3) or any(len(row) != n + 1 for row in rows):
        return [False]
    for j in range(n):
        if abs(rows[n][j]) > tol:
            return [False]
    if abs(rows[n][n] - 1) > tol:
        return [False]
    return [is_so(np.array([row[:n] for row in rows[:n]]), tol)]


def right_translation_removed(T, tol):
    if len(set(T.shape)) != 1 or len(T) not in (3, 4):
        return np.False_
    bare = T.copy()
    bare[:-1, -1] = 0
    row_error = np.abs(bare[-1] - np.eye(len(T))[-1]).max()
    block_error = np.abs(T[:-1, :-1].T @ T[:-1, :-1] - np.eye(len(T) - 1)).max()
    return max(row_error, block_error) <= tol and np.linalg.det(bare) > 0


def wrong_row_not_looked_at(T, tol):
    """the last row is not looked at"""
    return T.shape[0] == T.shape[1] and is_so(T[:-1, :-1], tol)


def wrong_last_entry_only(T, tol):
    """of the last row only the last entry is looked at"""
    return T.shape[0] == T.shape[1] and is_so(T[:-1, :-1], tol) and abs(T[-1, -1] - 1) <= tol


def wrong_zeros_only(T, tol):
    """of the last row only the zeros are looked at"""
    return T.shape[0] == T.shape[1] and is_so(T[:-1, :-1], tol) and np.abs(T[-1, :-1]).max() <= tol


def wrong_sum_of_row(T, tol):
    """the entries of the last row are added up"""
    return T.shape[0] == T.shape[1] and is_so(T[:-1, :-1], tol) and abs(T[-1].sum() - 1) <= tol


def wrong_whole_matrix(T, tol):
    """the whole of T is taken for a rotation"""
    if T.shape not in [(3, 3), (4, 4)]:
        return False
    return np.abs(T.T @ T - np.eye(len(T))).max() <= tol and np.linalg.det(T) > 0


def wrong_last_column(T, tol):
    """the last column is compared"""
    return T.shape[0] == T.shape[1] and is_so(T[:-1, :-1], tol) and np.abs(T[:, -1] - np.eye(len(T))[-1]).max() <= tol


def wrong_exact_row(T, tol):
    """the last row is not compared with tol"""
    return T.shape[0] == T.shape[1] and is_so(T[:-1, :-1], tol) and (T[-1] == np.eye(len(T))[-1]).all()


def wrong_numpys_own_tolerance_on_top(T, tol):
    """a relative tolerance"""
    return T.shape[0] == T.shape[1] and is_so(T[:-1, :-1], tol) and np.allclose(T[-1], np.eye(len(T))[-1], atol=tol)


def wrong_block_not_looked_at(T, tol):
    """the block is not looked at"""
    return T.shape in [(3, 3), (4, 4)] and np.abs(T[-1] - np.eye(len(T))[-1]).max() <= tol


def wrong_reflections_pass(T, tol):
    """a reflection passes"""
    if T.shape not in [(3, 3), (4, 4)]:
        return False
    R = T[:-1, :-1]
    return np.abs(R.T @ R - np.eye(len(R))).max() <= tol and np.abs(T[-1] - np.eye(len(T))[-1]).max() <= tol


def wrong_determinant_only(T, tol):
    """of the block only the determinant is looked at"""
    if T.shape not in [(3, 3), (4, 4)]:
        return False
    return abs(np.linalg.det(T[:-1, :-1]) - 1) <= tol and np.abs(T[-1] - np.eye(len(T))[-1]).max() <= tol


def wrong_own_tolerance(T, tol):
    """tol is not used"""
    if T.shape not in [(3, 3), (4, 4)]:
        return False
    return is_so(T[:-1, :-1], 1e-6) and np.abs(T[-1] - np.eye(len(T))[-1]).max() <= 1e-6


def wrong_space_only(T, tol):
    """one size alone is accepted"""
    return T.shape == (4, 4) and is_so(T[:3, :3], tol) and np.abs(T[3] - [0, 0, 0, 1]).max() <= tol


def wrong_fixed_row(T, tol):
    """ValueError"""
    return is_so(T[:-1, :-1], tol) and np.abs(T[-1] - [0, 0, 0, 1]).max() <= tol


def wrong_without_absolute_value(T, tol):
    """a negative error always passes"""
    if T.shape not in [(3, 3), (4, 4)]:
        return False
    return is_so(T[:-1, :-1], tol) and max(T[-1] - np.eye(len(T))[-1]) <= tol


def wrong_broad_matrices_pass(T, tol):
    """the shape is not looked at"""
    n = len(T) - 1
    row_is_fine = np.allclose(T[n, : n + 1], [0] * n + [1], rtol=0, atol=tol)
    return row_is_fine and is_so(T[:n, :n], tol)


def wrong_tolerance_not_passed_on(T, tol):
    """tol is not passed on"""
    if T.shape not in [(3, 3), (4, 4)]:
        return False
    return is_so(T[:-1, :-1], 1e-8) and np.abs(T[-1] - np.eye(len(T))[-1]).max() <= tol


def wrong_always_false(T, tol):
    """the answer is always False"""
    return bool(np.all(T == "pose"))


def wrong_always_true(T, tol):
    """the answer is always True"""
    return True


def wrong_nothing_returned(T, tol):
    """a return is missing"""
    answer = is_so(T[:-1, :-1], tol) and np.abs(T[-1] - np.eye(len(T))[-1]).max() <= tol


def wrong_the_librarys(T, tol):
    """course_lib.rigid.is_se is called"""
    return T.shape in [(3, 3), (4, 4)] and library(T, tol)
