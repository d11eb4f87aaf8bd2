"""What students write for rotation_about(omega, point, theta)."""

import numpy as np
import scipy.linalg
from scipy.spatial.transform import Rotation

from course_lib import rigid
from course_lib import rotations as rot
from course_lib.rotations import hat


def _rotation(omega, theta):
    W = hat(omega)
    return np.eye(3) + np.sin(theta) * W + (1 - np.cos(theta)) * W @ W


def _pair(R, p):
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, p
    return np.array([T, np.linalg.inv(T)])


def right_textbook(omega, point, theta):
    R = _rotation(omega, theta)
    p = point - R @ point
    T, back = np.eye(4), np.eye(4)
    T[:3, :3], T[:3, 3] = R, p
    back[:3, :3], back[:3, 3] = R.T, -R.T @ p
    return np.array([T, back])


def right_list_of_two_with_numpys_inverse(omega, point, theta):
    R = scipy.linalg.expm(theta * hat(omega))
    return _pair(R, (np.eye(3) - R) @ point).tolist()


def right_shift_rotate_shift_back(omega, point, theta):
    def there_and_back(angle):
        shift, turn = np.eye(4), np.eye(4)
        shift[:3, 3], turn[:3, :3] = point, _rotation(omega, angle)
        return shift @ turn @ np.linalg.inv(shift)

    return there_and_back(theta), there_and_back(-theta)


def right_written_out(omega, point, theta):
    x, y, z = omega
    c, s, t = np.cos(theta), np.sin(theta), 1 - np.cos(theta)
    R = np.array(
        [
            [c + x * x * t, x * y * t - z * s, x * z * t + y * s],
            [y * x * t + z * s, c + y * y * t, y * z * t - x * s],
            [z * x * t - y * s, z * y * t + x * s, c + z * z * t],
        ]
    )
    return _pair(R, point - R @ point)


def wrong_point_as_p(omega, point, theta):
    """p is the point itself"""
    return _pair(_rotation(omega, theta), point)


def wrong_through_the_origin(omega, point, theta):
    """p = 0"""
    return _pair(_rotation(omega, theta), 0 * point)


def wrong_shifts_in_the_other_order(omega, point, theta):
    """p has its sign changed"""
    R = _rotation(omega, theta)
    return _pair(R, R @ point - point)


def wrong_inverse_by_transposing_everything(omega, point, theta):
    """the second matrix is not an inverse"""
    T = right_textbook(omega, point, theta)[0]
    return np.array([T, T.T])


def wrong_inverse_without_rotating_p(omega, point, theta):
    """the last column of the inverse"""
    T, back = right_textbook(omega, point, theta)
    back[:3, 3] = -T[:3, 3]
    return np.array([T, back])


def wrong_inverse_by_minus_theta_about_the_origin(omega, point, theta):
    """the last column of the inverse"""
    T, back = right_textbook(omega, point, theta)
    back[:3, 3] = 0
    return T, back


def wrong_clockwise(omega, point, theta):
    """clockwise"""
    R = _rotation(omega, theta).T
    return _pair(R, point - R @ point)


def wrong_one_pose_only(omega, point, theta):
    """one matrix is returned"""
    return right_textbook(omega, point, theta)[0]


def wrong_square_entry_by_entry(omega, point, theta):
    """not a product of two matrices"""
    W = hat(omega)
    R = np.eye(3) + np.sin(theta) * W + (1 - np.cos(theta)) * W**2
    return _pair(R, point - R @ point)


def wrong_degrees(omega, point, theta):
    """degrees"""
    return right_textbook(omega, point, np.radians(theta))


def wrong_theta_in_the_matrix_as_well(omega, point, theta):
    """theta multiplies [omega] too"""
    W = hat(omega * theta)
    R = np.eye(3) + np.sin(theta) * W + (1 - np.cos(theta)) * W @ W
    return _pair(R, point - R @ point)


def wrong_always_about_z(omega, point, theta):
    """unnamed"""
    R = rot.rot_z(theta)
    return _pair(R, point - R @ point)


def wrong_point_changed_in_place(omega, point, theta):
    """point is changed in place"""
    R = _rotation(omega, theta)
    point -= R @ point
    return _pair(R, point)


def wrong_scipys(omega, point, theta):
    """scipy.spatial.transform.Rotation is called"""
    R = Rotation.from_rotvec(omega * theta).as_matrix()
    return _pair(R, point - R @ point)


def wrong_the_librarys(omega, point, theta):
    """course_lib.rigid.exp_se3 is called"""
    T = rigid.exp_se3(np.append(omega, np.cross(point, omega)) * theta)
    return T, np.linalg.inv(T)


def wrong_sine_and_versine_swapped(omega, point, theta):
    """the terms of Rodrigues' formula are not all there, or have the wrong factor"""
    W = hat(omega)
    R = np.eye(3) + (1 - np.cos(theta)) * W + np.sin(theta) * W @ W
    return _pair(R, point - R @ point)


def wrong_one_plus_the_cosine(omega, point, theta):
    """the terms of Rodrigues' formula are not all there, or have the wrong factor"""
    W = hat(omega)
    R = np.eye(3) + np.sin(theta) * W + (1 + np.cos(theta)) * W @ W
    return _pair(R, point - R @ point)
