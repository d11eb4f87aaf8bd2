"""What students write for euler_angles(R)."""

import math

import numpy as np


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
