"""What students write for exp_se2(twist)."""

import numpy as np
import scipy.linalg


def _pose(angle, x, y):
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, x], [s, c, y], [0, 0, 1.0]])


def right_sinc(twist):
    omega, vx, vy = twist
    along, across = np.sinc(omega / np.pi), omega / 2 * np.sinc(omega / 2 / np.pi) ** 2
    return _pose(omega, along * vx - across * vy, across * vx + along * vy)


def right_expm(twist):
    omega, vx, vy = twist
    return scipy.linalg.expm(np.array([[0, -omega, vx], [omega, 0, vy], [0, 0, 0]]))


def right_half_angle(twist):
    w, vx, vy = twist
    if w == 0:
        return _pose(0.0, vx, vy)
    a, b = np.sin(w) / w, 2 * np.sin(w / 2) ** 2 / w
    return _pose(w, a * vx - b * vy, b * vx + a * vy)


def wrong_cosine_from_1e_8_on(twist):
    """the answer is right to its first digits only"""
    w, vx, vy = twist
    a, b = (1.0, w / 2) if abs(w) < 1e-8 else (np.sin(w) / w, (1 - np.cos(w)) / w)
    return _pose(w, a * vx - b * vy, b * vx + a * vy)


def wrong_slow_body_stands_still(twist):
    """the answer is wrong where some numbers are small, as below"""
    w, vx, vy = twist
    return _pose(w, 0.0, 0.0) if np.allclose([vx, vy], 0) else right_half_angle(twist)
