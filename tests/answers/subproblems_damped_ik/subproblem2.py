"""What students write for subproblem2(k1, k2, p1, p2)."""

import math

import numpy as np

from course_lib import subproblems
from course_lib.rotations import exp_so3


def turn(k, p, q):
    p, q = p - (k @ p) * k, q - (k @ q) * k
    return np.arctan2(k @ np.cross(p, q), p @ q)


def foot(k1, k2, p1, p2):
    """a and b of the meeting points z = a k1 + b k2 +- g k1 x k2."""
    c, h1, h2 = k1 @ k2, k1 @ p1, k2 @ p2
    return (h1 - c * h2) / (1 - c**2), (h2 - c * h1) / (1 - c**2)


def rest(k1, k2, p1, p2):
    """g squared."""
    a, b = foot(k1, k2, p1, p2)
    return (p1 @ p1 - a**2 - b**2 - 2 * a * b * (k1 @ k2)) / (1 - (k1 @ k2) ** 2)


def right_textbook(k1, k2, p1, p2):
    if not np.isclose(np.linalg.norm(p1), np.linalg.norm(p2)):
        return []
    a, b = foot(k1, k2, p1, p2)
    square = rest(k1, k2, p1, p2)
    if square < -1e-9 * (p1 @ p1):
        return []
    found = []
    for g in (np.sqrt(max(square, 0)), -np.sqrt(max(square, 0))):
        z = a * k1 + b * k2 + g * np.cross(k1, k2)
        found.append((turn(k1, p1, z), turn(k2, p2, z)))
    return found


def right_solve_in_a_frame(k1, k2, p1, p2):
    if abs(p1 @ p1 - p2 @ p2) > 1e-9 * (p1 @ p1):
        return np.empty((0, 2))
    n = np.cross(k1, k2)
    z0 = np.linalg.lstsq(np.array([k1, k2]), np.array([k1 @ p1, k2 @ p2]), rcond=None)[0]
    left = p1 @ p1 - z0 @ z0
    if left < -1e-9 * (p1 @ p1):
        return np.array([])
    step = np.sqrt(max(left, 0)) * n / np.linalg.norm(n)
    return np.array([[turn(k1, p1, z), turn(k2, p2, z) - 2 * np.pi] for z in (z0 - step, z0 + step)])


def right_by_subproblem_four(k1, k2, p1, p2):
    """The height of R1 p1 along k2 is that of p2; then theta2 follows."""
    A = -k2 @ np.cross(k1, np.cross(k1, p1))
    B = k2 @ np.cross(k1, p1)
    C = k2 @ p2 - (k1 @ k2) * (k1 @ p1)
    if abs(np.linalg.norm(p1) / np.linalg.norm(p2) - 1) > 1e-6 or abs(C) > (1 + 1e-9) * np.hypot(A, B):
        return ()
    middle, aside = math.atan2(B, A), math.acos(max(-1, min(1, C / math.hypot(A, B))))
    pairs = []
    for theta1 in (middle + aside, middle - aside):
        pairs.append([theta1, float(turn(k2, p2, exp_so3(theta1 * k1) @ p1))])
    return tuple(pairs)


def right_on_unit_vectors_and_by_substitution(k1, k2, p1, p2):
    u1, u2 = p1 / np.linalg.norm(p1), p2 / np.linalg.norm(p2)
    a, b = np.linalg.solve([[1, k1 @ k2], [k1 @ k2, 1]], [k1 @ u1, k2 @ u2])
    n = np.cross(k1, k2)
    g = np.sqrt(abs(1 - np.linalg.norm(a * k1 + b * k2) ** 2)) / np.linalg.norm(n)
    pairs = [(turn(k1, u1, z), turn(k2, u2, z)) for z in (a * k1 + b * k2 + s * g * n for s in (-1, 1))]
    size = np.linalg.norm(p1)
    return [t for t in pairs if np.linalg.norm(exp_so3(t[0] * k1) @ p1 - exp_so3(t[1] * k2) @ p2) < 1e-8 * size]


def right_by_the_other_axis_first(k1, k2, p1, p2):
    return [np.array([[t1], [t2]]) for t2, t1 in right_textbook(k2, k1, p2, p1)]


def right_one_where_they_touch(k1, k2, p1, p2):
    square = rest(k1, k2, p1, p2) / (p1 @ p1)
    if abs(np.sqrt(p1 @ p1) - np.sqrt(p2 @ p2)) > 1e-6 or square < -1e-9:
        return np.zeros((0, 2))
    a, b = foot(k1, k2, p1, p2)
    if square < 1e-9:
        z = a * k1 + b * k2
        return [turn(k1, p1, z), turn(k2, p2, z)]
    return right_textbook(k1, k2, p1, p2)


