"""What students write for exp_se2(twist)."""

import numpy as np
import scipy.linalg

from course_lib import rigid


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


def right_series_for_small_angles(twist):
    w, vx, vy = twist
    if abs(w) < 1e-2:
        a, b = 1 - w**2 / 6 + w**4 / 120, w / 2 - w**3 / 24 + w**5 / 720
    else:
        a, b = np.sin(w) / w, (1 - np.cos(w)) / w
    return _pose(w, a * vx - b * vy, b * vx + a * vy).tolist()


def right_long_series(twist):
    omega, vx, vy = twist
    W = np.array([[0, -omega, vx], [omega, 0, vy], [0, 0, 0]])
    total = term = np.eye(3)
    for k in range(1, 60):
        term = term @ W / k
        total = total + term
    return total


def right_half_angle(twist):
    w, vx, vy = twist
    if w == 0:
        return _pose(0.0, vx, vy)
    a, b = np.sin(w) / w, 2 * np.sin(w / 2) ** 2 / w
    return _pose(w, a * vx - b * vy, b * vx + a * vy)


def wrong_not_own_lines(twist):
    """is called"""
    return rigid.exp_se2(twist)


def wrong_division_by_zero(twist):
    """divided by zero"""
    w, vx, vy = np.asarray(twist, float)
    return _pose(w, np.sin(w) / w * vx, (1 - np.cos(w)) / w * vx + 0 * vy)


def wrong_zero_alone(twist):
    """small angles are taken for none"""
    w, vx, vy = twist
    if w == 0:
        return _pose(0.0, vx, vy)
    a, b = np.sin(w) / w, (1 - np.cos(w)) / w
    return _pose(w, a * vx - b * vy, b * vx + a * vy)


def wrong_small_angles_cut_off(twist):
    """small angles are taken for none"""
    w, vx, vy = twist
    if abs(w) < 1e-6:
        return _pose(w, vx, vy)
    a, b = np.sin(w) / w, 2 * np.sin(w / 2) ** 2 / w
    return _pose(w, a * vx - b * vy, b * vx + a * vy)


def wrong_euler(twist):
    """as if the body did not rotate meanwhile"""
    return _pose(*twist)


def wrong_rotated_first(twist):
    """as if the body rotated first"""
    T = _pose(twist[0], 0, 0)
    T[:2, 2] = T[:2, :2] @ twist[1:]
    return T


def wrong_twist_order(twist):
    """(vx, vy, omega)"""
    vx, vy, w = twist
    return right_sinc([w, vx, vy])


def wrong_signs_exchanged(twist):
    """signs of the terms"""
    T = right_sinc(twist)
    w, vx, vy = twist
    along, across = np.sinc(w / np.pi), w / 2 * np.sinc(w / 2 / np.pi) ** 2
    T[:2, 2] = [along * vx + across * vy, -across * vx + along * vy]
    return T


def wrong_short_series(twist):
    """the series of the exponential is cut"""
    omega, vx, vy = twist
    W = np.array([[0, -omega, vx], [omega, 0, vy], [0, 0, 0]])
    return np.eye(3) + W + W @ W / 2


def wrong_sinc_of_numpy(twist):
    """np.sinc is taken for sin(x) / x"""
    w, vx, vy = twist
    a, b = np.sinc(w), w / 2 * np.sinc(w / 2) ** 2
    return _pose(w, a * vx - b * vy, b * vx + a * vy)


def wrong_middle_angle(twist):
    """unnamed"""
    w, vx, vy = twist
    c, s = np.cos(w / 2), np.sin(w / 2)
    return _pose(w, c * vx - s * vy, s * vx + c * vy)


def wrong_pose_of_three_numbers(twist):
    """(x, y, theta) is returned"""
    T = right_sinc(twist)
    return [T[0, 2], T[1, 2], twist[0]]


def wrong_exponential_of_each_entry(twist):
    """the exponential is taken entry by entry"""
    omega, vx, vy = twist
    return np.exp([[0, -omega, vx], [omega, 0, vy], [0, 0, 0]])


def wrong_sine_and_cosine_swapped(twist):
    """sin(omega) and 1 - cos(omega) are swapped"""
    omega, vx, vy = twist
    a, b = np.sinc(omega / np.pi), omega / 2 * np.sinc(omega / 2 / np.pi) ** 2
    c, s = np.cos(omega), np.sin(omega)
    return [[c, -s, b * vx - a * vy], [s, c, a * vx + b * vy], [0, 0, 1]]


def wrong_epsilon_in_the_denominator(twist):
    """a small number is added to omega"""
    omega, vx, vy = twist
    a, b = np.sin(omega) / (omega + 1e-8), (1 - np.cos(omega)) / (omega + 1e-8)
    c, s = np.cos(omega), np.sin(omega)
    return [[c, -s, a * vx - b * vy], [s, c, b * vx + a * vy], [0, 0, 1]]


def wrong_corner_of_zero(twist):
    """the last row is not (0, 0, 1)"""
    omega, vx, vy = twist
    a, b = np.sinc(omega / np.pi), omega / 2 * np.sinc(omega / 2 / np.pi) ** 2
    c, s = np.cos(omega), np.sin(omega)
    return [[c, -s, a * vx - b * vy], [s, c, b * vx + a * vy], [0, 0, 0]]


def wrong_fifteen_terms_of_the_series(twist):
    """the series of the exponential is cut"""
    omega, vx, vy = twist
    W = np.array([[0, -omega, vx], [omega, 0, vy], [0, 0, 0]])
    T = term = np.eye(3)
    for k in range(1, 15):
        term = term @ W / k
        T = T + term
    return T
