"""What students write for read_iiwa()."""

import numpy as np

X, Y, Z = np.eye(3)


def right_table():
    return [
        [0, 0, 1, 0, 0, 0],
        [0, 1, 0, 0, 0, 0.36],
        [0, 0, 1, 0, 0, 0],
        [0, -1, 0, 0, 0, 0.78],
        [0, 0, 1, 0, 0, 0],
        [0, 1, 0, 0, 0, 1.18],
        [0, 0, 1, 0, 0, 0],
    ]


def right_other_points_on_the_axes():
    rows = np.array(right_table(), float)
    rows[:, 3:] += np.array([0.3, 2.0, -0.7, 0.1, 5.0, -1.0, 9.0])[:, None] * rows[:, :3]
    return rows


def right_each_joint_at_its_height():
    omega = [Z, Y, Z, -Y, Z, Y, Z]
    return np.column_stack([omega, np.outer([0, 0.36, 0.36, 0.78, 0.78, 1.18, 1.301], Z)])


def wrong_axis_6_at_the_flange():
    """unnamed"""
    rows = np.array(right_table(), float)
    rows[5, 5] = 1.301
    return rows