def wrong_only_one(k1, k2, p1, p2):
    """only one of the two pairs"""
    return right_textbook(k1, k2, p1, p2)[:1]


def wrong_one_pair_without_a_list(k1, k2, p1, p2):
    """only one of the two pairs"""
    found = right_textbook(k1, k2, p1, p2)
    return found[0] if found else []


def wrong_the_same_twice(k1, k2, p1, p2):
    """only one of the two pairs"""
    return right_textbook(k1, k2, p1, p2)[:1] * 2


def wrong_crossed(k1, k2, p1, p2):
    """theta1 of one solution stands beside theta2 of the other"""
    found = right_textbook(k1, k2, p1, p2)
    return [(a, d) for (a, b), (c, d) in zip(found, found[::-1])]


def wrong_every_combination(k1, k2, p1, p2):
    """every theta1 stands beside every theta2"""
    found = right_textbook(k1, k2, p1, p2)
    return [(t1, t2) for t1, _ in found for _, t2 in found]


def wrong_columns(k1, k2, p1, p2):
    """the two theta1 stand in one row"""
    return list(zip(*right_textbook(k1, k2, p1, p2)))


def wrong_theta2_of_the_other_convention(k1, k2, p1, p2):
    """theta2 has the other sign"""
    return [(t1, -t2) for t1, t2 in right_textbook(k1, k2, p1, p2)]


def wrong_turns_of_p2_back(k1, k2, p1, p2):
    """theta2 has the other sign"""
    a, b = foot(k1, k2, p1, p2)
    square = rest(k1, k2, p1, p2)
    if square < 0 or not np.isclose(p1 @ p1, p2 @ p2):
        return []
    points = [a * k1 + b * k2 + s * np.sqrt(square) * np.cross(k1, k2) for s in (1, -1)]
    return [(turn(k1, p1, z), turn(k2, z, p2)) for z in points]


def wrong_theta1_sign(k1, k2, p1, p2):
    """theta1 has the other sign"""
    return [(-t1, t2) for t1, t2 in right_textbook(k1, k2, p1, p2)]


def wrong_swapped(k1, k2, p1, p2):
    """theta1 and theta2 are swapped"""
    return [(t2, t1) for t1, t2 in right_textbook(k1, k2, p1, p2)]


def wrong_degrees(k1, k2, p1, p2):
    """degrees"""
    return np.degrees(right_textbook(k1, k2, p1, p2))


def _through(a, b, square, k1, k2, p1, p2):
    if square < 0 or not np.isclose(p1 @ p1, p2 @ p2):
        return []
    points = [a * k1 + b * k2 + s * np.sqrt(square) * np.cross(k1, k2) for s in (1, -1)]
    return [(turn(k1, p1, z), turn(k2, p2, z)) for z in points]


def wrong_normal_not_normalised(k1, k2, p1, p2):
    """Pythagoras is used with a wrong length"""
    a, b = foot(k1, k2, p1, p2)
    return _through(a, b, p1 @ p1 - a**2 - b**2 - 2 * a * b * (k1 @ k2), k1, k2, p1, p2)


def wrong_mixed_term_forgotten(k1, k2, p1, p2):
    """Pythagoras is used with a wrong length"""
    a, b = foot(k1, k2, p1, p2)
    return _through(a, b, (p1 @ p1 - a**2 - b**2) / (1 - (k1 @ k2) ** 2), k1, k2, p1, p2)


def wrong_length_not_squared(k1, k2, p1, p2):
    """Pythagoras is used with a wrong length"""
    a, b = foot(k1, k2, p1, p2)
    square = np.linalg.norm(p1) - a**2 - b**2 - 2 * a * b * (k1 @ k2)
    return _through(a, b, square / (1 - (k1 @ k2) ** 2), k1, k2, p1, p2)


def wrong_radius_instead_of_length(k1, k2, p1, p2):
    """Pythagoras is used with a wrong length"""
    a, b = foot(k1, k2, p1, p2)
    square = p1 @ p1 - (k1 @ p1) ** 2 - a**2 - b**2 - 2 * a * b * (k1 @ k2)
    return _through(a, b, square / (1 - (k1 @ k2) ** 2), k1, k2, p1, p2)


def wrong_perpendicular_axes(k1, k2, p1, p2):
    """the axes are taken to be perpendicular"""
    a, b = k1 @ p1, k2 @ p2
    return _through(a, b, p1 @ p1 - a**2 - b**2, k1, k2, p1, p2)


