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


def wrong_joint_4_like_the_others():
    """the direction of one joint is reversed"""
    rows = np.array(right_table(), float)
    rows[3, 1] = 1
    return rows


def wrong_dots_and_crosses_mixed_up():
    """the arrows along y are reversed"""
    return np.array(right_table(), float) * [1, -1, 1, 1, 1, 1]


def wrong_lengths_of_links():
    """dimensions are not added up"""
    rows = np.array(right_table(), float)
    rows[[3, 5], 5] = 0.42, 0.4
    return rows


def wrong_millimetres():
    """lengths are in millimetres"""
    return np.array(right_table(), float) * [1, 1, 1, 1000, 1000, 1000]


def wrong_height_of_the_end():
    """one joint too high"""
    rows = np.array(right_table(), float)
    rows[[1, 3, 5], 5] = 0.78, 1.18, 1.301
    return rows


def wrong_no_points():
    """only the directions"""
    return np.array(right_table())[:, :3]


def wrong_points_first():
    """the points stand before the directions"""
    return np.roll(right_table(), 3, axis=1)


def wrong_screw_axes():
    """velocities v stand where points belong"""
    rows = np.array(right_table(), float)
    return np.column_stack([rows[:, :3], np.cross(rows[:, 3:], rows[:, :3])])


def wrong_axis_6_at_the_flange():
    """unnamed"""
    rows = np.array(right_table(), float)
    rows[5, 5] = 1.301
    return rows
