"""What students write for singular_configurations()."""

import numpy as np


def right_by_the_text():
    rows = np.tile([0.2, 0.6, 0.3, -1.2, 0.4, 1.0, 0.0], (3, 1))
    rows[0, 3] = 0
    rows[1, 1], rows[1, 2] = 0, np.pi / 2
    rows[2, 5], rows[2, 4] = 0, np.pi / 2
    return rows


def right_negative_right_angles():
    return [
        [0, -0.5, 0.1, 0, 1, 0.7, 0],
        [0, 0, -np.pi / 2, 1.0, 1, 0.7, 0],
        [0, -0.5, 0.1, 1.0, -np.pi / 2, 0, 0],
    ]


def right_other_numbers():
    generic = np.array([1.0, 0.4, 0.9, -0.8, -1.1, -0.6, 2.0])
    return np.array([np.where(np.arange(7) == 3, 0, generic), *_others(generic)])


def _others(generic):
    shoulder, wrist = generic.copy(), generic.copy()
    shoulder[1:3], wrist[4:6] = (0, np.pi / 2), (np.pi / 2, 0)
    return shoulder, wrist


def wrong_zeros_but_for_the_family():
    """several singularities"""
    rows = np.zeros((3, 7))
    rows[1, 2] = rows[2, 4] = np.pi / 2
    return rows


def wrong_elbow_at_a_right_angle():
    """a configuration is not singular"""
    rows = np.array(right_by_the_text())
    rows[0, 3] = np.pi / 2
    return rows


def wrong_elbow_three_times():
    """two rows are of one family"""
    return np.tile(right_by_the_text()[0], (3, 1))


def wrong_columns():
    """rows and columns are swapped"""
    return np.array(right_by_the_text()).T
