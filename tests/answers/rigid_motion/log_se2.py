"""What students write for log_se2(T)."""

import numpy as np
import scipy.linalg

from course_lib import rigid


def _matrix(omega):
    along, across = np.sinc(omega / np.pi), omega / 2 * np.sinc(omega / 2 / np.pi) ** 2
    return np.array([[along, -across], [across, along]])


def _twist(omega, T):
    return [omega, *np.linalg.solve(_matrix(omega), T[:2, 2])]


def right_linear_system(T):
    return _twist(np.arctan2(T[1, 0], T[0, 0]), T)


def right_half_cotangent(T):
    omega = np.arctan2(T[1, 0], T[0, 0])
    half = omega / 2
    a = half / np.tan(half) if omega else 1.0
    x, y = T[:2, 2]
    return np.array([[omega], [a * x + half * y], [a * y - half * x]])


def right_complex_numbers(T):
    omega = np.angle(complex(T[0, 0], T[1, 0]))
    position = complex(*T[:2, 2])
    v = position if omega == 0 else position * 1j * omega / np.expm1(1j * omega)
    return omega, v.real, v.imag


def right_clockwise_at_half_a_revolution(T):
    omega = np.arctan2(T[1, 0], T[0, 0])
    return _twist(-np.pi if omega > np.pi - 1e-12 else omega, T)


def wrong_not_own_lines(T):
    """is called"""
    return rigid.log_se2(T)


def wrong_position_for_v(T):
    """as if the body did not rotate meanwhile"""
    return [np.arctan2(T[1, 0], T[0, 0]), T[0, 2], T[1, 2]]


def wrong_position_rotated_back(T):
    """as if the body rotated first"""
    return [np.arctan2(T[1, 0], T[0, 0]), *(T[:2, :2].T @ T[:2, 2])]


def wrong_arccos(T):
    """half of the circle"""
    return _twist(np.arccos(np.clip(T[0, 0], -1, 1)), T)


def wrong_arccos_of_half_the_trace(T):
    """half of the circle"""
    return _twist(np.arccos(np.clip((np.trace(T) - 1) / 2, -1, 1)), T)


def wrong_arcsin(T):
    """half of the circle"""
    return _twist(np.arcsin(np.clip(T[1, 0], -1, 1)), T)


def wrong_arctan2_swapped(T):
    """sine and cosine are swapped"""
    return _twist(np.arctan2(T[0, 0], T[1, 0]), T)


def wrong_sine_from_the_upper_row(T):
    """omega has the opposite sign"""
    return _twist(np.arctan2(T[0, 1], T[0, 0]), T)


def wrong_matrix_not_inverted(T):
    """A is applied to p"""
    omega = np.arctan2(T[1, 0], T[0, 0])
    return [omega, *(_matrix(omega) @ T[:2, 2])]


def wrong_matrix_transposed(T):
    """signs of the terms"""
    omega = np.arctan2(T[1, 0], T[0, 0])
    return [omega, *np.linalg.solve(_matrix(omega).T, T[:2, 2])]


def wrong_twist_order(T):
    """(vx, vy, omega)"""
    omega, vx, vy = right_linear_system(T)
    return vx, vy, omega


def wrong_no_case_for_zero(T):
    """divided by zero"""
    omega = np.arctan2(T[1, 0], T[0, 0])
    s, c = np.sin(omega), 1 - np.cos(omega)
    A = np.array([[s, -c], [c, s]]) / omega
    return [omega, *(np.linalg.inv(A) @ T[:2, 2] if np.isfinite(A).all() else [np.nan, np.nan])]


def wrong_digits_lost(T):
    """digits are lost"""
    omega = np.arctan2(T[1, 0], T[0, 0])
    if omega == 0:
        return [0.0, *T[:2, 2]]
    s, c = np.sin(omega), 1 - np.cos(omega)
    return [omega, *np.linalg.solve(np.array([[s, -c], [c, s]]) / omega, T[:2, 2])]


def wrong_small_angles_cut_off(T):
    """digits are lost"""
    omega = np.arctan2(T[1, 0], T[0, 0])
    return [omega, *T[:2, 2]] if abs(omega) < 1e-4 else _twist(omega, T)


def wrong_matrix_returned(T):
    """the matrix [V] is returned"""
    omega, vx, vy = right_linear_system(T)
    return [[0, -omega, vx], [omega, 0, vy], [0, 0, 0]]


def wrong_logm(T):
    """scipy.linalg.logm is called"""
    V = scipy.linalg.logm(T)
    return [V[1, 0], V[0, 2], V[1, 2]]


def wrong_full_revolutions(T):
    """between 0 and 2 pi"""
    return _twist(np.arctan2(T[1, 0], T[0, 0]) % (2 * np.pi), T)


def wrong_degrees(T):
    """omega is in degrees"""
    omega, vx, vy = right_linear_system(T)
    return np.rad2deg(omega), vx, vy


def wrong_inverse(T):
    """the logarithm of the inverse"""
    return np.negative(right_linear_system(T))


def wrong_logarithm_of_each_entry(T):
    """divided by zero"""
    return np.log(T)[:, 2]
