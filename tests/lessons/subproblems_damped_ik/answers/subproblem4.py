"""What students write for subproblem4(k, h, p, d)."""

import cmath
import math

import numpy as np

from course_lib.rotations import exp_so3, hat


def _beside(k, h, p, d):
    """The angle from p to h about k, and the cosine of the angle beside it."""
    a, b = p - (k @ p) * k, h - (k @ h) * k
    lengths = np.linalg.norm(a) * np.linalg.norm(b)
    return np.arctan2(k @ np.cross(a, b), a @ b), (d - (k @ h) * (k @ p)) / lengths


def right_by_components(k, h, p, d):
    K = hat(k)
    A, B, C = -h @ K @ K @ p, h @ K @ p, d - h @ (p + K @ K @ p)
    under = A * A + B * B - C * C
    if under < 0:
        return np.empty(0)
    root = B + math.copysign(math.sqrt(under), B)
    return np.array([2 * math.atan2(root, A + C), 2 * math.atan2(C - A, root)])[None]


def right_complex_numbers(k, h, p, d):
    """z + 1/z with z = exp(i theta): a quadratic equation whose roots lie on the unit circle, or there are none."""
    A, B = h @ (p - (k @ p) * k), h @ np.cross(k, p)
    roots = np.roots([A - 1j * B, -2 * (d - (k @ h) * (k @ p)), A + 1j * B])
    return [cmath.phase(z) for z in roots if abs(abs(z) - 1) < 1e-7]


def right_by_substitution(k, h, p, d):
    phi, cosine = _beside(k, h, p, d)
    both = [[phi + s * np.arccos(np.clip(cosine, -1, 1)) + 4 * np.pi] for s in (1, -1)]
    return [
        t
        for t in both
        if abs(h @ exp_so3(t[0] * k) @ p - d) < 1e-9 * np.linalg.norm(h) * np.linalg.norm(p)
    ]


def wrong_out_of_range(k, h, p, d):
    """nan is returned where there is no solution"""
    phi, cosine = _beside(k, h, p, d)
    return [phi + np.arccos(cosine), phi - np.arccos(cosine)]


def wrong_compared_with_full_lengths(k, h, p, d):
    """an angle is returned although"""
    phi, cosine = _beside(k, h, p, d)
    swing = np.arccos(np.clip(cosine, -1, 1))
    return [phi + swing, phi - swing] if abs(d) <= np.linalg.norm(h) * np.linalg.norm(p) else []


def wrong_generous_clipping(k, h, p, d):
    """an angle is returned although no angle is right"""
    phi, cosine = _beside(k, h, p, d)
    if abs(cosine) > 1.1:
        return []
    return [phi + s * np.arccos(np.clip(cosine, -1, 1)) for s in (1, -1)]


def wrong_nearly_equal_solutions_merged(k, h, p, d):
    """only one of the two solutions is returned"""
    angles = np.ravel(right_by_components(k, h, p, d))
    if len(angles) == 2 and abs(np.exp(1j * angles[0]) - np.exp(1j * angles[1])) < 3e-4:
        return angles[:1]
    return angles


def wrong_part_across_in_integers(k, h, p, d):
    """the answer is wrong for arrays of integers only"""
    across = p.copy()
    across[:] = p - (k @ p) * k
    return right_by_components(k, h, across, d - (k @ p) * (k @ h))


def wrong_margin_in_metres(k, h, p, d):
    """an angle is returned although no angle is right"""
    middle = (k @ h) * (k @ p)
    radius = np.linalg.norm(np.cross(k, h)) * np.linalg.norm(np.cross(k, p))
    if abs(d - middle) > radius + 1e-6:
        return []
    aligned = np.arctan2(k @ np.cross(p, h), p @ h - middle)
    swing = np.arccos(np.clip((d - middle) / radius, -1, 1))
    return [aligned + swing, aligned - swing]