def wrong_foot(k1, k2, p1, p2):
    """a and b of the meeting point"""
    b, a = foot(k1, k2, p1, p2)
    square = p1 @ p1 - a**2 - b**2 - 2 * a * b * (k1 @ k2)
    return _through(a, b, square / (1 - (k1 @ k2) ** 2), k1, k2, p1, p2)


def wrong_lengths_not_compared(k1, k2, p1, p2):
    """the lengths of p1 and p2 are not compared"""
    a, b = foot(k1, k2, p1, p2)
    square = rest(k1, k2, p1, p2)
    if square < 0:
        return []
    points = [a * k1 + b * k2 + s * np.sqrt(square) * np.cross(k1, k2) for s in (1, -1)]
    return [(turn(k1, p1, z), turn(k2, p2, z)) for z in points]


def wrong_clipped(k1, k2, p1, p2):
    """a pair is returned although"""
    if not np.isclose(p1 @ p1, p2 @ p2):
        return []
    a, b = foot(k1, k2, p1, p2)
    g = np.sqrt(max(rest(k1, k2, p1, p2), 0))
    return [(turn(k1, p1, z), turn(k2, p2, z)) for z in (a * k1 + b * k2 + s * g * np.cross(k1, k2) for s in (1, -1))]


def wrong_root_of_the_size(k1, k2, p1, p2):
    """a pair is returned although"""
    a, b = foot(k1, k2, p1, p2)
    return _through(a, b, abs(rest(k1, k2, p1, p2)), k1, k2, p1, p2)


def wrong_root_of_a_negative_number(k1, k2, p1, p2):
    """a root of a negative number"""
    if not np.isclose(p1 @ p1, p2 @ p2):
        return []
    a, b = foot(k1, k2, p1, p2)
    g = np.sqrt(rest(k1, k2, p1, p2))
    return [(turn(k1, p1, z), turn(k2, p2, z)) for z in (a * k1 + b * k2 + s * g * np.cross(k1, k2) for s in (1, -1))]


def wrong_math_domain(k1, k2, p1, p2):
    """ValueError"""
    if not np.isclose(p1 @ p1, p2 @ p2):
        return []
    a, b = foot(k1, k2, p1, p2)
    g = math.sqrt(rest(k1, k2, p1, p2))
    return [(turn(k1, p1, z), turn(k2, p2, z)) for z in (a * k1 + b * k2 + s * g * np.cross(k1, k2) for s in (1, -1))]


def wrong_none(k1, k2, p1, p2):
    """a return is missing"""
    found = right_textbook(k1, k2, p1, p2)
    if found:
        return found


def wrong_a_flag_beside_the_list(k1, k2, p1, p2):
    """another form"""
    found = right_textbook(k1, k2, p1, p2)
    return found, len(found) > 0


def wrong_lengths_compared_exactly(k1, k2, p1, p2):
    """the list is empty although"""
    if np.linalg.norm(p1) != np.linalg.norm(p2):
        return []
    return right_textbook(k1, k2, p1, p2)


def wrong_far_too_strict(k1, k2, p1, p2):
    """the list is empty although"""
    return right_textbook(k1, k2, p1, p2) if rest(k1, k2, p1, p2) > 1 else []


def wrong_turn_without_sign(k1, k2, p1, p2):
    """unnamed"""
    return [(abs(t1), abs(t2)) for t1, t2 in right_textbook(k1, k2, p1, p2)]


def wrong_second_is_the_negative(k1, k2, p1, p2):
    """unnamed"""
    found = right_textbook(k1, k2, p1, p2)
    return [found[0], (-found[0][0], -found[0][1])] if found else []


def wrong_the_librarys(k1, k2, p1, p2):
    """course_lib.subproblems.subproblem2 is called"""
    return subproblems.subproblem2(k1, k2, p1, p2).theta


def wrong_touching_circles_missed(k1, k2, p1, p2):
    """circles that touch are taken for circles that miss"""
    a, b = foot(k1, k2, p1, p2)
    return _through(a, b, rest(k1, k2, p1, p2), k1, k2, p1, p2)


def wrong_tolerance_without_a_scale(k1, k2, p1, p2):
    """circles that touch are taken for circles that miss"""
    a, b = foot(k1, k2, p1, p2)
    square = rest(k1, k2, p1, p2)
    return _through(a, b, 0.0 if -1e-9 < square < 0 else square, k1, k2, p1, p2)
