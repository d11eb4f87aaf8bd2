"""What students write for nearest_quaternion(q)."""

import numpy as np
from numpy.linalg import norm

from course_lib.rotations import nearest_quaternion as ready_made


def right_divided_by_its_length(q):
    return q / np.linalg.norm(q)


def right_flat_list(q):
    numbers = [float(x) for x in np.ravel(q)]
    length = sum(x * x for x in numbers) ** 0.5
    return [x / length for x in numbers]


def right_always_a_column(q):
    column = np.reshape(q, (4, 1))
    return column / np.sqrt(column.T @ column)


def right_by_svd(q):
    U, S, Vt = np.linalg.svd(np.reshape(q, (4, 1)))
    return tuple(U[:, 0] * Vt[0, 0])


def right_row(q):
    flat = q.flatten()
    return np.longdouble(flat[None, :]) / np.sqrt(np.einsum("i,i", flat, flat))


def wrong_scalar_made_positive(q):
    """the sign is changed if w < 0"""
    u = np.ravel(q) / np.linalg.norm(q)
    return u if u[0] >= 0 else -u


def wrong_unchanged(q):
    """q is returned as it came"""
    return np.array(q)


def wrong_vector_part_only(q):
    """only the vector part"""
    u = np.array(q, dtype=float)
    u[1:] /= np.linalg.norm(u[1:]) or 1
    return u


def wrong_scalar_adjusted(q):
    """w is chosen so that the length becomes one"""
    u = np.ravel(q).copy()
    u[0] = np.sqrt(max(0, 1 - u[1:] @ u[1:]))
    return u


def wrong_small_number_added(q):
    """a small number is added"""
    return q / (np.linalg.norm(q) + 1e-8)


def wrong_in_place(q):
    """q is changed in place"""
    q /= norm(q)
    return q


def wrong_length_returned(q):
    """another form"""
    return norm(q)


def wrong_forgotten_return(q):
    """a return is missing"""
    q = q / norm(q)


def wrong_dot_of_a_column(q):
    """ValueError"""
    return q / np.sqrt(q @ q)


def wrong_the_librarys(q):
    """course_lib.rotations.nearest_quaternion is called"""
    return ready_made(q.reshape(4))


def wrong_sizes_of_the_entries(q):
    """the signs of the entries are lost"""
    return np.abs(np.ravel(q)) / np.linalg.norm(q)


def wrong_rounded(q):
    """first digits"""
    return np.round(np.ravel(q) / np.linalg.norm(q), 3)


def wrong_axis_one(q):
    """AxisError"""
    return q / np.linalg.norm(q, axis=1)


def wrong_root_of_the_length(q):
    """something else than its length"""
    return np.ravel(q) / np.sqrt(np.linalg.norm(q))


def wrong_valid_within_a_percent_unchanged(q):
    """q is returned as it came"""
    q = np.ravel(q)
    return q if abs(np.linalg.norm(q) - 1) < 0.05 else q / np.linalg.norm(q)


def wrong_only_long_ones(q):
    """q is"""
    q = np.ravel(q)
    return q / max(1, np.linalg.norm(q))
