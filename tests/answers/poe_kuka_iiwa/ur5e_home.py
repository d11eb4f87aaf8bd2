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


def wrong_parallel_to_the_base():
    """parallel to the base"""
    M = np.eye(4)
    M[:3, 3] = -0.8172, -0.2329, 0.0628
    return M


def wrong_x_positive():
    """a sign of p"""
    M = right_matrix()
    M[0, 3] *= -1
    return M


def wrong_y_positive():
    """a sign of p"""
    M = right_matrix()
    M[1, 3] *= -1
    return M


def wrong_drop_added():
    """the height is wrong"""
    M = right_matrix()
    M[2, 3] = 0.1625 + 0.0997
    return M


def wrong_flange_at_joint_6():
    """from axis 5 to the flange, is left out"""
    M = right_matrix()
    M[1, 3] = -0.1333
    return M


def wrong_rows_for_columns():
    """R is transposed"""
    M = right_matrix()
    M[:3, :3] = M[:3, :3].T
    return M


def wrong_left_handed():
    """no right-handed frame"""
    M = right_matrix()
    M[:3, 1] *= -1
    return M


def wrong_millimetres():
    """millimetres"""
    M = right_matrix()
    M[:3, 3] *= 1000
    return M


def wrong_position_only():
    """only the position"""
    return right_matrix()[:3, 3]


def wrong_length_of_the_iiwa():
    """unnamed"""
    M = right_matrix()
    M[:3, 3] = 0, 0, 1.301
    return M
