"""What students write for read_ur5e()."""

import numpy as np

from course_lib.rotations import rot_x

H, A, B = 0.1625, -0.425, -0.8172
OMEGA = np.array([[0, 0, 1], [0, -1, 0], [0, -1, 0], [0, -1, 0], [0, 0, -1], [0, -1, 0]])
POINTS = np.array([[0, 0, 0], [0, 0, H], [A, 0, H], [B, 0, H], [B, -0.1333, 0], [B, 0, 0.0628]])


def right_matrix_and_cross_products():
    M = np.array([[1, 0, 0, B], [0, 0, -1, -0.2329], [0, 1, 0, 0.0628], [0, 0, 0, 1]])
    return np.hstack([OMEGA, np.cross(POINTS, OMEGA)]), M


def right_other_points_on_the_axes():
    M = np.eye(4)
    M[:3, :3] = rot_x(np.pi / 2)
    M[:3, 3] = -(0.425 + 0.3922), -(0.1333 + 0.0996), 0.1625 - 0.0997
    points = POINTS + np.array([0.3, 2.0, -0.7, 0.1, 5.0, -1.0])[:, None] * OMEGA
    return np.column_stack([OMEGA, -np.cross(OMEGA, points + 1e-5)]), M


def right_as_lists():
    x, z = np.array([1.0, 0, 0]), np.array([0, -1.0, 0])
    M = np.column_stack([x, np.cross(z, x), z, [-0.8172, -0.2329, 0.0628]])
    return [[[*w, *-np.cross(w, p)] for w, p in zip(OMEGA, POINTS)], [*M.tolist(), [0, 0, 0, 1]]]


def wrong_lengths_of_the_iiwa():
    """the flange is not where it is drawn"""
    screws, M = right_matrix_and_cross_products()
    M[:3, 3] = 0, 0, 1.301
    return screws, M


def wrong_screws_alone():
    """the answer is not a pair"""
    return right_matrix_and_cross_products()[0]


def wrong_directions_and_points():
    """v is missing"""
    return OMEGA, right_matrix_and_cross_products()[1]
