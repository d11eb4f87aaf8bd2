"""What students write for rate_matrix(b)."""

import math

import numpy as np
from scipy.spatial.transform import Rotation

from course_lib.lessons.subproblems_damped_ik.exercises.rate_matrix import rates
from course_lib.rotations import rot_x, rot_y, vee


def right_lists(b):
    b1, b2, _ = (float(angle) for angle in b)
    c1, s1, c2, s2 = math.cos(b1), math.sin(b1), math.cos(b2), math.sin(b2)
    return [[0, c1, s1 * s2], [1, 0, c2], [0, -s1, c1 * s2]]


def right_central_differences(b):
    def R(b):
        return rot_y(b[0]) @ rot_x(b[1]) @ rot_y(b[2])

    h, A = 1e-5, np.zeros((3, 3))
    for j, e in enumerate(np.eye(3)):
        W = (R(b + h * e) - R(b - h * e)) / (2 * h) @ R(b).T
        A[:, j] = vee((W - W.T) / 2)
    return A


def right_rotations_of_scipy(b):
    first = Rotation.from_euler("y", b[0])
    both = first * Rotation.from_euler("x", b[1])
    return np.array([[0, 1, 0], first.apply([1, 0, 0]), both.apply([0, 1, 0])]).T.astype(complex)


def wrong_sine_from_the_root(b):
    """the answers to some inputs only are wrong"""
    A = rates(b)
    sine = np.sign(b[1]) * np.sqrt(1 - np.cos(b[1]) ** 2)
    A[::2, 2] = sine * np.sin(b[0]), sine * np.cos(b[0])
    return A
