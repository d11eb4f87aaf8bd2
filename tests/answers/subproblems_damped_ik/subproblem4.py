"""What students write for subproblem4(k, h, p, d)."""

import cmath
import math

import numpy as np

from course_lib import subproblems
from course_lib.rotations import exp_so3, hat


def across(k, p):
    return p - (k @ p) * k


def turn(k, p, q):
    p, q = across(k, p), across(k, q)
    return np.arctan2(k @ np.cross(p, q), p @ q)


def lengths(k, h, p):
    return np.linalg.norm(across(k, h)) * np.linalg.norm(across(k, p))


def right_by_the_angle_beside_h(k, h, p, d):
    cosine = (d - (k @ h) * (k @ p)) / lengths(k, h, p)
    if cosine < -1 or cosine > 1:
        return []
    return [turn(k, p, h) + np.arccos(cosine), turn(k, p, h) - np.arccos(cosine)]


def right_by_components(k, h, p, d):
    K = hat(k)
    A, B, C = -h @ K @ K @ p, h @ K @ p, d - h @ (p + K @ K @ p)
    under = A * A + B * B - C * C
    if under < 0:
        return np.empty(0)
    return np.array([2 * math.atan2(B + s * math.sqrt(under), A + C) for s in (-1, 1)])[None]


def right_by_least_squares(k, h, p, d):
    """The shortest (cos, sin) on the line A cos + B sin = C, and from there both ways along the line."""
    A = np.array([[h @ across(k, p), h @ np.cross(k, p)]])
    C = d - (k @ h) * (k @ p)
    x = np.linalg.pinv(A)[:, 0] * C
    if x @ x > 1:
        return tuple()
    step = np.sqrt(1 - x @ x) * np.array([-A[0, 1], A[0, 0]]) / np.linalg.norm(A)
    return tuple(float(np.arctan2(*(x + s * step)[::-1])) for s in (1, -1))


def right_complex_numbers(k, h, p, d):
    """z + 1/z with z = exp(i theta): a quadratic equation whose roots lie on the unit circle, or there are none."""
    A, B = h @ across(k, p), h @ np.cross(k, p)
    roots = np.roots([A - 1j * B, -2 * (d - (k @ h) * (k @ p)), A + 1j * B])
    return [cmath.phase(z) for z in roots if abs(abs(z) - 1) < 1e-7]


def right_once_where_they_meet(k, h, p, d):
    cosine = (d - (k @ h) * (k @ p)) / lengths(k, h, p)
    if abs(abs(cosine) - 1) < 1e-9:
        return [turn(k, p, h) + (0 if cosine > 0 else np.pi)]
    if abs(cosine) > 1:
        return [[]]
    return [[turn(k, p, h) + 4 * np.pi - np.arccos(cosine)], [turn(k, p, h) + np.arccos(cosine)]]


def right_by_substitution(k, h, p, d):
    cosine = np.clip((d - (k @ h) * (k @ p)) / lengths(k, h, p), -1, 1)
    both = [turn(k, p, h) + s * np.arccos(cosine) for s in (1, -1)]
    return [t for t in both if abs(h @ exp_so3(t * k) @ p - d) < 1e-9 * np.linalg.norm(h) * np.linalg.norm(p)]


def _two(k, h, p, cosine):
    if not abs(cosine) <= 1:
        return []
    return [turn(k, p, h) + np.arccos(cosine), turn(k, p, h) - np.arccos(cosine)]


def wrong_height_forgotten(k, h, p, d):
    """the height along the axis is forgotten"""
    return _two(k, h, p, d / lengths(k, h, p))


def wrong_nothing_projected(k, h, p, d):
    """the height along the axis is forgotten"""
    return _two(k, h, p, d / np.linalg.norm(h) / np.linalg.norm(p))


def wrong_height_added(k, h, p, d):
    """the height along the axis is subtracted wrongly"""
    return _two(k, h, p, (d + (k @ h) * (k @ p)) / lengths(k, h, p))


