"""What students write for exp_se3(twist)."""

import math

import numpy as np
import scipy.linalg

from course_lib import rigid
from course_lib.rotations import exp_so3
from course_lib.rotations import hat as librarys_hat


def hat(w):
    return np.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])


def _matrix(R, p):
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, p
    return T


def _unit(omega):
    """The angle and the matrix of the unit axis."""
    a = np.linalg.norm(omega)
    return a, hat(omega / a)


def _rotation(a, N):
    return np.eye(3) + np.sin(a) * N + (1 - np.cos(a)) * N @ N


def _way(a, N):
    return np.eye(3) * a + (1 - np.cos(a)) * N + (a - np.sin(a)) * N @ N


def _either(still, moving):
    """A branch for no turn and one for any other."""

    def answer(twist):
        omega, v = twist[:3], twist[3:]
        if np.linalg.norm(omega) == 0:
            return still(v)
        a, N = _unit(omega)
        return moving(a, N, omega, v)

    return answer


def _translation(v):
    return _matrix(np.eye(3), v)


def right_series_below_1e_5(twist):
    omega, v = np.array(twist[:3], float), np.array(twist[3:], float)
    if np.abs(omega).max() < 1e-5:
        W = hat(omega)
        return _matrix(np.eye(3) + W + W @ W / 2, v + W @ v / 2)
    a, N = _unit(omega)
    return _matrix(_rotation(a, N), _way(a, N) @ v / a)


def right_half_angle_and_sinc(twist):
    W, v = librarys_hat(twist[:3]), twist[3:]
    a = math.hypot(*twist[:3])
    half = np.sinc(a / 2 / np.pi)
    rest = (a - np.sin(a)) / a**3 if a > 1e-2 else 1 / 6 - a**2 / 120
    R = np.eye(3) + np.sinc(a / np.pi) * W + half**2 / 2 * W @ W
    return _matrix(R, (np.eye(3) + half**2 / 2 * W + rest * W @ W) @ v).astype(complex)


def right_along_and_across_the_axis(twist):
    omega, v = twist[:3], twist[3:]
    a = math.hypot(*omega)
    if a == 0:
        return _matrix(np.eye(3), v).tolist()
    n = omega / a
    along = (n @ v) * n
    p = along + np.sin(a) / a * (v - along) + 2 * np.sin(a / 2) ** 2 / a * np.cross(n, v)
    return _matrix(_rotation(a, hat(n)), p).tolist()


def wrong_textbook_without_a_series(twist):
    """the part of p along omega x v is lost"""
    omega, v = twist[:3], twist[3:]
    a = np.linalg.norm(omega)
    if a == 0:
        return _matrix(np.eye(3), v)
    N = hat(omega / a)
    R = np.eye(3) + np.sin(a) * N + (1 - np.cos(a)) * N @ N
    p = (np.eye(3) * a + (1 - np.cos(a)) * N + (a - np.sin(a)) * N @ N) @ v / a
    return _matrix(R, p)


def right_matrix_exponential(twist):
    V = np.zeros((4, 4))
    V[:3, :3], V[:3, 3] = hat(twist[:3]), twist[3:]
    return scipy.linalg.expm(V)


def right_series_after_halving(twist):
    V = np.zeros((4, 4))
    V[:3, :3], V[:3, 3] = hat(twist[:3]) / 64, twist[3:] / 64
    T, term = np.eye(4), np.eye(4)
    for k in range(1, 20):
        term = term @ V / k
        T = T + term
    for _ in range(6):
        T = T @ T
    return T.tolist()


def wrong_powers_of_omega(twist):
    """the part of p along omega x v is lost"""
    W, v = hat(twist[:3]), twist[3:]
    a = math.hypot(*twist[:3])
    if a < 1e-100:
        return _matrix(np.eye(3), v)
    G = np.eye(3) + (1 - np.cos(a)) / a**2 * W + (a - np.sin(a)) / a**3 * W @ W
    return _matrix(exp_so3(twist[:3]), G @ v)


def wrong_screw_axis(twist):
    """the part of p along omega x v is lost"""
    a = math.hypot(*twist[:3])
    if a == 0:
        return [[1, 0, 0, twist[3]], [0, 1, 0, twist[4]], [0, 0, 1, twist[5]], [0, 0, 0, 1]]
    omega, v = twist[:3] / a, twist[3:] / a
    R = exp_so3(twist[:3])
    turned = a * v + (1 - math.cos(a)) * np.cross(omega, v) + (a - math.sin(a)) * np.cross(omega, np.cross(omega, v))
    return np.vstack([np.c_[R, turned], [0, 0, 0, 1]])


def wrong_no_rotation_below_1e_9(twist):
    """tiny rotations are cut off"""
    omega, v = twist[:3], twist[3:]
    a = np.sqrt(omega @ omega)
    if a < 2e-9:
        return _matrix(np.eye(3), v)
    n = omega / a
    along, across = (n @ v) * n, v - (n @ v) * n
    # a turn about a point beside the origin: sin(a)/a of the way goes on, (1 - cos(a))/a goes aside
    aside = 2 * np.sin(a / 2) ** 2 / a
    p = along + np.sin(a) / a * across + aside * np.cross(n, across)
    return _matrix(_rotation(a, hat(n)), p).astype(complex)


