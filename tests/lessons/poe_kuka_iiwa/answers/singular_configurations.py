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


def right_all_joints_backwards_as_lists():
    return (-right_by_the_text()).tolist()


def wrong_elbow_at_a_right_angle():
    """a configuration is not singular"""
    return right_by_the_text() + np.pi / 2 * (np.arange(21).reshape(3, 7) == 3)


def wrong_elbow_three_times():
    """it is not the family of its row alone"""
    return np.tile(right_by_the_text()[0], (3, 1))


def wrong_columns():
    """rows and columns have changed places"""
    return right_by_the_text().T
