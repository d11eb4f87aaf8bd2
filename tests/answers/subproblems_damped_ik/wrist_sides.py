"""What students write for wrist_sides(R, b), whose cell holds broken code."""

import numpy as np

from course_lib.rotations import rot_x, rot_y

ex, ey, ez = np.eye(3)


def right_other_order(R, b):
    return np.array([rot_y(-b[0]) @ R @ ey, rot_x(b[1]) @ rot_y(b[0]) @ ey])  # Ry(b1) e_y is e_y


def right_multiplied_by_the_inverse(R, b):
    left, right = R @ ey, rot_y(b[0]) @ rot_x(b[1]) @ ey
    return [rot_y(b[0]).T @ left, rot_y(b[0]).T @ right]


def right_by_entries(R, b):
    c1, s1 = np.cos(b[0]), np.sin(b[0])
    left = [c1 * R[0, 1] - s1 * R[2, 1], R[1, 1], s1 * R[0, 1] + c1 * R[2, 1]]
    return left, [0, np.cos(b[1]), np.sin(b[1])]


def wrong_difference(R, b):
    """another form"""
    return rot_y(-b[0]) @ R @ ey - rot_x(b[1]) @ ey
