"""What students write for rotation_about(omega, point, theta)."""

import numpy as np
import scipy.linalg

from course_lib.rotations import hat


def _rotation(omega, theta):
    return np.eye(3) + np.sin(theta) * hat(omega) + (1 - np.cos(theta)) * hat(omega) @ hat(omega)


def _pair(R, p):
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, p
    return np.array([T, np.linalg.inv(T)])


def right_textbook(omega, point, theta):
    R = _rotation(omega, theta)
    return _pair(R, point - R @ point)


def right_list_of_two_by_the_matrix_exponential(omega, point, theta):
    R = scipy.linalg.expm(theta * hat(omega))
    return _pair(R, (np.eye(3) - R) @ point).tolist()


def right_shift_rotate_shift_back(omega, point, theta):
    def there_and_back(angle):
        shift, turn = np.eye(4), np.eye(4)
        shift[:3, 3], turn[:3, :3] = point, _rotation(omega, angle)
        return shift @ turn @ np.linalg.inv(shift)

    return there_and_back(theta), there_and_back(-theta)


def wrong_small_rotation_is_none(omega, point, theta):
    """a small rotation counts as none"""
    W = hat(omega)
    R = np.eye(3) + np.sin(theta) * W + (1 - np.cos(theta)) * W @ W
    if abs(theta) < 1e-5:
        R = np.eye(3)
    p = point - R @ point
    T = np.block([[R, p[:, None]], [np.zeros(3), 1]])
    return np.array([T, np.linalg.inv(T)])
