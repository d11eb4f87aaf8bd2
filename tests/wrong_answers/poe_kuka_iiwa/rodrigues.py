"""What students write for rodrigues(omega, theta)."""

import numpy as np
import scipy.linalg
from scipy.spatial.transform import Rotation

from course_lib import rigid
from course_lib import rotations as rot
from course_lib.rotations import hat


def right_textbook(omega, theta):
    W = hat(omega)
    return np.eye(3) + np.sin(theta) * W + (1 - np.cos(theta)) * W @ W


def right_written_out(omega, theta):
    x, y, z = omega
    c, s, t = np.cos(theta), np.sin(theta), 1 - np.cos(theta)
    return [
        [c + x * x * t, x * y * t - z * s, x * z * t + y * s],
        [y * x * t + z * s, c + y * y * t, y * z * t - x * s],
        [z * x * t - y * s, z * y * t + x * s, c + z * z * t],
    ]


def right_matrix_exponential(omega, theta):
    return scipy.linalg.expm(theta * hat(omega))


def right_columns_turned(omega, theta):
    def turned(p):
        along = (omega @ p) * omega
        return along + np.cos(theta) * (p - along) + np.sin(theta) * np.cross(omega, p)

    return np.array([turned(e) for e in np.eye(3)]).T


def right_quaternion(omega, theta):
    return rot.quaternion_to_matrix(np.append(np.cos(theta / 2), np.sin(theta / 2) * omega))


def right_turned_about_z(omega, theta):
    x = np.cross(omega, np.eye(3)[np.argmin(abs(omega))])
    x = x / np.sqrt(x @ x)
    frame = np.column_stack([x, np.cross(omega, x), omega])
    return frame @ rot.rot_z(theta) @ frame.T


def right_series_of_the_wrapped_angle(omega, theta):
    theta = (theta + np.pi) % (2 * np.pi) - np.pi if abs(theta) > 4 else theta
    R, term = np.eye(3, dtype=complex), np.eye(3)
    for k in range(1, 40):
        term = term @ hat(omega) * theta / k
        R += term
    return R


def wrong_transposed(omega, theta):
    """R^T is returned"""
    W = -hat(omega)
    return np.eye(3) + np.sin(theta) * W + (1 - np.cos(theta)) * W @ W


def wrong_degrees(omega, theta):
    """degrees"""
    return right_textbook(omega, np.radians(theta))


def wrong_into_degrees(omega, theta):
    """degrees"""
    return right_textbook(omega, theta * 180 / np.pi)


def wrong_sign_of_theta_lost(omega, theta):
    """theta has lost its sign"""
    angle = np.linalg.norm(omega * theta)
    return right_textbook(omega, angle)


def wrong_theta_in_the_matrix_too(omega, theta):
    """multiplied by theta as well"""
    W = hat(omega * theta)
    return np.eye(3) + np.sin(theta) * W + (1 - np.cos(theta)) * W @ W


def wrong_theta_before_the_sine(omega, theta):
    """multiplied by theta as well"""
    W = hat(omega)
    return np.eye(3) + theta * np.sin(theta) * W + (1 - np.cos(theta)) * W @ W


def wrong_theta_not_used(omega, theta):
    """theta is not used"""
    return rot_of_vector(omega)


def rot_of_vector(w):
    angle = np.linalg.norm(w)
    return right_textbook(w / angle, angle)


def wrong_half_angle(omega, theta):
    """theta is halved"""
    return right_textbook(omega, theta / 2)


def wrong_full_angle_in_a_quaternion(omega, theta):
    """theta is doubled"""
    return rot.quaternion_to_matrix(np.append(np.cos(theta), np.sin(theta) * omega))


def wrong_square_left_out(omega, theta):
    """the term with [omega]^2 is left out"""
    return np.eye(3) + np.sin(theta) * hat(omega)


def wrong_sine_left_out(omega, theta):
    """the term with sin(theta) is left out"""
    return np.eye(3) + (1 - np.cos(theta)) * hat(omega) @ hat(omega)


def wrong_identity_left_out(omega, theta):
    """the identity is left out"""
    W = hat(omega)
    return np.sin(theta) * W + (1 - np.cos(theta)) * W @ W


