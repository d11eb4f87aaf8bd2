"""What students write for dh_modified(a, alpha, d, theta)."""

import math

import numpy as np

from course_lib import arms, rigid
from course_lib.rotations import rot_x, rot_z


def right_two_halves(a, alpha, d, theta):
    return rigid.transform(rot_x(alpha), [a, 0, 0]) @ rigid.transform(rot_z(theta), [0, 0, d])


def right_entry_by_entry_as_lists(a, alpha, d, theta):
    ca, sa, c, s = math.cos(alpha), math.sin(alpha), math.cos(theta), math.sin(theta)
    return [
        [c, -s, 0, a],
        [ca * s, ca * c, -sa, -sa * d],
        [sa * s, sa * c, ca, ca * d],
        [0, 0, 0, 1],
    ]


def right_two_screws(a, alpha, d, theta):
    return rigid.exp_se3([alpha, 0, 0, a, 0, 0]) @ rigid.exp_se3([0, 0, theta, 0, 0, d])


def wrong_steps_apart(a, alpha, d, theta):
    """not their product"""
    return [rigid.transform(rot_x(alpha), [a, 0, 0]), rigid.transform(rot_z(theta), [0, 0, d])]


def wrong_the_librarys(a, alpha, d, theta):
    """course_lib.arms.SerialArm is called"""
    return arms.SerialArm.from_dh([arms.DHRow(a, alpha, d, theta)]).fk([0.0])


def wrong_small_entries_set_to_0(a, alpha, d, theta):
    """small entries are set to 0, or rounded"""
    T = right_two_halves(a, alpha, d, theta)
    T[np.abs(T) < 1e-4] = 0
    return T


def wrong_entry_by_entry(a, alpha, d, theta):
    """the two poses are multiplied entry by entry"""
    along_x = rigid.transform(rot_x(alpha), [a, 0, 0])
    return along_x * rigid.transform(rot_z(theta), [0, 0, d])


def wrong_whole_entries_for_a_whole_a(a, alpha, d, theta):
    """digits after the point are cut off"""
    T = np.full((4, 4), 0 * a)
    T[:] = right_two_halves(a, alpha, d, theta)
    return T


def wrong_cosine_from_the_sine(a, alpha, d, theta):
    """the answers to some inputs only are wrong"""
    s = math.sin(alpha)
    c = math.copysign(math.sqrt(max(0, 1 - s * s)), math.cos(alpha))
    along_x = rigid.transform(np.array([[1, 0, 0], [0, c, -s], [0, s, c]]), [a, 0, 0])
    return along_x @ rigid.transform(rot_z(theta), [0, 0, d])
