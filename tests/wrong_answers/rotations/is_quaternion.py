"""What students write for is_quaternion(q, tol)."""

import math

import numpy as np

from course_lib import rotations


def right_norm(q, tol):
    return q.shape in [(4,), (4, 1)] and abs(np.linalg.norm(q) - 1) <= tol


def right_by_the_math_module(q, tol):
    if q.shape != (4,) and q.shape != (4, 1):
        return 0
    numbers = [float(x) for x in np.ravel(q)]
    return int(math.isclose(math.hypot(*numbers), 1, rel_tol=0, abs_tol=tol))


def right_flattened_dot_product(q, tol):
    if q.size != 4 or q.shape[0] != 4:
        return np.array(False)
    flat = q.flatten()
    return np.array(1 - tol <= np.sqrt(flat.dot(flat)) <= 1 + tol)


def right_nested_answer(q, tol):
    if q.shape not in ((4,), (4, 1)):
        return [[False]]
    column = q.reshape(4, 1)
    length = np.sqrt(column.T @ column)
    return np.abs(length - 1) <= tol


def wrong_column_refused(q, tol):
    """(4, 1) is refused"""
    return q.shape == (4,) and abs(np.linalg.norm(q) - 1) <= tol


def wrong_flat_refused(q, tol):
    """(4,) is refused"""
    return q.shape == (4, 1) and abs(np.linalg.norm(q) - 1) <= tol


def wrong_squared(q, tol):
    """|q|^2 is compared with 1"""
    return q.shape in [(4,), (4, 1)] and abs(np.sum(q**2) - 1) <= tol


def wrong_own_tolerance(q, tol):
    """tol is not used"""
    return q.shape in [(4,), (4, 1)] and abs(np.linalg.norm(q) - 1) <= 1e-3


def wrong_exact(q, tol):
    """tol is not used"""
    return q.shape in [(4,), (4, 1)] and round(float(np.linalg.norm(q)), 12) == 1


def wrong_numpys_own_tolerance_on_top(q, tol):
    """a relative tolerance"""
    return q.shape in [(4,), (4, 1)] and np.isclose(np.linalg.norm(q), 1, atol=tol)


def wrong_sum_of_entries(q, tol):
    """without squares"""
    return q.shape in [(4,), (4, 1)] and abs(np.sum(q) - 1) <= tol


def wrong_sum_of_sizes(q, tol):
    """without squares"""
    return q.shape in [(4,), (4, 1)] and abs(np.abs(q).sum() - 1) <= tol


def wrong_short_ones_pass(q, tol):
    """a length below 1 always passes"""
    return q.shape in [(4,), (4, 1)] and np.linalg.norm(q) - 1 <= tol


def wrong_shape_not_asked(q, tol):
    """the shape is not looked at"""
    return abs(np.linalg.norm(q) - 1) <= tol


def wrong_only_the_first_length_asked(q, tol):
    """the shape is not looked at"""
    return len(q) == 4 and abs(np.linalg.norm(q) - 1) <= tol


def wrong_unpacked(q, tol):
    """ValueError"""
    w, x, y, z = q
    return abs(np.sqrt(w * w + x * x + y * y + z * z) - 1) <= tol


def wrong_only_shape(q, tol):
    """the length is not looked at"""
    return q.shape in [(4,), (4, 1)]


def wrong_always_true(q, tol):
    """the answer is always True"""
    return True


def wrong_always_false(q, tol):
    """the answer is always False"""
    return False


def wrong_the_length_itself(q, tol):
    """another form"""
    return np.linalg.norm(q)


def wrong_return_in_one_branch(q, tol):
    """a return is missing"""
    if q.shape in [(4,), (4, 1)]:
        return abs(np.linalg.norm(q) - 1) <= tol


def wrong_the_librarys(q, tol):
    """course_lib.rotations.is_quaternion is called"""
    return q.shape in [(4,), (4, 1)] and rotations.is_quaternion(q.ravel(), tol)
