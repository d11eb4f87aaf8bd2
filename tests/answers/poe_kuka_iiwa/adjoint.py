"""What students write for adjoint(T)."""

import numpy as np

from course_lib import rigid
from course_lib.rotations import hat


def right_textbook(T):
    R, p = T[:3, :3], T[:3, 3]
    return np.block([[R, np.zeros((3, 3))], [hat(p) @ R, R]])


def right_filled_in(T):
    A = np.zeros((6, 6))
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


def right_R_and_p_in_the_frame_b(T):
    R, p = T[:3, :3], T[:3, 3]
    lower = np.hstack([R @ hat(R.T @ p), R])
    return np.vstack([np.hstack([R, 0 * R]), lower]).astype(complex)


def right_a_shift_and_a_turn(T):
    shift, turn = np.eye(6), np.kron(np.eye(2), T[:3, :3])
    shift[3:, :3] = hat(T[:3, 3])
    return shift @ turn


def wrong_inverse_in_the_upper_left(T):
    """unnamed"""
    R, p = T[:3, :3], T[:3, 3]
    return np.block([[np.linalg.inv(R), np.zeros((3, 3))], [hat(p) @ R, R]])


def wrong_p_alone(T):
    """[p] and R are in the wrong order, or R is missing or transposed in the lower left block"""
    R, p = T[:3, :3], T[:3, 3]
    return np.block([[R, np.zeros((3, 3))], [hat(p), R]])


def wrong_pose_carried(T):
    """the answer is 4 x 4"""
    return T @ T @ np.linalg.inv(T)


def wrong_poses_on_the_diagonal(T):
    """another form"""
    return np.kron(np.eye(2), T)


def wrong_p_vector_in_the_matrix(T):
    """ValueError"""
    A = np.zeros((6, 6))
    A[:3, :3] = A[3:, 3:] = T[:3, :3]
    A[3:, :3] = T[:3, :3] @ T[:3, 3:]  # (3, 1) spreads over the block
    A[:3, 3:] = np.zeros((2, 2))
    return A


def wrong_blocks_not_joined(T):
    """the four blocks stand in an array of arrays"""
    R, p = T[:3, :3], T[:3, 3]
    return np.array([[R, np.zeros((3, 3))], [hat(p) @ R, R]])


def wrong_the_librarys(T):
    """course_lib.rigid.adjoint is called"""
    return rigid.adjoint(T)
