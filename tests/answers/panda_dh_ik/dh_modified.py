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


def right_four_steps_each_pair_reversed(a, alpha, d, theta):
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


def wrong_sines_and_cosines(a, alpha, d, theta):
    """unnamed"""
    sa, ca, s, c = np.cos(alpha), np.sin(alpha), np.cos(theta), np.sin(theta)
    return [[c, -s, 0, a], [ca * s, ca * c, -sa, -sa * d], [sa * s, sa * c, ca, ca * d], [0, 0, 0, 1]]


def wrong_rounded(a, alpha, d, theta):
    """first digits only"""
    return np.round(right_two_halves(a, alpha, d, theta), 4)


def wrong_pair_for_the_pose(a, alpha, d, theta):
    """another form"""
    return rot_x(alpha) @ rot_z(theta), np.array([a, -d * np.sin(alpha), d * np.cos(alpha)])


def wrong_the_librarys(a, alpha, d, theta):
    """course_lib.arms.SerialArm is called"""
    return arms.SerialArm.from_dh([arms.DHRow(a, alpha, d, theta)]).fk([0.0])
