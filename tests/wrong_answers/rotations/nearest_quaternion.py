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


def wrong_square_of_the_length(q):
    """|q|^2"""
    return q / np.sum(q**2)


def wrong_sum(q):
    """the sum of its entries"""
    return q / np.sum(q)


def wrong_sum_of_sizes(q):
    """the sum of its entries' sizes"""
    return q / np.sum(np.abs(q))


def wrong_largest_entry(q):
    """its largest entry"""
    return q / np.abs(q).max()


def wrong_sign_flipped(q):
    """the sign is turned"""
    return -q / np.linalg.norm(q)


def wrong_scalar_made_positive(q):
    """the sign is turned where w < 0"""
    u = np.ravel(q) / np.linalg.norm(q)
    return u if u[0] >= 0 else -u


def wrong_conjugate(q):
    """the conjugate is returned"""
    u = np.ravel(q) / np.linalg.norm(q)
    return [u[0], -u[1], -u[2], -u[3]]


def wrong_inverse(q):
    """the inverse is returned"""
    flat = np.ravel(q)
    return flat * [1, -1, -1, -1] / (flat @ flat)


def wrong_multiplied(q):
    """multiplied"""
    return q * np.linalg.norm(q)


def wrong_unchanged(q):
    """q comes back as it is"""
    return np.array(q)


def wrong_vector_part_only(q):
    """only the vector part"""
    u = np.array(q, dtype=float)
    u[1:] /= np.linalg.norm(u[1:]) or 1
    return u


def wrong_scalar_adjusted(q):
    """unnamed"""
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
