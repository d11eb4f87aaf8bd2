"""What students write for subproblem3(k, p, g, d)."""

import math

import numpy as np

from course_lib import subproblems
from course_lib.rotations import exp_so3
from course_lib.subproblems import subproblem4


def parts(k, p, g):
    return p - (k @ p) * k, g - (k @ g) * k


def turn(k, p, g):
    p, g = parts(k, p, g)
    return np.arctan2(k @ np.cross(p, g), p @ g)


def right_textbook(k, p, g, d):
    a, b = parts(k, p, g)
    square = d**2 - (k @ (p - g)) ** 2
    if d < 0 or square < 0:
        return []
    cosine = (a @ a + b @ b - square) / (2 * np.linalg.norm(a) * np.linalg.norm(b))
    if abs(cosine) > 1:
        return []
    aside = np.arccos(cosine)
    return [turn(k, p, g) + aside, turn(k, p, g) - aside]


def right_as_a_height(k, p, g, d):
    """2 g . R p = |p|^2 + |g|^2 - d^2, by components."""
    A, B = -g @ np.cross(k, np.cross(k, p)), g @ np.cross(k, p)
    C = (p @ p + g @ g - d * d) / 2 - (k @ p) * (k @ g)
    size = math.hypot(A, B)
    if d < 0 or abs(C) > size:
        return np.array([])
    middle = math.atan2(B, A)
    return np.array([[middle - math.acos(C / size)], [middle + math.acos(C / size) - 2 * math.pi]])


def right_by_half_angle_tangent(k, p, g, d):
    """A cos + B sin = C with t = tan(theta/2): (A + C) t^2 - 2 B t + (C - A) = 0."""
    if d < 0:
        return ()
    A, B = -g @ np.cross(k, np.cross(k, p)), g @ np.cross(k, p)
    C = (p @ p + g @ g - d * d) / 2 - (k @ p) * (k @ g)
    under = A * A + B * B - C * C
    if under < 0:
        return ()
    return tuple(2 * np.arctan2(B + s * np.sqrt(under), A + C) for s in (1, -1))


def right_by_substitution(k, p, g, d):
    a, b = parts(k, p, g)
    cosine = (a @ a + b @ b + (k @ (p - g)) ** 2 - d**2) / (2 * np.linalg.norm(a) * np.linalg.norm(b))
    found = turn(k, p, g) + np.array([[1, -1]]) * np.arccos(np.clip(cosine, -1, 1))
    miss = [abs(np.linalg.norm(exp_so3(t * k) @ p - g) - d) for t in found[0]]
    return found[:, np.array(miss) < 1e-8 * np.linalg.norm(p)]


def right_one_where_they_meet(k, p, g, d):
    if d < 0:
        return []
    a, b = parts(k, p, g)
    cosine = (a @ a + b @ b + (k @ (p - g)) ** 2 - d**2) / (2 * np.linalg.norm(a) * np.linalg.norm(b))
    if np.isclose(cosine, 1):
        return [turn(k, p, g)]
    if np.isclose(cosine, -1):
        return float(turn(k, p, g) + np.pi)
    return [] if abs(cosine) > 1 else [turn(k, p, g) + s * np.arccos(cosine) for s in (1, -1)]


def right_by_intersecting_circles(k, p, g, d):
    a, b = parts(k, p, g)
    square = d * abs(d) - (k @ (p - g)) ** 2
    along = (a @ a - square + b @ b) / (2 * np.linalg.norm(b))
    beside = a @ a - along**2
    if square < 0 or beside < 0:
        return []
    e = b / np.linalg.norm(b)
    points = [along * e + s * np.sqrt(beside) * np.cross(k, e) for s in (1, -1)]
    return [turn(k, a, point) for point in points]


def _two(k, p, g, d, cosine):
    if d < 0 or not abs(cosine) <= 1:
        return []
    return [turn(k, p, g) + np.arccos(cosine), turn(k, p, g) - np.arccos(cosine)]


