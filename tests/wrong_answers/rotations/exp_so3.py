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


def wrong_zero_not_asked(w):
    """w = 0 is divided by its length, which is 0"""
    angle = np.linalg.norm(w)
    x, y, z = w / angle
    N = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(angle) * N + (1 - np.cos(angle)) * N @ N


def wrong_tiny_angles_cut(w):
    """small angles are lost"""
    angle = np.linalg.norm(w)
    if np.isclose(angle, 0):
        return np.eye(3)
    N = hat(w / angle)
    return np.eye(3) + np.sin(angle) * N + (1 - np.cos(angle)) * N @ N


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


def wrong_turns_about_the_axes_in_a_row(w):
    """the rotations about x, y and z are multiplied"""
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


def _R(a, n):
    return np.eye(3) + np.sin(a) * hat(n) + (1 - np.cos(a)) * hat(n) @ hat(n)


def wrong_zero_returned_for_zero(w):
    """another form"""
    a = np.linalg.norm(w)
    return 0 if a == 0 else _R(a, w / a)


def wrong_squared_length(w):
    """the square of the length stands for the length"""
    a = w @ w
    if a == 0:
        return np.eye(3)
    n = w / a
    return np.eye(3) + np.sin(a) * hat(n) + (1 - np.cos(a)) * hat(n) @ hat(n)


def wrong_any_entry_zero_taken_for_zero(w):
    """w counts as zero as soon as one of its entries is zero"""
    if not w.all():
        return np.eye(3)
    a = np.linalg.norm(w)
    return _R(a, w / a)


def wrong_brackets_around_one_minus_cosine(w):
    """brackets"""
    a = np.linalg.norm(w)
    if a == 0:
        return np.eye(3)
    N = hat(w / a)
    return np.eye(3) + np.sin(a) * N + 1 - np.cos(a) * N @ N


def wrong_elementwise_outer_product(w):
    """n * n"""
    a = np.linalg.norm(w)
    if a == 0:
        return np.eye(3)
    n = w / a
    return np.cos(a) * np.eye(3) + np.sin(a) * hat(n) + (1 - np.cos(a)) * n * n


def wrong_sign_in_own_hat(w):
    """[n] has a wrong sign in one entry"""
    a = np.linalg.norm(w)
    if a == 0:
        return np.eye(3)
    x, y, z = w / a
    N = np.array([[0, -z, y], [z, 0, x], [-y, x, 0]])
    return np.eye(3) + np.sin(a) * N + (1 - np.cos(a)) * N @ N


def wrong_allclose_to_zero(w):
    """small angles are lost"""
    if np.allclose(w, 0):
        return np.eye(3)
    a = np.linalg.norm(w)
    return _R(a, w / a)


def wrong_seven_terms_of_the_series(w):
    """the series of the exponential is cut"""
    R = term = np.eye(3)
    for k in range(1, 7):
        term = term @ hat(w) / k
        R = R + term
    return R


def wrong_square_entry_by_entry(w):
    """entry by entry"""
    a = np.linalg.norm(w)
    if a == 0:
        return np.eye(3)
    N = hat(w / a)
    return np.eye(3) + np.sin(a) * N + (1 - np.cos(a)) * N**2
