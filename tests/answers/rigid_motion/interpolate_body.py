"""What students write for interpolate_body(start, goal, n)."""

import numpy as np

from course_lib import planar
from course_lib.planar import wrap_angle


def _wrap(angle):
    return angle - 2 * np.pi * np.round(angle / (2 * np.pi))


def _scaling(n):
    u = np.linspace(0, 1, n)
    return 3 * u**2 - 2 * u**3


def _arrays(start, goal):
    return np.array(start, float), np.array(goal, float)


def _along(start, way, s):
    return start + s[:, None] * way


def right_arrays(start, goal, n):
    start, goal = _arrays(start, goal)
    way = goal - start
    way[2] = _wrap(way[2])
    return _along(start, way, _scaling(n))


def right_columns_with_the_library(start, goal, n):
    t = np.linspace(0, 5, n)
    turn = wrap_angle(goal[2] - start[2])
    ends = zip(start, [goal[0], goal[1], start[2] + turn], strict=True)
    return np.array([planar.cubic_time_scaling(t, 5, *pair) for pair in ends]).T


def right_theta_wrapped(start, goal, n):
    poses = right_arrays(start, goal, n)
    poses[:, 2] = np.arctan2(np.sin(poses[:, 2]), np.cos(poses[:, 2]))
    return poses


def wrong_every_second_pose_twice(start, goal, n):
    """unnamed"""
    poses = right_arrays(start, goal, n)
    return poses[np.arange(n) // 2 * 2]