def wrong_heights_forgotten(k, p, g, d):
    """the heights along the axis are forgotten"""
    a, b = parts(k, p, g)
    return _two(k, p, g, d, (a @ a + b @ b - d**2) / (2 * np.linalg.norm(a) * np.linalg.norm(b)))


def wrong_not_projected(k, p, g, d):
    """not projected"""
    return _two(k, p, g, d, (p @ p + g @ g - d**2) / (2 * np.linalg.norm(p) * np.linalg.norm(g)))


def wrong_not_squared(k, p, g, d):
    """a length is not squared"""
    a, b = parts(k, p, g)
    square = d - (k @ (p - g)) ** 2
    return _two(k, p, g, d, (a @ a + b @ b - square) / (2 * np.linalg.norm(a) * np.linalg.norm(b)))


def wrong_reduced_not_squared(k, p, g, d):
    """a length is not squared"""
    a, b = parts(k, p, g)
    reduced = np.sqrt(d**2 - (k @ (p - g)) ** 2)
    return _two(k, p, g, d, (a @ a + b @ b - reduced) / (2 * np.linalg.norm(a) * np.linalg.norm(b)))


def wrong_sum_of_heights(k, p, g, d):
    """d is reduced wrongly"""
    a, b = parts(k, p, g)
    square = d**2 - (k @ (p + g)) ** 2
    return _two(k, p, g, d, (a @ a + b @ b - square) / (2 * np.linalg.norm(a) * np.linalg.norm(b)))


def wrong_added(k, p, g, d):
    """d is reduced wrongly"""
    a, b = parts(k, p, g)
    square = d**2 + (k @ (p - g)) ** 2
    return _two(k, p, g, d, (a @ a + b @ b - square) / (2 * np.linalg.norm(a) * np.linalg.norm(b)))


def wrong_only_one(k, p, g, d):
    """only one of the two angles"""
    return right_textbook(k, p, g, d)[:1]


def wrong_one_number(k, p, g, d):
    """only one of the two angles"""
    found = right_textbook(k, p, g, d)
    return found[0] if found else []


def wrong_arccos_out_of_range(k, p, g, d):
    """arccos is asked outside"""
    if d < 0:
        return []
    a, b = parts(k, p, g)
    cosine = (a @ a + b @ b - d**2 + (k @ (p - g)) ** 2) / (2 * np.linalg.norm(a) * np.linalg.norm(b))
    return [turn(k, p, g) + np.arccos(cosine), turn(k, p, g) - np.arccos(cosine)]


def wrong_reduced_length_of_a_negative(k, p, g, d):
    """a root of a negative number"""
    if d < 0:
        return []
    a, b = parts(k, p, g)
    reduced = np.sqrt(d**2 - (k @ (p - g)) ** 2)
    cosine = (a @ a + b @ b - reduced**2) / (2 * np.linalg.norm(a) * np.linalg.norm(b))
    return [] if abs(cosine) > 1 else [turn(k, p, g) + np.arccos(cosine), turn(k, p, g) - np.arccos(cosine)]


def wrong_math_acos(k, p, g, d):
    """ValueError"""
    a, b = parts(k, p, g)
    cosine = (a @ a + b @ b - d**2 + (k @ (p - g)) ** 2) / (2 * np.linalg.norm(a) * np.linalg.norm(b))
    return [turn(k, p, g) + math.acos(cosine), turn(k, p, g) - math.acos(cosine)]


def wrong_negative_distance(k, p, g, d):
    """a negative d is squared"""
    return right_textbook(k, p, g, abs(d))


def wrong_clipped(k, p, g, d):
    """an angle is returned although"""
    if d < 0:
        return []
    a, b = parts(k, p, g)
    cosine = (a @ a + b @ b - d**2 + (k @ (p - g)) ** 2) / (2 * np.linalg.norm(a) * np.linalg.norm(b))
    aside = np.arccos(np.clip(cosine, -1, 1))
    return [turn(k, p, g) + aside, turn(k, p, g) - aside]


