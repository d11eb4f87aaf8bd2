"""What students write for arm_frames(theta)."""

import numpy as np
import scipy.linalg

from course_lib.planar import pose_matrix


def right_product_of_frames(theta):
    T_01 = pose_matrix([0, 0, theta[0]])
    T_02 = T_01 @ pose_matrix([1, 0, theta[1]])
    return np.array([T_01, T_02, T_02 @ pose_matrix([1, 0, 0])])


def right_product_of_exponentials(theta):
    first = np.array([[0, -1, 0], [1, 0, 0], [0, 0, 0]])
    second = np.array([[0, -1, 0], [1, 0, -1], [0, 0, 0]])  # about the point (1, 0)
    one = scipy.linalg.expm(first * theta[0])
    both = one @ scipy.linalg.expm(second * theta[1])
    at = [np.array([[1, 0, x], [0, 1, 0], [0, 0, 1]]) for x in (0, 1, 2)]
    return np.stack([one @ at[0], both @ at[1], both @ at[2]])


def right_loop_over_the_joints(theta):
    T, frames = np.eye(3), []
    for x, angle in ((0, theta[0]), (1, theta[1]), (1, 0.0)):
        c, s = np.cos(angle), np.sin(angle)
        T = (
            T
            @ np.array([[1, 0, x], [0, 1, 0], [0, 0, 1]])
            @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
        )
        frames.append(T)
    return tuple(frames)
