"""What students write for dh_standard(a, alpha, d, theta)."""

import math

import numpy as np

from course_lib import arms, rigid
from course_lib.rotations import rot_x, rot_z


def right_two_halves(a, alpha, d, theta):
    return rigid.transform(rot_z(theta), [0, 0, d]) @ rigid.transform(rot_x(alpha), [a, 0, 0])


def right_entry_by_entry_as_lists(a, alpha, d, theta):
    c, s, ca, sa = math.cos(theta), math.sin(theta), math.cos(alpha), math.sin(alpha)
    return [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]]


def right_inverse_of_the_modified_way_back(a, alpha, d, theta):
    back = rigid.transform(rot_x(-alpha), [-a, 0, 0]) @ rigid.transform(rot_z(-theta), [0, 0, -d])
    return np.linalg.inv(back)


def wrong_last_row_of_zeros(a, alpha, d, theta):
    """the last row is not"""
    return np.vstack([right_two_halves(a, alpha, d, theta)[:3], np.zeros(4)])


def wrong_angles_wrapped_to_a_half_turn(a, alpha, d, theta):
    """unnamed"""
    return right_two_halves(a, alpha % np.pi, d, theta % np.pi)


def wrong_the_librarys_frames(a, alpha, d, theta):
    """course_lib.arms._dh_frames is called"""
    return arms._dh_frames([(a, alpha, d, theta)], "standard")[0][0]
