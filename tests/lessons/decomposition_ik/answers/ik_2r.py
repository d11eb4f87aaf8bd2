"""What students write for ik_2r(xy)."""

import math

import numpy as np

from course_lib.subproblems import subproblem1, subproblem3


def right_law_of_cosines(xy):
    x, y = xy
    if np.hypot(x, y) > 2 + 1e-9:
        return np.full((2, 2), np.nan)
    bend = np.arccos(np.clip((x**2 + y**2 - 2) / 2, -1, 1))
    return np.array(
        [[np.arctan2(y, x) - np.arctan2(np.sin(t), 1 + np.cos(t)), t] for t in (bend, -bend)]
    )


def right_half_angles_in_lists_a_turn_up(xy):
    r, towards = math.hypot(*xy), math.atan2(xy[1], xy[0]) + 2 * math.pi
    if r > 2.000001:
        return [[math.nan, math.nan], [math.nan, math.nan]]
    half = math.acos(min(r / 2, 1))
    return [[towards - half, 2 * half], [towards + half, -2 * half]]


def right_by_subproblems(xy):
    z, x, place = np.array([0, 0, 1.0]), np.array([1.0, 0, 0]), np.array([*xy, 0.0])
    if np.linalg.norm(xy) > 2 + 1e-6:
        return np.full((2, 2), np.nan)
    bends = subproblem3(z, x, -x, np.linalg.norm(xy)).theta
    bends = [max(bends), min(bends)] if xy.any() else [np.pi, np.pi]
    return [
        [float(subproblem1(z, x + [np.cos(t), np.sin(t), 0], place).theta) if xy.any() else 0.3, t]
        for t in bends
    ]


def wrong_edge_out_of_reach(xy):
    """positions at the edge"""
    return right_law_of_cosines(xy) if np.hypot(*xy) <= 2 else np.full((2, 2), np.nan)


def wrong_math_acos(xy):
    """ValueError"""
    bend = math.acos((xy[0] ** 2 + xy[1] ** 2 - 2) / 2)
    return [[math.atan2(xy[1], xy[0]) - t / 2, t] for t in (bend, -bend)]


def wrong_one_row_of_nan(xy):
    """the answer for a position out of reach has another shape"""
    return [np.nan, np.nan] if np.linalg.norm(xy) > 2.1 else right_law_of_cosines(xy)


def wrong_sorted(xy):
    """the angle of the elbow is right, and the first one is not"""
    return np.sort(right_law_of_cosines(xy), axis=1)


def wrong_stretched_too_early(xy):
    """a position near the edge of the workspace gets the answer of the stretched arm"""
    r = np.hypot(*xy)
    if r > 2 + 1e-9:
        return np.full((2, 2), np.nan)
    q2 = 0.0 if r > 1.99 else np.arccos(np.clip(r**2 / 2 - 1, -1, 1))
    first = np.arctan2(xy[1], xy[0])
    return np.array([[first - q2 / 2, q2], [first + q2 / 2, -q2]])


def wrong_folded_too_early(xy):
    """the arm is taken for folded although the tip is not at the base"""
    if 0 < np.hypot(*xy) < 1e-4:
        first = np.arctan2(xy[1], xy[0])
        return np.array([[first - np.pi / 2, np.pi], [first + np.pi / 2, -np.pi]])
    return right_law_of_cosines(xy)
