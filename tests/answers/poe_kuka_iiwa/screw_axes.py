"""What students write for screw_axes(omega, points)."""

import numpy as np


def right_side_by_side(omega, points):
    return np.hstack([omega, -np.cross(omega, points)])


def right_row_by_row_as_lists(omega, points):
    rows = []
    for (a, b, c), (x, y, z) in zip(omega, points):
        rows.append([a, b, c, y * c - z * b, z * a - x * c, x * b - y * a])
    return rows


def right_from_the_foot_of_the_perpendicular(omega, points):
    feet = points - (omega * points).sum(1, keepdims=True) * omega
    return tuple(np.r_[w, np.cross(foot, w)] for w, foot in zip(omega, feet))


def wrong_two_components_swapped(omega, points):
    """unnamed"""
    v = np.cross(points, omega)
    return np.hstack([omega, v[:, [1, 0, 2]]])