def wrong_cosine(omega, theta):
    """cos stands where 1 - cos belongs"""
    W = hat(omega)
    return np.eye(3) + np.sin(theta) * W + np.cos(theta) * W @ W


def wrong_sign_of_the_square(omega, theta):
    """1 - cos has its sign changed"""
    W = hat(omega)
    return np.eye(3) + np.sin(theta) * W - (1 - np.cos(theta)) * W @ W


def wrong_one_minus_sine(omega, theta):
    """1 - sin stands where 1 - cos belongs"""
    W = hat(omega)
    return np.eye(3) + np.sin(theta) * W + (1 - np.sin(theta)) * W @ W


def wrong_sine_and_cosine_swapped(omega, theta):
    """sine and cosine are swapped"""
    W = hat(omega)
    return np.eye(3) + np.cos(theta) * W + (1 - np.sin(theta)) * W @ W


def wrong_theta_for_its_sine(omega, theta):
    """theta stands where sin(theta) belongs"""
    W = hat(omega)
    return np.eye(3) + theta * W + (1 - np.cos(theta)) * W @ W


def wrong_entry_by_entry(omega, theta):
    """entry by entry"""
    W = hat(omega)
    return np.eye(3) + np.sin(theta) * W + (1 - np.cos(theta)) * W**2


def wrong_not_squared(omega, theta):
    """[omega] is not squared"""
    W = hat(omega)
    return np.eye(3) + np.sin(theta) * W + (1 - np.cos(theta)) * W


def wrong_outer_product_with_the_identity(omega, theta):
    """two forms of the formula are mixed"""
    return np.eye(3) + np.sin(theta) * hat(omega) + (1 - np.cos(theta)) * np.outer(omega, omega)


def wrong_square_with_the_cosine(omega, theta):
    """two forms of the formula are mixed"""
    W = hat(omega)
    return np.cos(theta) * np.eye(3) + np.sin(theta) * W + (1 - np.cos(theta)) * W @ W


def wrong_transposed_in_the_square(omega, theta):
    """1 - cos has its sign changed"""
    W = hat(omega)
    return np.eye(3) + np.sin(theta) * W + (1 - np.cos(theta)) * W.T @ W


def wrong_exponential_of_each_entry(omega, theta):
    """np.exp takes each entry"""
    return np.exp(hat(omega) * theta)


def wrong_series_cut(omega, theta):
    """the series is cut"""
    W = hat(omega) * theta
    return np.eye(3) + W + W @ W / 2


def wrong_turns_in_a_row(omega, theta):
    """one turn after the other"""
    a, b, c = omega * theta
    return rot.rot_z(c) @ rot.rot_y(b) @ rot.rot_x(a)


def wrong_small_angles_cut(omega, theta):
    """small angles are cut off"""
    if np.isclose(theta, 0):
        return np.eye(3)
    return right_textbook(omega, theta)


def wrong_about_z_only(omega, theta):
    """unnamed"""
    return rot.rot_z(theta)


def wrong_ones_for_the_identity(omega, theta):
    """unnamed"""
    W = hat(omega)
    return np.ones((3, 3)) + np.sin(theta) * W + (1 - np.cos(theta)) * W @ W


def wrong_divided_by_theta(omega, theta):
    """divided by zero"""
    x, y, z = omega / np.float64(theta)
    W = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(theta) * W + (1 - np.cos(theta)) * W @ W


def wrong_pose(omega, theta):
    """another form"""
    T = np.eye(4)
    T[:3, :3] = right_textbook(omega, theta)
    return T


def wrong_axis_changed_in_place(omega, theta):
    """omega is changed in place"""
    omega *= theta
    return scipy.linalg.expm(hat(omega))


def wrong_the_librarys(omega, theta):
    """course_lib.rotations.exp_so3 is called"""
    return rot.exp_so3(omega * theta)


def wrong_the_librarys_by_way_of_the_pose(omega, theta):
    """course_lib.rigid.exp_se3 is called"""
    return rigid.exp_se3(np.append(omega * theta, [0, 0, 0]))[:3, :3]


def wrong_scipys(omega, theta):
    """scipy.spatial.transform.Rotation is called"""
    return Rotation.from_rotvec(omega * theta).as_matrix()
