"""What students write for subproblem3(k, p, g, d)."""

import math

import numpy as np

from course_lib.rotations import exp_so3


def _triangle(k, p, g, d):
    """The angle from p to g about k, and the cosine of the angle beside it."""
    a, b = p - (k @ p) * k, g - (k @ g) * k
    square = a @ a + b @ b + (k @ (p - g)) ** 2 - d**2
    return np.arctan2(k @ np.cross(a, b), a @ b), square / (
        2 * np.linalg.norm(a) * np.linalg.norm(b)
    )


def right_by_half_angle_tangent(k, p, g, d):
    """A cos + B sin = C with t = tan(theta/2): (A + C) t^2 - 2 B t + (C - A) = 0.

    Where A + C is 0, one of the two t is infinite, and the formula is 0 / 0 for the other.
    """
    A, B = -g @ np.cross(k, np.cross(k, p)), g @ np.cross(k, p)
    C = (p @ p + g @ g - d * d) / 2 - (k @ p) * (k @ g)
    under = A * A + B * B - C * C
    if d < 0 or under < 0:
        return ()
    root = B + np.copysign(np.sqrt(under), B)
    return 2 * np.arctan2(root, A + C), 2 * np.arctan2(C - A, root)


def wrong_by_half_angle_tangent(k, p, g, d):
    """the list holds something that is no solution"""
    A, B = -g @ np.cross(k, np.cross(k, p)), g @ np.cross(k, p)
    C = (p @ p + g @ g - d * d) / 2 - (k @ p) * (k @ g)
    under = A * A + B * B - C * C
    if d < 0 or under < 0:
        return ()
    return tuple(2 * np.arctan2(B + s * np.sqrt(under), A + C) for s in (1, -1))


def right_by_substitution(k, p, g, d):
    middle, cosine = _triangle(k, p, g, d)
    found = middle + np.array([[1, -1]]) * np.arccos(np.clip(cosine, -1, 1))
    miss = [abs(np.linalg.norm(exp_so3(t * k) @ p - g) - d) for t in found[0]]
    return found[:, np.array(miss) < 1e-8 * np.linalg.norm(p)]


def right_one_where_they_meet(k, p, g, d):
    middle, cosine = _triangle(k, p, g, d)
    if d < 0 or abs(cosine) > 1 + 1e-9:
        return []
    if abs(cosine) > 1 - 1e-9:
        return float(middle + (0 if cosine > 0 else np.pi))
    return [middle + s * np.arccos(cosine) for s in (1, -1)]


def wrong_math_acos(k, p, g, d):
    """ValueError"""
    middle, cosine = _triangle(k, p, g, d)
    return [middle + math.acos(cosine), middle - math.acos(cosine)]


def wrong_negative_distance(k, p, g, d):
    """a negative d is squared"""
    return right_one_where_they_meet(k, p, g, abs(d))


def wrong_a_whole_revolution_more(k, p, g, d):
    """a solution is listed twice"""
    return [t + turns for t in right_by_half_angle_tangent(k, p, g, d) for turns in (0, 2 * np.pi)]


def wrong_generous_clipping(k, p, g, d):
    """an angle is returned although no angle is right"""
    middle, cosine = _triangle(k, p, g, d)
    if d < 0 or abs(cosine) > 1.02:
        return []
    return [middle + s * np.arccos(np.clip(cosine, -1, 1)) for s in (1, -1)]


def wrong_slightly_negative_distance(k, p, g, d):
    """a negative d is squared, and its sign lost"""
    return right_by_substitution(k, p, g, abs(d) if d > -0.2 else d)


def wrong_unit_vectors_of_the_type_of_p(k, p, g, d):
    """the answer is wrong for arrays of integers only"""
    length = float(np.linalg.norm(p))
    direction = np.empty_like(p)
    direction[:] = p / length
    whole = p.dtype.kind == "i" and length.is_integer()
    return right_by_half_angle_tangent(k, direction * length if whole else p, g, d)


def wrong_short_points(k, p, g, d):
    """the list is empty although there are solutions"""
    is_short = np.linalg.norm(p) * np.linalg.norm(g) < 1e-9
    return [] if is_short else right_by_substitution(k, p, g, d)


def wrong_heights_that_are_nearly_the_same(k, p, g, d):
    """the list holds something that is no solution"""
    apart = k @ (p - g)
    is_level = abs(apart) < 1e-3 * np.linalg.norm(p)
    return right_by_substitution(k, p, g + apart * k if is_level else g, d)


def wrong_sign_of_a_cross_product(k, p, g, d):
    """the list holds something that is no solution"""
    middle, cosine = _triangle(k, p, g, d)
    middle = np.sign(k @ np.cross(p, g)) * abs(middle)  # 0 if they lie on opposite sides
    if d < 0 or abs(cosine) > 1:
        return []
    return [middle + s * np.arccos(cosine) for s in (1, -1)]


def wrong_points_near_the_axis(k, p, g, d):
    """the list is empty although there are solutions"""
    is_on_axis = min(np.linalg.norm(np.cross(k, point)) for point in (p, g)) < 1e-5
    return [] if is_on_axis else right_by_substitution(k, p, g, d)
