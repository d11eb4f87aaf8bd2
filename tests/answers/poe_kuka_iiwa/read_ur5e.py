"""What students write for read_ur5e()."""

import numpy as np

H, A, B = 0.1625, -0.425, -0.8172


def right_table():
    return [
        [0, 0, 1, 0, 0, 0],
        [0, -1, 0, 0, 0, H],
        [0, -1, 0, A, 0, H],
        [0, -1, 0, B, 0, H],
        [0, 0, -1, B, -0.1333, 0],
        [0, -1, 0, B, 0, 0.0628],
    ]


def right_other_points_on_the_axes():
    rows = np.array(right_table(), float)
    rows[:, 3:] += np.array([0.3, 2.0, -0.7, 0.1, 5.0, -1.0])[:, None] * rows[:, :3]
    return rows


def right_omega_and_points_stacked():
    rows = np.array(right_table())
    omega, points = rows[:, :3], rows[:, 3:]
    return np.column_stack([omega, points + 1e-5])


def wrong_arm_along_plus_x():
    """x is reversed"""
    rows = np.array(right_table(), float)
    rows[:, 3] *= -1
    return rows


def wrong_all_along_plus_y():
    """the arrows along y are reversed"""
    rows = np.array(right_table(), float)
    rows[:, 1] = abs(rows[:, 1])
    return rows


def wrong_axis_5_up():
    """the direction of one joint is reversed"""
    rows = np.array(right_table(), float)
    rows[4, 2] = 1
    return rows


def wrong_axis_5_above_the_origin():
    """not added up from the base"""
    rows = np.array(right_table(), float)
    rows[4, 3:] = 0, -0.1333, 0
    return rows


def wrong_forearm_alone_for_the_wrist():
    """not added up from the base"""
    rows = np.array(right_table(), float)
    rows[3:, 3] = -0.3922
    return rows


def wrong_millimetres():
    """millimetres"""
    rows = np.array(right_table(), float)
    rows[:, 3:] *= 1000
    return rows


def wrong_points_first():
    """the points stand before the directions"""
    return np.roll(np.array(right_table(), float), 3, axis=1)


def wrong_screw_axes():
    """velocities v stand where points belong"""
    rows = np.array(right_table(), float)
    return np.hstack([rows[:, :3], np.cross(rows[:, 3:], rows[:, :3])])


def wrong_axis_6_at_the_height_of_axis_4():
    """axis 6 is at the height of axes 2 to 4"""
    rows = np.array(right_table(), float)
    rows[5, 5] = H
    return rows


def wrong_directions_only():
    """only the directions"""
    return np.array(right_table(), float)[:, :3]


def wrong_screws_from_the_shoulder():
    """heights are counted from the shoulder"""
    rows = np.array(right_table(), float)
    rows[:, 5] -= H
    return rows
