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