def wrong_height_of_p_alone(k, h, p, d):
    """the height along the axis is subtracted wrongly"""
    return _two(k, h, p, (d - k @ p) / lengths(k, h, p))


def wrong_full_lengths(k, h, p, d):
    """lengths are divided out"""
    return _two(k, h, p, (d - (k @ h) * (k @ p)) / np.linalg.norm(h) / np.linalg.norm(p))


def wrong_no_lengths(k, h, p, d):
    """lengths are divided out"""
    return _two(k, h, p, d - (k @ h) * (k @ p))


def wrong_h_taken_for_a_unit_vector(k, h, p, d):
    """lengths are divided out"""
    return _two(k, h, p, (d - (k @ h) * (k @ p)) / np.linalg.norm(across(k, p)))


def wrong_h_made_a_unit_vector(k, h, p, d):
    """h is divided by its length"""
    return right_by_components(k, h / np.linalg.norm(h), p, d)


def wrong_arctan2_of_cosine_and_sine(k, h, p, d):
    """has sine and cosine swapped"""
    A, B, C = h @ across(k, p), h @ np.cross(k, p), d - (k @ h) * (k @ p)
    swing = np.arccos(C / np.hypot(A, B)) if abs(C) <= np.hypot(A, B) else None
    return [] if swing is None else [np.arctan2(A, B) + swing, np.arctan2(A, B) - swing]


def wrong_arccos_alone(k, h, p, d):
    """the angle from p to h is left out"""
    return [t - turn(k, p, h) for t in right_by_the_angle_beside_h(k, h, p, d)]


def wrong_turn_from_h(k, h, p, d):
    """the angle from h to p is taken"""
    return [t - 2 * turn(k, p, h) for t in right_by_the_angle_beside_h(k, h, p, d)]


def wrong_turn_without_sign(k, h, p, d):
    """the angle from p to h has lost its sign"""
    middle = turn(k, p, h)
    return [t - middle + abs(middle) for t in right_by_the_angle_beside_h(k, h, p, d)]


def wrong_arcsin(k, h, p, d):
    """sine and cosine are swapped"""
    sine = (d - (k @ h) * (k @ p)) / lengths(k, h, p)
    if abs(sine) > 1:
        return []
    return [turn(k, p, h) + np.arcsin(sine), turn(k, p, h) + np.pi - np.arcsin(sine)]


def wrong_arcsin_on_both_sides(k, h, p, d):
    """sine and cosine are swapped"""
    sine = (d - (k @ h) * (k @ p)) / lengths(k, h, p)
    return [turn(k, p, h) + s * np.arcsin(sine) for s in (1, -1)] if abs(sine) <= 1 else []


def wrong_degrees(k, h, p, d):
    """degrees"""
    return [math.degrees(t) for t in right_by_the_angle_beside_h(k, h, p, d)]


def wrong_only_one(k, h, p, d):
    """only one of the two angles"""
    return right_by_components(k, h, p, d)[..., :1]


def wrong_first_of_both_twice(k, h, p, d):
    """only one of the two angles"""
    return right_by_the_angle_beside_h(k, h, p, d)[:1] * 2


def wrong_out_of_range(k, h, p, d):
    """arccos is asked outside"""
    cosine = (d - (k @ h) * (k @ p)) / lengths(k, h, p)
    return [turn(k, p, h) + np.arccos(cosine), turn(k, p, h) - np.arccos(cosine)]


def wrong_out_of_range_by_math(k, h, p, d):
    """ValueError"""
    cosine = (d - (k @ h) * (k @ p)) / lengths(k, h, p)
    return [turn(k, p, h) + math.acos(cosine), turn(k, p, h) - math.acos(cosine)]


