"""What students write for dh_standard(a, alpha, d, theta)."""

import math

import numpy as np
import scipy.linalg

from course_lib import arms, rigid
from course_lib.rotations import rot_x, rot_y, rot_z


def right_two_halves(a, alpha, d, theta):
    along_z = rigid.transform(rot_z(theta), [0, 0, d])
    along_x = rigid.transform(rot_x(alpha), [a, 0, 0])
    return along_z @ along_x


def right_entry_by_entry_as_lists(a, alpha, d, theta):
    c, s, ca, sa = math.cos(theta), math.sin(theta), math.cos(alpha), math.sin(alpha)
    return [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]]


def right_four_steps_each_pair_the_other_way(a, alpha, d, theta):
    X, Z, A, D = np.eye(4), np.eye(4), np.eye(4), np.eye(4)
    X[1:3, 1:3] = [[np.cos(alpha), -np.sin(alpha)], [np.sin(alpha), np.cos(alpha)]]
    Z[:2, :2] = [[np.cos(theta), -np.sin(theta)], [np.sin(theta), np.cos(theta)]]
    A[0, 3], D[2, 3] = a, d
    return D @ Z @ X @ A


def right_two_screws(a, alpha, d, theta):
    return rigid.exp_se3([0, 0, theta, 0, 0, d]) @ rigid.exp_se3([alpha, 0, 0, a, 0, 0])


def right_exponential_of_matrices(a, alpha, d, theta):
    X = np.array([[0, 0, 0, a], [0, 0, -alpha, 0], [0, alpha, 0, 0], [0, 0, 0, 0.0]])
    Z = np.array([[0, -theta, 0, 0], [theta, 0, 0, 0], [0, 0, 0, d], [0, 0, 0, 0.0]])
    return scipy.linalg.expm(Z) @ scipy.linalg.expm(X)


def right_inverse_of_the_modified_way_back(a, alpha, d, theta):
    """The way back is along x first, then along z."""
    back = rigid.transform(rot_x(-alpha), [-a, 0, 0]) @ rigid.transform(rot_z(-theta), [0, 0, -d])
    return np.linalg.inv(back)


def _x(a, alpha):
    return rigid.transform(rot_x(alpha), [a, 0, 0])


def _z(d, theta):
    return rigid.transform(rot_z(theta), [0, 0, d])


def wrong_modified(a, alpha, d, theta):
    """the modified convention is taken"""
    return _x(a, alpha) @ _z(d, theta)


def wrong_modified_entry_by_entry(a, alpha, d, theta):
    """the modified convention is taken"""
    ca, sa, c, s = np.cos(alpha), np.sin(alpha), np.cos(theta), np.sin(theta)
    return [[c, -s, 0, a], [ca * s, ca * c, -sa, -sa * d], [sa * s, sa * c, ca, ca * d], [0, 0, 0, 1]]


def wrong_turns_in_the_other_order(a, alpha, d, theta):
    """Rot_x(alpha) is left of Rot_z(theta)"""
    return rigid.transform(rot_x(alpha) @ rot_z(theta), [a * np.cos(theta), a * np.sin(theta), d])


def wrong_angles_swapped(a, alpha, d, theta):
    """alpha and theta are swapped"""
    return _z(d, alpha) @ _x(a, theta)


def wrong_lengths_swapped(a, alpha, d, theta):
    """a and d are swapped"""
    return _z(a, theta) @ _x(d, alpha)


def wrong_order_of_the_report(d, alpha, a, theta):
    """a and d are swapped"""
    return _z(d, theta) @ _x(a, alpha)


def wrong_order_theta_first(theta, d, a, alpha):
    """the arguments are taken in another order"""
    return _z(d, theta) @ _x(a, alpha)


def wrong_minus_lost(a, alpha, d, theta):
    """one entry has the wrong sign"""
    c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([[c, -s * ca, s * sa, a * c], [s, c * ca, c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]])


