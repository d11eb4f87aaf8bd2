"""What students write for euler_angles(R)."""

import math

import numpy as np


def right_two_branches(R):
    c = np.sqrt(R[0, 0] ** 2 + R[1, 0] ** 2)
    if c > 1e-7:
        return np.array([np.arctan2(R[2, 1], R[2, 2]), np.arctan2(-R[2, 0], c), np.arctan2(R[1, 0], R[0, 0])])
    return np.array([0, np.arctan2(-R[2, 0], c), np.arctan2(-R[0, 1], R[1, 1])])


def right_gamma_chosen_in_place_of_alpha(R):
    c = math.hypot(R[2, 1], R[2, 2])
    beta = math.atan2(-R[2, 0], c)
    if c < 1e-9:
        sign = math.copysign(1, beta)
        return [math.atan2(sign * R[0, 1], sign * R[0, 2]), beta, 0.0]
    return [math.atan2(R[2, 1], R[2, 2]), beta, math.atan2(R[1, 0], R[0, 0])]


def right_one_angle_after_the_other(R):
    gamma = np.arctan2(R[1, 0], R[0, 0]) if np.hypot(R[0, 0], R[1, 0]) > 1e-12 else 0.3
    c, s = np.cos(gamma), np.sin(gamma)
    without = np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]) @ R
    beta = np.arctan2(-without[2, 0], without[0, 0])
    alpha = np.arctan2(-without[1, 2], without[1, 1])
    return np.array([[alpha], [beta], [gamma]])


def right_a_full_circle_more(R):
    return right_two_branches(R) + [2 * np.pi, 0, -2 * np.pi]


def wrong_no_lock(R):
    """at gimbal lock the angles are read from entries that are zero there"""
    return np.array(
        [np.arctan2(R[2, 1], R[2, 2]), np.arctan2(-R[2, 0], np.hypot(R[0, 0], R[1, 0])), np.arctan2(R[1, 0], R[0, 0])]
    )


def wrong_arctan(R):
    """arctan takes a quotient"""
    if np.hypot(R[0, 0], R[1, 0]) < 1e-8:
        return right_two_branches(R)
    return np.array([np.arctan(R[2, 1] / R[2, 2]), np.arcsin(-R[2, 0]), np.arctan(R[1, 0] / R[0, 0])])


def wrong_order_of_the_answer(R):
    """alpha and gamma are swapped"""
    return right_two_branches(R)[::-1]


def wrong_lock_by_exact_comparison(R):
    """at gimbal lock the angles are read from entries that are zero there"""
    if R[0, 0] == 0 and R[1, 0] == 0:
        return right_two_branches(R)
    return np.array([np.arctan2(R[2, 1], R[2, 2]), -np.arcsin(R[2, 0]), np.arctan2(R[1, 0], R[0, 0])])


def wrong_lock_from_afar(R):
    """used too soon"""
    if np.isclose(abs(R[2, 0]), 1, atol=1e-3):
        return np.array([0, np.sign(-R[2, 0]) * np.pi / 2, np.arctan2(-R[0, 1], R[1, 1])])
    return right_two_branches(R)


def wrong_divided_by_the_cosine(R):
    """at gimbal lock the angles are read"""
    with np.errstate(all="ignore"):
        beta = -np.arcsin(np.clip(R[2, 0], -1, 1))
        c = np.cos(beta) if abs(R[2, 0]) < 1 else 0.0
        return np.array([np.arctan2(R[2, 1] / c, R[2, 2] / c), beta, np.arctan2(R[1, 0] / c, R[0, 0] / c)])


def wrong_sign_of_beta(R):
    """beta has the wrong sign"""
    alpha, beta, gamma = right_two_branches(R)
    return alpha, -beta, gamma


def wrong_zeros_at_the_lock(R):
    """all of the rest is set to zero"""
    if np.hypot(R[0, 0], R[1, 0]) < 1e-8:
        return np.array([0, np.arcsin(np.clip(-R[2, 0], -1, 1)), 0])
    return right_two_branches(R)


def wrong_one_sign_for_both_locks(R):
    """wrong sign"""
    if np.hypot(R[0, 0], R[1, 0]) < 1e-8:
        return np.array([0, np.arcsin(np.clip(-R[2, 0], -1, 1)), np.arctan2(R[0, 1], R[1, 1])])
    return right_two_branches(R)


def wrong_columns_for_rows(R):
    """those of R^T"""
    return right_two_branches(R.T)


def wrong_degrees(R):
    """degrees"""
    return np.rad2deg(right_two_branches(R))


def wrong_math_domain(R):
    """near gimbal lock the formula for the exact lock is used too soon"""
    return [math.atan2(R[2, 1], R[2, 2]), math.asin(-1.0000001 * R[2, 0]), math.atan2(R[1, 0], R[0, 0])]