def wrong_clipped(k, h, p, d):
    """an angle is returned although"""
    cosine = np.clip((d - (k @ h) * (k @ p)) / lengths(k, h, p), -1, 1)
    return [turn(k, p, h) + np.arccos(cosine), turn(k, p, h) - np.arccos(cosine)]


def wrong_too_low_is_not_seen(k, h, p, d):
    """an angle is returned although"""
    cosine = (d - (k @ h) * (k @ p)) / lengths(k, h, p)
    if cosine > 1:
        return []
    cosine = max(cosine, -1)
    return [turn(k, p, h) + np.arccos(cosine), turn(k, p, h) - np.arccos(cosine)]


def wrong_compared_with_full_lengths(k, h, p, d):
    """an angle is returned although"""
    if abs(d) > np.linalg.norm(h) * np.linalg.norm(p):
        return []
    cosine = np.clip((d - (k @ h) * (k @ p)) / lengths(k, h, p), -1, 1)
    return [turn(k, p, h) + np.arccos(cosine), turn(k, p, h) - np.arccos(cosine)]


def wrong_complex_root(k, h, p, d):
    """another form"""
    A, B, C = h @ across(k, p), h @ np.cross(k, p), d - (k @ h) * (k @ p)
    root = cmath.sqrt(A * A + B * B - C * C)
    return [2 * cmath.atan((B + s * root) / (A + C + 1e-300)) for s in (1, -1)]


def wrong_sign_of_d(k, h, p, d):
    """the height is taken to be -d"""
    return right_by_the_angle_beside_h(k, -h, p, d)


def wrong_sign_of_both(k, h, p, d):
    """the angle from h to p is taken"""
    return [-t for t in right_by_the_angle_beside_h(k, h, p, d)]


def wrong_strictly_positive_only(k, h, p, d):
    """the list is empty although"""
    return right_by_the_angle_beside_h(k, h, p, d) if d > 0 else []


def wrong_none(k, h, p, d):
    """a return is missing"""
    found = right_by_the_angle_beside_h(k, h, p, d)
    return found if found else None


def wrong_quarter_turn_off(k, h, p, d):
    """sine and cosine are swapped"""
    return [t + np.pi / 2 for t in right_by_the_angle_beside_h(k, h, p, d)]


def wrong_arctan_of_the_quotient(k, h, p, d):
    """is wrong beyond 90 degrees"""
    A, B, C = h @ across(k, p), h @ np.cross(k, p), d - (k @ h) * (k @ p)
    if abs(C) > np.hypot(A, B):
        return []
    return [np.arctan(B / (A + 1e-300)) + s * np.arccos(C / np.hypot(A, B)) for s in (1, -1)]


def wrong_the_librarys(k, h, p, d):
    """course_lib.subproblems.subproblem4 is called"""
    return subproblems.subproblem4(k, h, p, d).theta


def wrong_A_with_the_constant(k, h, p, d):
    """the height along the axis is subtracted wrongly"""
    A, B, constant = h @ p, h @ np.cross(k, p), (k @ h) * (k @ p)
    r, phi = np.hypot(A, B), np.arctan2(B, A)
    if abs(d - constant) > r:
        return []
    return [phi + np.arccos((d - constant) / r), phi - np.arccos((d - constant) / r)]


def wrong_no_constant_at_all(k, h, p, d):
    """the height along the axis is forgotten"""
    A, B = h @ p, h @ np.cross(k, p)
    r, phi = np.hypot(A, B), np.arctan2(B, A)
    if abs(d) > r:
        return []
    return [phi + np.arccos(d / r), phi - np.arccos(d / r)]


def wrong_second_is_minus_the_first(k, h, p, d):
    """the second solution is the first with the other sign"""
    constant = (k @ h) * (k @ p)
    A, B = h @ p - constant, h @ np.cross(k, p)
    if abs(d - constant) > np.hypot(A, B):
        return []
    theta = np.arctan2(B, A) + np.arccos((d - constant) / np.hypot(A, B))
    return [theta, -theta]
