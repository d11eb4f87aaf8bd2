"""What students write for inverse_rate_matrix(b)."""

import math

import numpy as np

from course_lib.rotations import rot_x, rot_y


def right_lists(b):
    b1, b2, _ = (float(angle) for angle in b)
    c, s, sine = math.cos(b1), math.sin(b1), math.sin(b2)
    cot = math.cos(b2) / sine
    return [[-s * cot, 1, -c * cot], [c, 0, -s], [s / sine, 0, c / sine]]


def right_cross_products_of_the_axes(b):
    ex, ey, _ = np.eye(3)
    a1, a2, a3 = ey, rot_y(b[0]) @ ex, rot_y(b[0]) @ rot_x(b[1]) @ ey
    return np.array([np.cross(a2, a3), np.cross(a3, a1), np.cross(a1, a2)]) / (a1 @ np.cross(a2, a3))


def right_factor_by_factor(b):
    cot, csc = 1 / np.tan(b[1]), 1 / np.sin(b[1])
    return np.array([[0, 1, -cot], [1, 0, 0], [0, 0, csc]]) @ rot_y(-b[0])


def wrong_zero_taken_too_far(b):
    """a small sin b2 is treated as if it were zero"""
    return right_lists(b) if abs(np.sin(b[1])) > 0.005 else np.zeros((3, 3))
