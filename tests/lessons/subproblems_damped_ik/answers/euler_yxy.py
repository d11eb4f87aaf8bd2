"""What students write for euler_yxy(R)."""

import math

import numpy as np

from course_lib import subproblems
from course_lib.rotations import rot_x, rot_y

ex, ey, ez = np.eye(3)


def _rest(b1, b2, R):
    """b3, from the rest of R."""
    left = rot_x(-b2) @ rot_y(-b1) @ R
    return np.arctan2(left[0, 2], left[0, 0])


def right_by_entries(R):
    sine = np.hypot(R[0, 1], R[2, 1])
    if sine < 1e-9:
        b2 = 0.0 if R[1, 1] > 0 else np.pi
        return np.array([[0.0, b2, _rest(0.0, b2, R)]] * 2)
    b1, b2, b3 = (
        np.arctan2(R[0, 1], R[2, 1]),
        np.arctan2(sine, R[1, 1]),
        np.arctan2(R[1, 0], -R[1, 2]),
    )
    return np.array([[b1, b2, b3], [b1 + np.pi, -b2, b3 + np.pi]])


def right_by_subproblems(R):
    found = []
    for b2, back in subproblems.subproblem2(ex, ey, ey, R @ ey).theta:
        left = rot_x(-b2) @ rot_y(back) @ R
        found.append([-back, b2, float(subproblems.subproblem1(ey, ez, left @ ez).theta)])
    return found


def right_both_signs_of_arccos(R):
    triples = []
    for b2 in np.array([-1, 1]) * np.arccos(np.clip(R[1, 1], -1, 1)):
        s = 1 if b2 >= 0 else -1
        free = np.hypot(R[0, 1], R[2, 1]) < 1e-7
        b1 = 1.0 if free else np.arctan2(s * R[0, 1], s * R[2, 1])
        triples.append((b1 + 2 * np.pi, b2, float(_rest(b1, b2, R))))
    return triples


def wrong_one_row_where_both_are_one(R):
    """a triple is missing"""
    found = right_by_entries(R)
    return found[:1] if np.allclose(found[0], found[1]) else found


def wrong_free_angle_not_chosen(R):
    """the angles do not fit together"""
    b1, b3 = np.arctan2(R[0, 1], R[2, 1]), np.arctan2(R[1, 0], -R[1, 2])
    b2 = np.arccos(np.clip(R[1, 1], -1, 1))
    return np.array([[b1, b2, b3], [b1 + np.pi, -b2, b3 + np.pi]])


def wrong_arccos_not_clipped(R):
    """the answer holds nan where sin(b2) is 0"""
    b2 = np.arccos(R[1, 1])
    return np.array([[t[0], s, t[2]] for t, s in zip(right_by_entries(R), (b2, -b2))])


def wrong_small_b2_cut(R):
    """b2 near 0 or pi is treated as if it were"""
    if np.hypot(R[0, 1], R[2, 1]) > 0.01:
        return right_by_entries(R)
    b2 = 0.0 if R[1, 1] > 0 else np.pi
    return np.array([[0.0, b2, _rest(0.0, b2, R)]] * 2)


def wrong_math_acos(R):
    """ValueError"""
    b2 = math.acos(R[1, 1])
    return np.array([[t[0], s, t[2]] for t, s in zip(right_by_entries(R), (b2, -b2))])


def wrong_nan_used_further(R):
    """ValueError"""
    found = []
    for b2 in (np.arccos(R[1, 1]), -np.arccos(R[1, 1])):
        b1 = np.arctan2(np.sign(b2) * R[0, 1], np.sign(b2) * R[2, 1])
        found.append([b1, b2, _rest(b1, b2, R)])
    return found


def wrong_quotient_of_entries(R):
    """the first triple does not rebuild R"""
    b1 = np.arctan(R[0, 1] / R[2, 1]) if R[2, 1] != 0 else np.pi / 2
    b1 += np.pi if R[2, 1] < 0 else 0
    b2 = np.arctan2(np.hypot(R[0, 1], R[2, 1]), R[1, 1])
    b3 = _rest(b1, b2, R)
    return np.array([[b1, b2, b3], [b1 + np.pi, -b2, b3 + np.pi]])
