"""What students write for hat_se3(twist)."""

import numpy as np

from course_lib.rotations import hat


def right_filled_in(twist):
    V = np.zeros((4, 4), dtype=complex)
    V[:3, :3] = hat(twist[:3])
    V[:3, 3] = twist[3:]
    return V


def right_written_out(twist):
    w1, w2, w3, v1, v2, v3 = twist
    return [[0, -w3, w2, v1], [w3, 0, -w1, v2], [-w2, w1, 0, v3], [0, 0, 0, 0]]


def right_rows_on_top_of_each_other(twist):
    return np.vstack([np.column_stack([np.cross(twist[:3], np.eye(3)).T, twist[3:]]), np.zeros(4)])


def wrong_slow_is_still(twist):
    """a small omega, or a small twist, counts as 0"""
    twist = np.asarray(twist, float)
    V = np.zeros((4, 4))
    V[:3, 3] = twist[3:]
    if np.linalg.norm(twist[:3]) > 1e-9:
        V[:3, :3] = hat(twist[:3])
    return V


def wrong_nearly_a_unit_vector(twist):
    """the answer is right to its first digits only"""
    V = right_filled_in(np.asarray(twist, float)).real
    length = np.linalg.norm(twist[:3])
    if abs(length - 1) < 1e-3:
        V[:3, :3] /= length
    return V
