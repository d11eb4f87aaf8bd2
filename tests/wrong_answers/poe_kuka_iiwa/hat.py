"""What students write for hat(w)."""

import numpy as np
import scipy.linalg

from course_lib import rigid
from course_lib import rotations as rot


def right_written_out(w):
    return np.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])


def right_lists(w):
    x, y, z = w
    return [[0.0, -z, y], [z, 0.0, -x], [-y, x, 0.0]]


def right_cross_products_as_columns(w):
    return np.column_stack([np.cross(w, e) for e in np.eye(3)])


def right_levi_civita(w):
    epsilon = np.zeros((3, 3, 3))
    for i, j, k in [(0, 1, 2), (1, 2, 0), (2, 0, 1)]:
        epsilon[i, j, k], epsilon[i, k, j] = 1, -1
    return -np.einsum("ijk,k->ij", epsilon, w)


def right_upper_half_mirrored(w):
    W = np.zeros((3, 3))
    W[0, 1], W[0, 2], W[1, 2] = -w[2], w[1], -w[0]
    return (W - W.T).astype(complex)


def wrong_transposed(w):
    """the matrix is transposed"""
    return np.array([[0, w[2], -w[1]], [-w[2], 0, w[0]], [w[1], -w[0], 0]])


def wrong_cross_products_as_rows(w):
    """the matrix is transposed"""
    return np.cross(w, np.eye(3))


def wrong_x_and_y_swapped(w):
    """each other's places"""
    return np.array([[0, -w[2], w[0]], [w[2], 0, -w[1]], [-w[0], w[1], 0]])


def wrong_y_and_z_swapped(w):
    """each other's places"""
    x, y, z = w
    return np.array([[0, -y, z], [y, 0, -x], [-z, x, 0]])


def wrong_in_the_order_of_w(w):
    """each other's places"""
    x, y, z = w
    return np.array([[0, -x, y], [x, 0, -z], [-y, z, 0]])


def wrong_in_the_order_of_w_upwards(w):
    """each other's places"""
    x, y, z = w
    return np.array([[0, x, y], [-x, 0, z], [-y, -z, 0]])


def wrong_one_sign_pair(w):
    """some signs in it are wrong"""
    x, y, z = w
    return np.array([[0, -z, -y], [z, 0, -x], [y, x, 0]])


def wrong_sign_of_one_entry(w):
    """some signs in it are wrong"""
    x, y, z = w
    return np.array([[0, -z, y], [z, 0, x], [-y, x, 0]])


def wrong_no_signs(w):
    """the matrix is symmetric"""
    x, y, z = w
    return np.array([[0, z, y], [z, 0, x], [y, x, 0]])


def wrong_mirrored_without_the_minus(w):
    """the matrix is symmetric"""
    W = np.zeros((3, 3))
    W[0, 1], W[0, 2], W[1, 2] = -w[2], w[1], -w[0]
    return W + W.T


def wrong_upper_half_only(w):
    """one half of the matrix is empty"""
    W = np.zeros((3, 3))
    W[0, 1], W[0, 2], W[1, 2] = -w[2], w[1], -w[0]
    return W


def wrong_ones_on_the_diagonal(w):
    """the diagonal is filled"""
    return np.array([[1, -w[2], w[1]], [w[2], 1, -w[0]], [-w[1], w[0], 1]])


def wrong_w_on_the_diagonal_too(w):
    """the diagonal is filled"""
    return np.array([[w[0], -w[2], w[1]], [w[2], w[1], -w[0]], [-w[1], w[0], w[2]]])


def wrong_outer_product(w):
    """the outer product"""
    return np.outer(w, w)


def wrong_diagonal_matrix(w):
    """w stands on the diagonal"""
    return np.diag(w)


def wrong_vector(w):
    """a vector is returned"""
    return np.cross(w, np.ones(3))


def wrong_four_by_four(w):
    """another form"""
    W = np.zeros((4, 4))
    W[:3, :3] = right_written_out(w)
    return W


def wrong_unit_axis(w):
    """w is divided by its length"""
    n = w / np.linalg.norm(w) if w.any() else w
    return right_written_out(n)


def wrong_rotation(w):
    """the rotation matrix of w"""
    return scipy.linalg.expm(right_written_out(w))


def wrong_squared(w):
    """[w] is squared"""
    return right_written_out(w) @ right_written_out(w)


def wrong_whole_numbers(w):
    """unnamed"""
    W = np.zeros((3, 3), dtype=int)
    W[0, 1], W[0, 2], W[1, 2] = -w[2], w[1], -w[0]
    return W - W.T


def wrong_prints_and_returns_nothing(w):
    """a return is missing"""
    print(right_written_out(w))


def wrong_changed_in_place(w):
    """w is changed in place"""
    W = np.zeros((3, 3))
    w *= -1
    W[0, 1], W[0, 2], W[1, 2] = w[2], -w[1], w[0]
    return W - W.T


def wrong_the_librarys(w):
    """course_lib.rotations.hat is called"""
    return rot.hat(w)


def wrong_the_librarys_by_way_of_the_twist(w):
    """course_lib.rotations.hat is called"""
    return rigid.hat_se3(np.append(w, np.zeros(3)))[:3, :3]