def wrong_only_too_far_is_seen(k, p, g, d):
    """an angle is returned although"""
    if d < 0 or d > np.linalg.norm(p) + np.linalg.norm(g):
        return []
    a, b = parts(k, p, g)
    cosine = (a @ a + b @ b - d**2 + (k @ (p - g)) ** 2) / (2 * np.linalg.norm(a) * np.linalg.norm(b))
    aside = np.arccos(np.clip(cosine, -1, 1))
    return [turn(k, p, g) + aside, turn(k, p, g) - aside]


def wrong_arccos_alone(k, p, g, d):
    """the angle from p to g is left out"""
    return [t - turn(k, p, g) for t in right_textbook(k, p, g, d)]


def wrong_turn_from_g(k, p, g, d):
    """the angle from g to p is taken"""
    return [t - 2 * turn(k, p, g) for t in right_textbook(k, p, g, d)]


def wrong_turn_without_sign(k, p, g, d):
    """the angle from p to g has lost its sign"""
    return [t - turn(k, p, g) + abs(turn(k, p, g)) for t in right_textbook(k, p, g, d)]


def wrong_cosine_turned(k, p, g, d):
    """the law of cosines has the wrong sign"""
    return [t + np.pi for t in right_textbook(k, p, g, d)]


def wrong_no_two(k, p, g, d):
    """the 2 of the law of cosines is missing"""
    a, b = parts(k, p, g)
    square = d**2 - (k @ (p - g)) ** 2
    return _two(k, p, g, d, (a @ a + b @ b - square) / (np.linalg.norm(a) * np.linalg.norm(b)))


def wrong_degrees(k, p, g, d):
    """degrees"""
    return np.rad2deg(right_textbook(k, p, g, d))


def wrong_none(k, p, g, d):
    """a return is missing"""
    return right_textbook(k, p, g, d) or None


def wrong_a_whole_turn_more(k, p, g, d):
    """a solution is listed twice"""
    return [t + turns for t in right_textbook(k, p, g, d) for turns in (0, 2 * np.pi)]


def wrong_mean_of_both(k, p, g, d):
    """unnamed"""
    found = right_textbook(k, p, g, d)
    return [np.mean(found)] if len(found) else []


def wrong_arcsin_of_the_cosine(k, p, g, d):
    """has sine and cosine swapped"""
    found = right_textbook(k, p, g, d)
    return [np.pi / 2 - t for t in found]


def wrong_turn_by_arctan(k, p, g, d):
    """is wrong beyond 90 degrees"""
    a, b = parts(k, p, g)
    middle = np.arctan(k @ np.cross(a, b) / (a @ b + 1e-300))
    return [t - turn(k, p, g) + middle for t in right_textbook(k, p, g, d)]


def wrong_the_librarys(k, p, g, d):
    """course_lib.subproblems.subproblem3 is called"""
    return subproblems.subproblem3(k, p, g, d).theta


def _asked(k, g, p, height):
    answers = subproblem4(k, g, p, height)
    return list(answers.theta[: answers.count]) if answers.exact else []


def wrong_sign_of_the_height(k, p, g, d):
    """the height has the wrong sign"""
    return [] if d < 0 else _asked(k, g, p, (d**2 - p @ p - g @ g) / 2)


def wrong_height_without_half(k, p, g, d):
    """the 1/2 of the height is missing"""
    return [] if d < 0 else _asked(k, g, p, p @ p + g @ g - d**2)


def wrong_distance_as_height(k, p, g, d):
    """d itself is taken for the height"""
    return [] if d < 0 else _asked(k, g, p, d)


def wrong_lengths_not_squared(k, p, g, d):
    """a length is not squared"""
    return [] if d < 0 else _asked(k, g, p, (np.linalg.norm(p) + np.linalg.norm(g) - d**2) / 2)