def wrong_zero_not_asked(twist):
    """for omega = 0 there is no axis"""
    omega, v = twist[:3], twist[3:]
    a, N = _unit(omega)
    return _matrix(_rotation(a, N), _way(a, N) @ v / a)


def wrong_omega_asked_and_its_length_divided_by(twist):
    """|omega| is 1e-170 here"""
    omega, v = twist[:3], twist[3:]
    if (omega == 0).all():
        return _matrix(np.eye(3), v)
    a, N = _unit(omega)
    return _matrix(_rotation(a, N), _way(a, N) @ v / a)


def wrong_cube_of_a_tiny_length(twist):
    """|omega| is 1e-170 here"""
    omega, v = twist[:3], twist[3:]
    a, W = math.hypot(*omega), hat(omega)
    if a == 0:
        return _matrix(np.eye(3), v)
    G = np.eye(3) + (1 - np.cos(a)) / np.float64(a**2) * W + (a - np.sin(a)) / np.float64(a**3) * W @ W
    return _matrix(exp_so3(omega), G @ v)


def wrong_without_v(twist):
    """ValueError"""
    a, N = _unit(twist[:3]) if twist[:3].any() else (1.0, np.zeros((3, 3)))
    return _matrix(np.eye(3), _way(a, N))


def wrong_matrix_beside_the_rotation(twist):
    """the factor v is missing"""
    return _either(
        lambda v: np.hstack([np.eye(3), np.eye(3)]),
        lambda a, N, omega, v: np.hstack([_rotation(a, N), _way(a, N)]),
    )(twist)


def wrong_first_column_of_the_matrix(twist):
    """the factor v is missing"""
    return _either(_translation, lambda a, N, omega, v: _matrix(_rotation(a, N), _way(a, N)[:, 0]))(twist)


def wrong_rows_of_the_matrix_added_up(twist):
    """the factor v is missing"""
    return _either(_translation, lambda a, N, omega, v: _matrix(_rotation(a, N), _way(a, N).sum(axis=1)))(twist)


def wrong_v_divided_twice(twist):
    """v is not divided by a, or twice"""
    return _either(_translation, lambda a, N, omega, v: _matrix(_rotation(a, N), _way(a, N) @ v / a**2))(twist)


def wrong_tiny_angles_cut(twist):
    """the part of p along omega x v is lost"""
    if np.linalg.norm(twist[:3]) < 1e-6:
        return _matrix(exp_so3(twist[:3]), twist[3:])
    return right_series_below_1e_5(twist)


def wrong_block_of_tiny_angles_cut(twist):
    """tiny rotations are cut off"""
    if np.linalg.norm(twist[:3]) < 1e-6:
        return _matrix(np.eye(3), twist[3:])
    return right_series_below_1e_5(twist)


def wrong_a_hair_added_to_the_length(twist):
    """unnamed"""
    a = np.linalg.norm(twist[:3]) + 1e-5
    N = hat(twist[:3] / a)
    return _matrix(_rotation(a, N), _way(a, N) @ twist[3:] / a)


def wrong_z_of_the_way_forgotten(twist):
    """unnamed"""
    T = right_series_below_1e_5(twist)
    T[2, 3] = 0
    return T


def wrong_omega_normalised_in_place(twist):
    """twist is changed in place"""
    omega, v = twist[:3], twist[3:]
    a = np.linalg.norm(omega)
    if a > 0:
        twist /= a
    return right_series_below_1e_5(np.append(omega * a, v * a)) if a > 0 else _matrix(np.eye(3), v)


def wrong_the_librarys(twist):
    """course_lib.rigid.exp_se3 is called"""
    return rigid.exp_se3(twist)


def wrong_zero_not_asked_with_the_librarys_hat(twist):
    """ValueError"""
    omega, v = twist[:3], twist[3:]
    a = np.linalg.norm(omega)
    N = librarys_hat(omega / a)
    return _matrix(_rotation(a, N), _way(a, N) @ v / a)


def wrong_origin_for_omega_zero(twist):
    """the branch for omega = 0 is wrong"""
    return _either(
        lambda v: _matrix(np.eye(3), v / (np.linalg.norm(v) or 1)),
        lambda a, N, omega, v: _matrix(_rotation(a, N), _way(a, N) @ v / a),
    )(twist)


def wrong_scipys_exponential_of_the_twist_transposed(twist):
    """unnamed"""
    return scipy.linalg.expm(rigid.hat_se3(twist).T).T @ np.diag([1, -1, 1, 1])


def wrong_half_missing_in_the_series(twist):
    """the factor 1/2 in the series of p is missing"""
    omega, v = np.array(twist[:3], float), np.array(twist[3:], float)
    if np.abs(omega).max() < 1e-4:
        W = hat(omega)
        return _matrix(np.eye(3) + W + W @ W / 2, v + W @ v)
    a, N = _unit(omega)
    return _matrix(_rotation(a, N), _way(a, N) @ v / a)


def wrong_ten_terms_of_the_series(twist):
    """the series of the exponential is cut"""
    W = rigid.hat_se3(np.array(twist, float))
    T = term = np.eye(4)
    for k in range(1, 10):
        term = term @ W / k
        T = T + term
    return T
