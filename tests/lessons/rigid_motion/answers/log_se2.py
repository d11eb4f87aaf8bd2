"""What students write for log_se2(T)."""

import numpy as np


def _matrix(omega):
    along, across = np.sinc(omega / np.pi), omega / 2 * np.sinc(omega / 2 / np.pi) ** 2
    return np.array([[along, -across], [across, along]])


def _twist(omega, T):
    return [omega, *np.linalg.solve(_matrix(omega), T[:2, 2])]


def right_linear_system(T):
    return _twist(np.arctan2(T[1, 0], T[0, 0]), T)


def right_complex_numbers(T):
    omega = np.angle(complex(T[0, 0], T[1, 0]))
    position = complex(*T[:2, 2])
    v = position if omega == 0 else position * 1j * omega / np.expm1(1j * omega)
    return omega, v.real, v.imag


def right_clockwise_at_half_a_revolution(T):
    omega = np.arctan2(T[1, 0], T[0, 0])
    return _twist(-np.pi if omega > np.pi - 1e-12 else omega, T)


def wrong_series_used_too_far(T):
    """the answer is right to its first digits only"""
    omega, (x, y) = np.arctan2(T[1, 0], T[0, 0]), T[:2, 2]
    if abs(omega) < 3e-4:
        return np.array([omega, x + omega / 2 * y, y - omega / 2 * x])
    return right_linear_system(T)


def wrong_arcsin_with_the_sign_of_the_cosine(T):
    """the answer is right to its first digits only"""
    omega = np.arcsin(np.clip(T[1, 0], -1, 1))
    return _twist(omega if T[0, 0] >= 0 else np.copysign(np.pi, omega) - omega, T)


def wrong_nothing_near_the_identity(T):
    """the answer is wrong where some numbers are small"""
    return np.zeros(3) if np.allclose(T, np.eye(3)) else right_linear_system(T)
