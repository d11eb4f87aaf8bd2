"""What students write for dh_modified(a, alpha, d, theta)."""

import math

import numpy as np
import scipy.linalg

from course_lib import arms, rigid
from course_lib.rotations import rot_x, rot_y, rot_z


def right_two_halves(a, alpha, d, theta):
    along_x = rigid.transform(rot_x(alpha), [a, 0, 0])
    along_z = rigid.transform(rot_z(theta), [0, 0, d])
    return along_x @ along_z


def right_entry_by_entry_as_lists(a, alpha, d, theta):
    ca, sa, c, s = math.cos(alpha), math.sin(alpha), math.cos(theta), math.sin(theta)
    return [[c, -s, 0, a], [ca * s, ca * c, -sa, -sa * d], [sa * s, sa * c, ca, ca * d], [0, 0, 0, 1]]


def right_four_steps_each_pair_the_other_way(a, alpha, d, theta):
    X, Z, A, D = np.eye(4), np.eye(4), np.eye(4), np.eye(4)
    X[1:3, 1:3] = [[np.cos(alpha), -np.sin(alpha)], [np.sin(alpha), np.cos(alpha)]]
    Z[:2, :2] = [[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]]
    A[0, 3], D[2, 3] = a, d
    return A @ X @ D @ Z


def right_two_screws(a, alpha, d, theta):
    return rigid.exp_se3([alpha, 0, 0, a, 0, 0]) @ rigid.exp_se3([0, 0, theta, 0, 0, d])


def right_exponential_of_matrices(a, alpha, d, theta):
    X = np.array([[0, 0, 0, a], [0, 0, -alpha, 0], [0, alpha, 0, 0], [0, 0, 0, 0.0]])
    Z = np.array([[0, -theta, 0, 0], [theta, 0, 0, 0], [0, 0, 0, d], [0, 0, 0, 0.0]])
    return scipy.linalg.expm(X) @ scipy.linalg.expm(Z)


def right_axes_and_origin(a, alpha, d, theta):
    z = np.array([0, -np.sin(alpha), np.cos(alpha)])
    x = np.cos(theta) * np.array([1, 0, 0]) + np.sin(theta) * np.array([0, np.cos(alpha), np.sin(alpha)])
    T = np.eye(4, dtype=complex)
    T[:3] = np.column_stack([x, np.cross(z, x), z, [a, 0, 0] + d * z])
    return T


def _x(a, alpha):
    return rigid.transform(rot_x(alpha), [a, 0, 0])


def _z(d, theta):
    return rigid.transform(rot_z(theta), [0, 0, d])


def wrong_standard(a, alpha, d, theta):
    """the standard convention is taken"""
    return _z(d, theta) @ _x(a, alpha)


def wrong_standard_entry_by_entry(a, alpha, d, theta):
    """the standard convention is taken"""
    c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]])


def wrong_turns_in_the_other_order(a, alpha, d, theta):
    """Rot_z(theta) is left of Rot_x(alpha)"""
    return rigid.transform(rot_z(theta) @ rot_x(alpha), [a, -d * np.sin(alpha), d * np.cos(alpha)])


def wrong_turns_in_the_other_order_and_the_place_filled_in(a, alpha, d, theta):
    """the four steps are multiplied in another order"""
    return rigid.transform(rot_z(theta) @ rot_x(alpha), [a, 0, d])


def wrong_angles_swapped(a, alpha, d, theta):
    """alpha and theta are swapped"""
    return _x(a, theta) @ _z(d, alpha)


def wrong_lengths_swapped(a, alpha, d, theta):
    """a and d are swapped"""
    return _x(d, alpha) @ _z(a, theta)


def wrong_order_of_a_table(d, theta, a, alpha):
    """the arguments are taken in another order"""
    return _x(a, alpha) @ _z(d, theta)


def wrong_minus_lost(a, alpha, d, theta):
    """the minus of -d sin(alpha) is missing"""
    ca, sa, c, s = np.cos(alpha), np.sin(alpha), np.cos(theta), np.sin(theta)
    return np.array([[c, -s, 0, a], [ca * s, ca * c, -sa, sa * d], [sa * s, sa * c, ca, ca * d], [0, 0, 0, 1]])


