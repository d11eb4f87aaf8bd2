"""What students write for is_so(R, tol)."""

import numpy as np

import course_lib.rotations as r


def right_allclose(R, tol):
    if R.shape not in [(2, 2), (3, 3)]:
        return False
    orthonormal = np.allclose(R.T @ R, np.eye(R.shape[0]), rtol=0, atol=tol)
    return orthonormal and abs(np.linalg.det(R) - 1) <= tol


def right_loops_and_an_integer(R, tol):
    rows = R.tolist()
    n = len(rows)
    for row in rows:
        if len(row) != n:
            return 0
    for i in range(n):
        for j in range(n):
            product = sum(rows[k][i] * rows[k][j] for k in range(n))
            if abs(product - (1 if i == j else 0)) > tol:
                return 0
    return int(np.linalg.det(R) > 0)


def right_rows_in_place_of_columns(R, tol):
    if R.ndim != 2 or R.shape[0] != R.shape[1]:
        return np.False_
    off = np.einsum("ik,jk->ij", R, R) - np.eye(len(R))
    return np.array([(np.abs(off) <= tol).all() and np.linalg.slogdet(R)[0] == 1])


def right_third_column_by_cross_product(R, tol):
    if R.shape == (2, 2):
        (a, b), (c, d) = R
        entries = [a * a + c * c - 1, b * b + d * d - 1, a * b + c * d]
        return max(abs(e) for e in entries) <= tol and a * d - b * c > 0
    if R.shape == (3, 3):
        x, y, z = R.T
        entries = [x @ x - 1, y @ y - 1, z @ z - 1, x @ y, y @ z, z @ x]
        return max(abs(e) for e in entries) <= tol and np.cross(x, y) @ z > 0
    return False


def wrong_no_determinant(R, tol):
    """only R^T R = I is looked at"""
    if R.shape[0] != R.shape[1]:
        return False
    return np.abs(R.T @ R - np.eye(len(R))).max() <= tol


def wrong_size_of_determinant(R, tol):
    """only R^T R = I is looked at"""
    if R.shape[0] != R.shape[1]:
        return False
    return np.abs(R.T @ R - np.eye(len(R))).max() <= tol and abs(abs(np.linalg.det(R)) - 1) <= tol


def wrong_only_determinant(R, tol):
    """only det R = 1 is looked at"""
    if R.shape[0] != R.shape[1]:
        return False
    return abs(np.linalg.det(R) - 1) <= tol


def wrong_entry_by_entry(R, tol):
    """entry by entry"""
    if R.shape[0] != R.shape[1]:
        return False
    return np.abs(R.T * R - np.eye(len(R))).max() <= tol and abs(np.linalg.det(R) - 1) <= tol


def wrong_own_tolerance(R, tol):
    """tol is not used"""
    if R.shape[0] != R.shape[1]:
        return False
    return np.allclose(R.T @ R, np.eye(len(R)), rtol=0, atol=1e-6) and np.isclose(np.linalg.det(R), 1)


def wrong_numpys_own_tolerance_on_top(R, tol):
    """a relative tolerance"""
    if R.shape[0] != R.shape[1]:
        return False
    return np.allclose(R.T @ R, np.eye(len(R)), atol=tol) and np.isclose(np.linalg.det(R), 1, atol=tol)


def wrong_norm(R, tol):
    """(a norm)"""
    if R.shape[0] != R.shape[1]:
        return False
    return np.linalg.norm(R.T @ R - np.eye(len(R))) <= tol and abs(np.linalg.det(R) - 1) <= tol


def wrong_without_absolute_value(R, tol):
    """a negative error always passes"""
    if R.shape[0] != R.shape[1]:
        return False
    return (R.T @ R - np.eye(len(R))).max() <= tol and abs(np.linalg.det(R) - 1) <= tol


def wrong_lengths_of_columns_only(R, tol):
    """not the angles between them"""
    if R.shape[0] != R.shape[1]:
        return False
    lengths = np.linalg.norm(R, axis=0)
    return np.abs(lengths - 1).max() <= tol and np.linalg.det(R) > 0


def wrong_space_only(R, tol):
    """one size alone is accepted"""
    if R.shape != (3, 3):
        return False
    return np.abs(R.T @ R - np.eye(3)).max() <= tol and abs(np.linalg.det(R) - 1) <= tol


def wrong_fixed_size(R, tol):
    """ValueError"""
    return np.abs(R.T @ R - np.eye(3)).max() <= tol and abs(np.linalg.det(R) - 1) <= tol


def wrong_shape_not_asked(R, tol):
    """LinAlgError"""
    return np.abs(R.T @ R - np.eye(R.shape[1])).max() <= tol and abs(np.linalg.det(R) - 1) <= tol


def wrong_tall_matrices_pass(R, tol):
    """the shape is not looked at"""
    error = np.abs(R.T @ R - np.eye(R.shape[1])).max()
    if R.shape[0] == R.shape[1]:
        return error <= tol and abs(np.linalg.det(R) - 1) <= tol
    return error <= tol


def wrong_two_things_at_once(R, tol):
    """a reflection passes"""
    return R.shape[0] == R.shape[1] and np.allclose(R.T @ R, np.eye(len(R)))


def wrong_identity_only(R, tol):
    """only the identity is accepted"""
    return R.shape[0] == R.shape[1] and np.allclose(R, np.eye(len(R)), rtol=0, atol=tol)


def wrong_always_true(R, tol):
    """the answer is always True"""
    return True


def wrong_always_false(R, tol):
    """the answer is always False"""
    return False


def wrong_printed(R, tol):
    """a return is missing"""
    print(R.shape[0] == R.shape[1] and np.allclose(R.T @ R, np.eye(len(R))) and np.linalg.det(R) > 0)


def wrong_string(R, tol):
    """another form"""
    if R.shape[0] == R.shape[1] and np.allclose(R.T @ R, np.eye(len(R)), atol=tol):
        return "True" if np.linalg.det(R) > 0 else "False"
    return "False"


def wrong_one_truth_for_each_entry(R, tol):
    """another form"""
    if R.shape[0] != R.shape[1]:
        return False
    return np.abs(R.T @ R - np.eye(len(R))) <= tol


def wrong_the_librarys(R, tol):
    """course_lib.rotations.is_so is called"""
    return bool(R.shape[0] == R.shape[1] and r.is_so(R, tol))
