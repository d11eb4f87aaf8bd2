"""What students write for hat_se3(twist)."""

import numpy as np
import scipy.linalg

from course_lib import rigid
from course_lib.rotations import hat


def right_filled_in(twist):
    V = np.zeros((4, 4))
    V[:3, :3] = hat(twist[:3])
    V[:3, 3] = twist[3:]
    return V


def right_written_out(twist):
    w1, w2, w3, v1, v2, v3 = twist
    return [[0, -w3, w2, v1], [w3, 0, -w1, v2], [-w2, w1, 0, v3], [0, 0, 0, 0]]


def right_blocks(twist):
    omega, v = np.split(twist, 2)
    return np.block([[hat(omega), v[:, None]], [np.zeros((1, 4))]])


def right_rows_on_top_of_each_other(twist):
    return np.vstack([np.column_stack([np.cross(twist[:3], np.eye(3)).T, twist[3:]]), np.zeros(4)])


def right_sum_of_six_generators(twist):
    V = np.zeros((4, 4), dtype=complex)
    for k in range(3):
        i, j = (k + 1) % 3, (k + 2) % 3
        V[j, i] += twist[k]
        V[i, j] -= twist[k]
        V[k, 3] += twist[3 + k]
    return V


def wrong_minus_v(twist):
    """v has its sign changed"""
    return [*np.column_stack([hat(twist[:3]), -twist[3:]]), np.zeros(4)]


def wrong_three_rows(twist):
    """the last row is missing"""
    return np.hstack([hat(twist[:3]), twist[3:].reshape(3, 1)])


def wrong_block_alone(twist):
    """the block [omega] alone"""
    return hat(twist[:3])


def wrong_v_first_row_on_top(twist):
    """unnamed"""
    V = np.zeros((4, 4))
    V[1:, 1:], V[1:, 0] = hat(twist[:3]), twist[3:]
    return V


def wrong_index_one_too_far(twist):
    """IndexError"""
    V = np.zeros((4, 4))
    V[:3, :3] = hat(twist[:3])
    V[0, 3], V[1, 3], V[2, 3] = twist[4], twist[5], twist[6]
    return V


def wrong_v_into_a_row_of_four(twist):
    """ValueError"""
    V = np.zeros((4, 4))
    V[:3, :3] = hat(twist[:3])
    V[:, 3] = twist[3:]
    return V


def wrong_the_librarys(twist):
    """course_lib.rigid.hat_se3 is called"""
    return rigid.hat_se3(twist)


def wrong_whole_numbers(twist):
    """digits after the point are cut off"""
    x, y, z, *v = twist
    return np.array([[0, -z, y, v[0]], [z, 0, -x, v[1]], [-y, x, 0, v[2]], [0, 0, 0, 0]]).astype(int)