def wrong_sign_of_one_sine(a, alpha, d, theta):
    """one entry has the wrong sign"""
    ca, sa, c, s = np.cos(alpha), np.sin(alpha), np.cos(theta), np.sin(theta)
    return np.array([[c, -s, 0, a], [ca * s, ca * c, -sa, -sa * d], [sa * s, -sa * c, ca, ca * d], [0, 0, 0, 1]])


def wrong_alpha_the_other_way(a, alpha, d, theta):
    """alpha has the wrong sign"""
    return _x(a, -alpha) @ _z(d, theta)


def wrong_theta_the_other_way(a, alpha, d, theta):
    """theta has the wrong sign"""
    c, s = np.cos(theta), np.sin(theta)
    return _x(a, alpha) @ np.array([[c, s, 0, 0], [-s, c, 0, 0], [0, 0, 1, d], [0, 0, 0, 1]])


def wrong_degrees(a, alpha, d, theta):
    """degrees"""
    return _x(a, np.radians(alpha)) @ _z(d, np.radians(theta))


def wrong_transposed(a, alpha, d, theta):
    """T is transposed"""
    return (_x(a, alpha) @ _z(d, theta)).T


def wrong_inverse(a, alpha, d, theta):
    """the inverse is returned"""
    return _z(-d, -theta) @ _x(-a, -alpha)


def wrong_place_filled_in(a, alpha, d, theta):
    """d goes along the old z"""
    T = np.eye(4)
    T[:3, :3] = rot_x(alpha) @ rot_z(theta)
    T[:3, 3] = a, 0, d
    return T


def wrong_a_behind_theta(a, alpha, d, theta):
    """a is rotated by theta"""
    return _x(0, alpha) @ _z(d, theta) @ _x(a, 0)


def wrong_sum(a, alpha, d, theta):
    """the matrices are added"""
    return _x(a, alpha) + _z(d, theta)


def wrong_entry_by_entry(a, alpha, d, theta):
    """entry by entry"""
    return _x(a, alpha) * _z(d, theta)


def wrong_last_row_missing(a, alpha, d, theta):
    """the last row is missing"""
    return right_two_halves(a, alpha, d, theta)[:3]


def wrong_last_row_of_zeros(a, alpha, d, theta):
    """the last row is not"""
    T = np.zeros((4, 4))
    T[:3] = right_two_halves(a, alpha, d, theta)[:3]
    return T


def wrong_rotation_only(a, alpha, d, theta):
    """only the rotation is returned"""
    return rot_x(alpha) @ rot_z(theta)


def wrong_about_y(a, alpha, d, theta):
    """alpha rotates about y"""
    return rigid.transform(rot_y(alpha), [a, 0, 0]) @ _z(d, theta)


def wrong_sines_and_cosines(a, alpha, d, theta):
    """unnamed"""
    sa, ca, s, c = np.cos(alpha), np.sin(alpha), np.cos(theta), np.sin(theta)
    return [[c, -s, 0, a], [ca * s, ca * c, -sa, -sa * d], [sa * s, sa * c, ca, ca * d], [0, 0, 0, 1]]


def wrong_whole_numbers(a, alpha, d, theta):
    """digits after the point are cut off"""
    T = np.eye(4, dtype=int)
    T[:] = right_two_halves(a, alpha, d, theta)
    return T


def wrong_rounded(a, alpha, d, theta):
    """first digits only"""
    return np.round(right_two_halves(a, alpha, d, theta), 4)


def wrong_pair_for_the_pose(a, alpha, d, theta):
    """another form"""
    return rot_x(alpha) @ rot_z(theta), np.array([a, -d * np.sin(alpha), d * np.cos(alpha)])


def wrong_the_librarys(a, alpha, d, theta):
    """course_lib.arms.SerialArm is called"""
    return arms.SerialArm.from_dh([arms.DHRow(a, alpha, d, theta)]).fk([0.0])


def wrong_sines_of_squares(a, alpha, d, theta):
    """unnamed"""
    return _x(a, alpha**2) @ _z(d, theta**2)
