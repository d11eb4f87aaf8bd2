"""What students write for exp_so3(w)."""

import numpy as np
import scipy.linalg

from course_lib.rotations import exp_so3 as textbook
from course_lib.rotations import hat, rot_z


def right_rodrigues(w):
    angle = np.linalg.norm(w)
    if angle == 0:
        return np.eye(3)
    N = hat(w / angle)
    return np.eye(3) + np.sin(angle) * N + (1 - np.cos(angle)) * N @ N


def right_matrix_exponential(w):
    return scipy.linalg.expm(hat(w)).tolist()


def right_by_quaternion(w):
    angle = np.sqrt(w @ w)
    half = angle / 2
    s = np.cos(half)
    x, y, z = np.sinc(half / np.pi) / 2 * w
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - s * z), 2 * (x * z + s * y)],
        [2 * (x * y + s * z), 1 - 2 * (x * x + z * z), 2 * (y * z - s * x)],
        [2 * (x * z - s * y), 2 * (y * z + s * x), 1 - 2 * (x * x + y * y)],
    ]


def right_column_by_column(w):
    angle = np.linalg.norm(w)
    n = w / angle if angle > 0 else w
    c, s = np.cos(angle), np.sin(angle)
    columns = [c * e + s * np.cross(n, e) + (1 - c) * (n @ e) * n for e in np.eye(3)]
    return np.column_stack(columns)


def right_turned_about_z_in_another_frame(w):
    angle = np.linalg.norm(w)
    if not angle:
        return np.eye(3, dtype=int)
    n = w / angle
    x = np.cross(n, np.eye(3)[np.argmin(abs(n))])
    x /= np.linalg.norm(x)
    frame = np.array([x, np.cross(n, x), n]).T
    return np.einsum("ij,jk,lk->il", frame, rot_z(angle), frame)


def right_series(w):
    R = term = np.eye(3)
    for k in range(1, 60):
        term = term @ hat(w) / k
        R = R + term
    return R.astype(complex)


def wrong_transposed(w):
    """R^T is returned"""
    angle = np.linalg.norm(w)
    if angle == 0:
        return np.eye(3)
    N = hat(w / angle).T
    return np.eye(3) + np.sin(angle) * N + (1 - np.cos(angle)) * N @ N


def wrong_axis_not_normalised(w):
    """w is not divided by its length"""
    angle = np.linalg.norm(w)
    return np.eye(3) + np.sin(angle) * hat(w) + (1 - np.cos(angle)) * hat(w) @ hat(w)


def wrong_degrees(w):
    """degrees"""
    angle = np.linalg.norm(w)
    if angle == 0:
        return np.eye(3)
    N = hat(w / angle)
    angle = np.deg2rad(angle)
    return np.eye(3) + np.sin(angle) * N + (1 - np.cos(angle)) * N @ N


def wrong_no_division_by_zero_avoided(w):
    """divided by zero"""
    angle = np.linalg.norm(w)
    N = hat(w / angle) if angle > 0 else np.full((3, 3), np.nan)
    return np.eye(3) + np.sin(angle) * N + (1 - np.cos(angle)) * N @ N


def wrong_zero_not_asked(w):
    """divided by zero"""
    angle = np.linalg.norm(w)
    x, y, z = w / angle
    N = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * N + (1 - np.cos(angle)) * N @ N


def wrong_small_angles_cut(w):
    """small angles are cut off"""
    angle = np.linalg.norm(w)
    if angle < 1e-3:
        return np.eye(3)
    N = hat(w / angle)
    return np.eye(3) + np.sin(angle) * N + (1 - np.cos(angle)) * N @ N


def wrong_tiny_angles_cut(w):
    """small angles are cut off"""
    angle = np.linalg.norm(w)
    if np.isclose(angle, 0):
        return np.eye(3)
    N = hat(w / angle)
    return np.eye(3) + np.sin(angle) * N + (1 - np.cos(angle)) * N @ N


