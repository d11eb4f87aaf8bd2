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


def right_four_steps_each_pair_reversed(a, alpha, d, theta):
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
    """The inverse goes along x first, then along z."""
    back = rigid.transform(rot_x(-alpha), [-a, 0, 0]) @ rigid.transform(rot_z(-theta), [0, 0, -d])
    return np.linalg.inv(back)


def _x(a, alpha):
    return rigid.transform(rot_x(alpha), [a, 0, 0])


def _z(d, theta):
    return rigid.transform(rot_z(theta), [0, 0, d])


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


def wrong_rounded(a, alpha, d, theta):
    """first digits only"""
    return np.round(right_two_halves(a, alpha, d, theta), 6)


def wrong_angles_wrapped_to_a_half_turn(a, alpha, d, theta):
    """unnamed"""
    return right_two_halves(a, alpha % np.pi, d, theta % np.pi)


def wrong_the_librarys(a, alpha, d, theta):
    """course_lib.arms.SerialArm is called"""
    return arms.SerialArm.from_dh([arms.DHRow(a, alpha, d, theta)], "standard").fk([0.0])


def wrong_the_librarys_frames(a, alpha, d, theta):
    """course_lib.arms._dh_frames is called"""
    return arms._dh_frames([(a, alpha, d, theta)], "standard")[0][0]
