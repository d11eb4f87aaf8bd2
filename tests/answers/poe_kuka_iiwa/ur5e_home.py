"""What students write for ur5e_home()."""

import numpy as np

from course_lib.rotations import rot_x


def right_matrix():
    return np.array([[1, 0, 0, -0.8172], [0, 0, -1, -0.2329], [0, 1, 0, 0.0628], [0, 0, 0, 1]])


def right_by_a_rotation_about_x():
    M = np.eye(4)
    M[:3, :3] = rot_x(np.pi / 2)
    M[:3, 3] = -(0.425 + 0.3922), -(0.1333 + 0.0996), 0.1625 - 0.0997
    return M


def right_columns_as_lists():
    x, z = np.array([1.0, 0, 0]), np.array([0, -1.0, 0])
    M = np.column_stack([x, np.cross(z, x), z, [-0.8172, -0.2329, 0.0628]])
    return [*M.tolist(), [0, 0, 0, 1]]


def wrong_length_of_the_iiwa():
    """unnamed"""
    M = right_matrix()
    M[:3, 3] = 0, 0, 1.301
    return M