def wrong_square_left_out(w):
    """the term with [n]^2 is left out"""
    angle = np.linalg.norm(w)
    if angle == 0:
        return np.eye(3)
    return np.eye(3) + np.sin(angle) * hat(w / angle)


def wrong_cosine(w):
    """cos stands where 1 - cos belongs"""
    angle = np.linalg.norm(w)
    if angle == 0:
        return np.eye(3)
    N = hat(w / angle)
    return np.eye(3) + np.sin(angle) * N + np.cos(angle) * N @ N


def wrong_sign_of_the_square(w):
    """1 - cos has its sign changed"""
    angle = np.linalg.norm(w)
    if angle == 0:
        return np.eye(3)
    N = hat(w / angle)
    return np.eye(3) + np.sin(angle) * N - (1 - np.cos(angle)) * N @ N


def wrong_entry_by_entry(w):
    """entry by entry"""
    angle = np.linalg.norm(w)
    if angle == 0:
        return np.eye(3)
    N = hat(w / angle)
    return np.eye(3) + np.sin(angle) * N + (1 - np.cos(angle)) * N**2


def wrong_exponential_of_each_entry(w):
    """np.exp takes each entry"""
    return np.exp(hat(w))


def wrong_sine_and_cosine_swapped(w):
    """sine and cosine are swapped"""
    angle = np.linalg.norm(w)
    if angle == 0:
        return np.eye(3)
    N = hat(w / angle)
    return np.eye(3) + np.cos(angle) * N + (1 - np.sin(angle)) * N @ N


def wrong_angle_halved(w):
    """the angle is halved"""
    angle = np.linalg.norm(w)
    if angle == 0:
        return np.eye(3)
    N = hat(w / angle)
    return np.eye(3) + np.sin(angle / 2) * N + (1 - np.cos(angle / 2)) * N @ N


def wrong_sine_left_out(w):
    """the term with sin(a) is left out"""
    angle = np.linalg.norm(w)
    if angle == 0:
        return np.eye(3)
    N = hat(w / angle)
    return np.eye(3) + (1 - np.cos(angle)) * N @ N


def wrong_identity_missing(w):
    """the identity is left out"""
    angle = np.linalg.norm(w)
    if angle == 0:
        return np.eye(3)
    N = hat(w / angle)
    return np.sin(angle) * N + (1 - np.cos(angle)) * N @ N


def wrong_angle_not_halved(w):
    """the angle is doubled"""
    angle = np.linalg.norm(w)
    if angle == 0:
        return np.eye(3)
    s, (x, y, z) = np.cos(angle), np.sin(angle) * w / angle
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - s * z), 2 * (x * z + s * y)],
        [2 * (x * y + s * z), 1 - 2 * (x * x + z * z), 2 * (y * z - s * x)],
        [2 * (x * z - s * y), 2 * (y * z + s * x), 1 - 2 * (x * x + y * y)],
    ]


def wrong_series_cut(w):
    """the series is cut"""
    return np.eye(3) + hat(w) + hat(w) @ hat(w) / 2


def wrong_turns_about_the_axes_in_a_row(w):
    """one turn after the other"""
    cx, cy, cz = np.cos(w)
    sx, sy, sz = np.sin(w)
    X = np.array([[1, 0, 0], [0, cx, -sx], [0, sx, cx]])
    Y = np.array([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]])
    Z = np.array([[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]])
    return Z @ Y @ X


def wrong_changed_in_place(w):
    """w is changed in place"""
    angle = np.linalg.norm(w)
    if angle == 0:
        return np.eye(3)
    w /= angle
    return np.eye(3) + np.sin(angle) * hat(w) + (1 - np.cos(angle)) * hat(w) @ hat(w)


def wrong_about_z_only(w):
    """unnamed"""
    return rot_z(w[2])


def wrong_the_librarys(w):
    """course_lib.rotations.exp_so3 is called"""
    return textbook(w)