def wrong_place_on_the_other_side(a, alpha, d, theta):
    """the components of a along the new x are mixed up"""
    c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, -a * s], [0, sa, ca, d], [0, 0, 0, 1]])


def wrong_alpha_the_other_way(a, alpha, d, theta):
    """alpha has the wrong sign"""
    return _z(d, theta) @ _x(a, -alpha)


def wrong_theta_the_other_way(a, alpha, d, theta):
    """theta has the wrong sign"""
    return _z(d, -theta) @ _x(a, alpha)


def wrong_degrees(a, alpha, d, theta):
    """degrees"""
    return _z(d, theta * np.pi / 180) @ _x(a, alpha * np.pi / 180)


def wrong_transposed(a, alpha, d, theta):
    """T is transposed"""
    return (_z(d, theta) @ _x(a, alpha)).T


def wrong_inverse(a, alpha, d, theta):
    """the inverse is returned"""
    return rigid.inverse(_z(d, theta) @ _x(a, alpha))


def wrong_place_filled_in(a, alpha, d, theta):
    """a is not rotated by theta"""
    return rigid.transform(rot_z(theta) @ rot_x(alpha), [a, 0, d])


def wrong_place_behind_the_turn(a, alpha, d, theta):
    """d is rotated by alpha"""
    return rigid.transform(rot_z(theta) @ rot_x(alpha), np.zeros(3)) @ rigid.transform(np.eye(3), [a, 0, d])


def wrong_sum(a, alpha, d, theta):
    """the matrices are added"""
    return _z(d, theta) + _x(a, alpha)


def wrong_entry_by_entry(a, alpha, d, theta):
    """entry by entry"""
    return _z(d, theta) * _x(a, alpha)


def wrong_last_row_missing(a, alpha, d, theta):
    """the last row is missing"""
    c, s, ca, sa = np.cos(theta), np.sin(theta), np.cos(alpha), np.sin(alpha)
    return np.array([[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d]])


def wrong_last_row_of_zeros(a, alpha, d, theta):
    """the last row is not"""
    return np.vstack([wrong_last_row_missing(a, alpha, d, theta), np.zeros(4)])


def wrong_steps_apart(a, alpha, d, theta):
    """not their product"""
    return [_z(d, theta), _x(a, alpha)]


def wrong_about_y(a, alpha, d, theta):
    """alpha rotates about y"""
    return _z(d, theta) @ rigid.transform(rot_y(alpha), [a, 0, 0])


def wrong_theta_left_out(a, alpha, d, theta):
    """theta is left out"""
    return _z(d, 0) @ _x(a, alpha)


def wrong_a_left_out(a, alpha, d, theta):
    """a is left out"""
    return _z(d, theta) @ _x(0, alpha)


def wrong_place_left_out(a, alpha, d, theta):
    """the origin is left out"""
    return rigid.transform(rot_z(theta) @ rot_x(alpha), np.zeros(3))


def wrong_whole_numbers(a, alpha, d, theta):
    """digits after the point are cut off"""
    return right_two_halves(a, alpha, d, theta).astype(int)


def wrong_rounded(a, alpha, d, theta):
    """first digits only"""
    return np.round(right_two_halves(a, alpha, d, theta), 6)


def wrong_angles_wrapped_to_a_half_turn(a, alpha, d, theta):
    """unnamed"""
    return right_two_halves(a, alpha % np.pi, d, theta % np.pi)


def wrong_sines_of_squares(a, alpha, d, theta):
    """unnamed"""
    return _z(d, theta**2) @ _x(a, alpha**2)


def wrong_the_librarys(a, alpha, d, theta):
    """course_lib.arms.SerialArm is called"""
    return arms.SerialArm.from_dh([arms.DHRow(a, alpha, d, theta)], "standard").fk([0.0])


def wrong_the_librarys_frames(a, alpha, d, theta):
    """course_lib.arms._dh_frames is called"""
    return arms._dh_frames([(a, alpha, d, theta)], "standard")[0][0]
