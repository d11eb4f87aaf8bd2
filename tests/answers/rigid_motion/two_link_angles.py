"""What students write for two_link_angles(tip)."""

import cmath
import math

import numpy as np


def right_law_of_cosines(tip):
    x, y = tip
    two = np.arccos(np.clip((x**2 + y**2 - 2) / 2, -1, 1))
    return np.array([[np.arctan2(y, x) - np.arctan2(np.sin(t), 1 + np.cos(t)), t] for t in (two, -two)])


def right_isosceles_triangle(tip):
    r, direction = math.hypot(*tip), math.atan2(tip[1], tip[0])
    half = math.acos(min(1, r / 2))
    return [[direction + half, -2 * half], [direction - half, 2 * half]]


def right_complex_numbers(tip):
    z = complex(*tip)
    elbow = z / 2 * (1 + 1j * cmath.sqrt(max(0, 4 / abs(z) ** 2 - 1)))
    rows = []
    for e in (elbow, z - elbow):
        one = cmath.phase(e)
        rows.append([one, (cmath.phase(z - e) - one) % (2 * math.pi)])
    return rows


def right_half_angle_by_arctan2(tip):
    x, y = tip
    r2 = x * x + y * y
    two = 2 * math.atan2(math.sqrt(max(0.0, 4 - r2)), math.sqrt(r2))
    return [(math.atan2(y, x) - t / 2, t) for t in (-two, two)]


def wrong_one_elbow(tip):
    """only one elbow"""
    return right_law_of_cosines(tip)[0]


def wrong_same_elbow_twice(tip):
    """the same elbow"""
    return right_law_of_cosines(tip)[[0, 0]]


def wrong_theta1_kept(tip):
    """theta1 is the same for both elbows"""
    rows = right_law_of_cosines(tip)
    rows[1, 0] = rows[0, 0]
    return rows


def wrong_direction_of_the_tip(tip):
    """theta1 is the direction of the tip"""
    x, y = tip
    two = np.arccos(np.clip((x**2 + y**2 - 2) / 2, -1, 1))
    return [[np.arctan2(y, x), two], [np.arctan2(y, x), -two]]


def wrong_without_clip(tip):
    """rounding makes the cosine of theta2 larger than 1"""
    x, y = tip
    two = np.arccos((x**2 + y**2 - 2) / 2)
    return np.array([[np.arctan2(y, x) - np.arctan2(np.sin(t), 1 + np.cos(t)), t] for t in (two, -two)])


def wrong_math_acos_without_clip(tip):
    """ValueError"""
    x, y = tip
    two = math.acos((x**2 + y**2 - 2) / 2)
    return [[math.atan2(y, x) - t / 2, t] for t in (two, -two)]


def wrong_distance_not_squared(tip):
    """the law of cosines has a wrong number"""
    x, y = tip
    two = np.arccos(np.clip((np.hypot(x, y) - 2) / 2, -1, 1))
    return np.array([[np.arctan2(y, x) - np.arctan2(np.sin(t), 1 + np.cos(t)), t] for t in (two, -two)])


def wrong_inner_angle(tip):
    """inside the triangle"""
    x, y = tip
    two = np.arccos(np.clip((2 - x**2 - y**2) / 2, -1, 1))
    return np.array([[np.arctan2(y, x) - np.arctan2(np.sin(t), 1 + np.cos(t)), t] for t in (two, -two)])


def wrong_arctan(tip):
    """arctan is used"""
    x, y = tip
    two = np.arccos(np.clip((x**2 + y**2 - 2) / 2, -1, 1))
    with np.errstate(all="ignore"):
        return np.array([[np.arctan(np.divide(y, x)) - np.arctan(np.tan(t / 2)), t] for t in (two, -two)])


def wrong_degrees(tip):
    """in degrees"""
    return np.rad2deg(right_law_of_cosines(tip))


def wrong_absolute_second_angle(tip):
    """from the x axis of the world"""
    return np.cumsum(right_law_of_cosines(tip), axis=1)


def wrong_correction_added(tip):
    """the correction of theta1"""
    x, y = tip
    two = np.arccos(np.clip((x**2 + y**2 - 2) / 2, -1, 1))
    return np.array([[np.arctan2(y, x) + np.arctan2(np.sin(t), 1 + np.cos(t)), t] for t in (two, -two)])


def wrong_columns(tip):
    """rows and columns"""
    return right_law_of_cosines(tip).T


def wrong_bend_not_halved(tip):
    """theta1 is corrected by the whole of theta2"""
    bend = np.arccos(np.clip((tip[0] ** 2 + tip[1] ** 2 - 2) / 2, -1, 1))
    direction = np.arctan2(tip[1], tip[0])
    return [[direction - bend, bend], [direction + bend, -bend]]


def wrong_arcsin(tip):
    """arcsin is used"""
    bend = np.arcsin(np.clip((tip[0] ** 2 + tip[1] ** 2 - 2) / 2, -1, 1))
    direction = np.arctan2(tip[1], tip[0])
    return [[direction - bend / 2, bend], [direction + bend / 2, -bend]]


def wrong_cosine_not_halved(tip):
    """the law of cosines has a wrong number"""
    bend = np.arccos(np.clip(tip[0] ** 2 + tip[1] ** 2 - 2, -1, 1))
    direction = np.arctan2(tip[1], tip[0])
    return [[direction - bend / 2, bend], [direction + bend / 2, -bend]]


def wrong_sine_without_clip(tip):
    """at the edge of the reach"""
    x, y = tip
    cosine = (x**2 + y**2 - 2) / 2
    sine = np.sqrt(1 - cosine**2)
    return np.array([[np.arctan2(y, x) - np.arctan2(s, 1 + cosine), np.arctan2(s, cosine)] for s in (sine, -sine)])
