"""What students write for two_link_angles(tip)."""

import math

import numpy as np


def right_law_of_cosines(tip):
    x, y = tip
    two = np.arccos(np.clip((x**2 + y**2 - 2) / 2, -1, 1))
    return np.array(
        [[np.arctan2(y, x) - np.arctan2(np.sin(t), 1 + np.cos(t)), t] for t in (two, -two)]
    )


def right_isosceles_triangle(tip):
    r, direction = math.hypot(*tip), math.atan2(tip[1], tip[0])
    half = math.acos(min(1, r / 2))
    return [[direction + half, -2 * half], [direction - half, 2 * half]]


def right_half_angle_by_arctan2(tip):
    x, y = tip
    r2 = x * x + y * y
    two = 2 * math.atan2(math.sqrt(max(0.0, 4 - r2)), math.sqrt(r2))
    return [(math.atan2(y, x) - t / 2, t) for t in (-two, two)]


def wrong_rounded(tip):
    """the answer is rounded to 4 digits"""
    return np.round(right_law_of_cosines(tip), 4)


def wrong_folded_too_early(tip):
    """the arm is taken for folded although the tip is not at the base"""
    if np.hypot(*tip) < 1e-3:
        first = np.arctan2(tip[1], tip[0])
        return np.array([[first - np.pi / 2, np.pi], [first + np.pi / 2, -np.pi]])
    return right_law_of_cosines(tip)


def wrong_one_first_angle_and_nan_beyond_the_reach(tip):
    """the two angles of a row belong to different elbows"""
    x, y = tip
    two = np.arccos((x * x + y * y - 2) / 2)
    first = np.arctan2(y, x) - two / 2
    return np.array([[first, two], [first, -two]])
