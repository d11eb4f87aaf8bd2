"""What students write for adjoint(T)."""

import numpy as np

from course_lib.rotations import hat


def right_filled_in(T):
    A = np.zeros((6, 6), complex)
    A[:3, :3] = A[3:, 3:] = T[:3, :3]
    A[3:, :3] = np.cross(T[:3, 3], T[:3, :3], axisb=0).T
    return A


def right_column_by_column(T):
    columns = []
    for twist in np.eye(6):
        V = np.zeros((4, 4))
        V[:3, :3], V[:3, 3] = hat(twist[:3]), twist[3:]
        W = T @ V @ np.linalg.inv(T)
        columns.append([W[2, 1], W[0, 2], W[1, 0], W[0, 3], W[1, 3], W[2, 3]])
    return [list(row) for row in zip(*columns)]


def right_a_shift_and_a_turn(T):
    shift, turn = np.eye(6), np.kron(np.eye(2), T[:3, :3])
    shift[3:, :3] = hat(T[:3, 3])
    return shift @ turn


def wrong_inverse_in_the_upper_left(T):
    """the upper left block is not R"""
    A = right_a_shift_and_a_turn(T)
    A[:3, :3] = A[:3, :3].T @ A[:3, :3].T
    return A
