"""What students write for interpolate_body(start, goal, n)."""

import numpy as np

from course_lib import planar
from course_lib.planar import wrap_angle


def right_arrays(start, goal, n):
    way, u = np.subtract(goal, start).astype(float), np.linspace(0, 1, n)
    way[2] -= 2 * np.pi * np.round(way[2] / (2 * np.pi))
    return start + (3 * u**2 - 2 * u**3)[:, None] * way


def right_columns_with_the_library(start, goal, n):
    t, turn = np.linspace(0, 5, n), wrap_angle(goal[2] - start[2])
    ends = zip(start, [goal[0], goal[1], start[2] + turn], strict=True)
    return np.array([planar.cubic_time_scaling(t, 5, *pair) for pair in ends]).T


def right_theta_wrapped(start, goal, n):
    poses = right_arrays(start, goal, n)
    poses[:, 2] = np.arctan2(np.sin(poses[:, 2]), np.cos(poses[:, 2]))
    return poses


def wrong_larger_change(start, goal, n):
    """the body takes the longer arc"""
    change = np.subtract(goal, start).astype(float)
    change[2] = np.angle(np.exp(1j * change[2]))
    change[2] -= np.copysign(2 * np.pi, change[2])
    u = np.linspace(0, 1, n)[:, None]
    return start + (3 * u**2 - 2 * u**3) * change
