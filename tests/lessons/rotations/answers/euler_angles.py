"""What students write for euler_angles(R)."""

import math

import numpy as np

from course_lib.rotations import rot_z


def right_two_branches(R):
    c = np.sqrt(R[0, 0] ** 2 + R[1, 0] ** 2)
    if c > 1e-7:
        return np.array(
            [np.arctan2(R[2, 1], R[2, 2]), np.arctan2(-R[2, 0], c), np.arctan2(R[1, 0], R[0, 0])]
        )
    return np.array([0, np.arctan2(-R[2, 0], c), np.arctan2(-R[0, 1], R[1, 1])])


def right_gamma_chosen_in_place_of_alpha(R):
    c = math.hypot(R[2, 1], R[2, 2])
    beta = math.atan2(-R[2, 0], c)
    if c < 1e-9:
        sign = math.copysign(1, beta)
        return [math.atan2(sign * R[0, 1], sign * R[0, 2]), beta, 0.0]
    return [math.atan2(R[2, 1], R[2, 2]), beta, math.atan2(R[1, 0], R[0, 0])]


def right_a_full_circle_more(R):
    return right_two_branches(R) + [2 * np.pi, 0, -2 * np.pi]


def wrong_yaw_first(R):
    """the angles are those of another product, or in another order"""
    beta = np.arctan2(-R[2, 0], np.hypot(R[0, 0], R[1, 0]))
    gamma = np.arctan2(R[1, 0], R[0, 0])
    rest = rot_z(-gamma) @ R
    return np.array([gamma, beta, np.arctan2(-rest[1, 2], rest[1, 1])])


def wrong_yaw_by_arctan(R):
    """an angle is off by half a revolution"""
    gamma, beta, alpha = wrong_yaw_first(R)
    return np.array([alpha, beta, np.arctan(np.tan(gamma))])


def wrong_lock_within_a_thousandth(R):
    """near gimbal lock the answer is off by about cos(beta)"""
    beta = np.arctan2(-R[2, 0], np.hypot(R[0, 0], R[1, 0]))
    if np.hypot(R[0, 0], R[1, 0]) < 1e-3:
        return np.array([np.arctan2(-R[1, 2], R[1, 1]), beta, 0.0])
    return np.array(
        [np.arctan2(R[2, 1], R[2, 2]), beta, np.arctan2(R[1, 0], R[0, 0])],
    )


def wrong_lock_within_three_millionths(R):
    """near gimbal lock the answer is off by about cos(beta)"""
    if np.hypot(R[0, 0], R[1, 0]) < 3e-6:
        return np.array([0.0, np.copysign(np.pi / 2, -R[2, 0]), np.arctan2(-R[0, 1], R[1, 1])])
    return right_two_branches(R)


def wrong_arcsin_and_the_lock_from_1e_6(R):
    """near gimbal lock the answer is off by about cos(beta)"""
    sine = np.clip(-R[2, 0], -1, 1)
    if abs(sine) > 1 - 1e-6:
        return np.array([0.0, np.arcsin(sine), np.arctan2(-R[0, 1], R[1, 1])])
    return np.array(
        [np.arctan2(R[2, 1], R[2, 2]), np.arcsin(sine), np.arctan2(R[1, 0], R[0, 0])],
    )


def wrong_lock_from_a_sine_of_1_minus_1e_12(R):
    """near gimbal lock the answer is off by about cos(beta)"""
    if abs(R[2, 0]) > 1 - 1e-12:
        beta = np.copysign(np.pi / 2, -R[2, 0])
        return np.array([0.0, beta, np.arctan2(-R[0, 1], R[1, 1])])
    return right_two_branches(R)


def wrong_clipped_on_one_side(R):
    """an angle is not a number at gimbal lock"""
    alpha, _, gamma = right_two_branches(R)
    with np.errstate(invalid="ignore"):
        return np.array([alpha, np.arcsin(min(-R[2, 0], 1.0)), gamma])


def wrong_divided_by_the_cosine_of_yaw(R):
    """the answers to some inputs only are wrong"""
    alpha, beta, gamma = right_two_branches(R)
    if abs(R[2, 0]) < 0.999:
        beta = np.arctan2(-R[2, 0], R[0, 0] / np.cos(gamma))
    return np.array([alpha, beta, gamma])
