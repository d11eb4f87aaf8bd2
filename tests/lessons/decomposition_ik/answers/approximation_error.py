"""What students write for approximation_error(xy, angles)."""

import math

import numpy as np


def right_components(xy, angles):
    t1, t2 = angles[:, :, 0], angles[:, :, 1]
    dx = np.cos(t1) + np.cos(t1 + t2) - xy[:, [0]]
    dy = np.sin(t1) + np.sin(t1 + t2) - xy[:, [1]]
    return np.sqrt(dx**2 + dy**2)


def right_lists(xy, angles):
    def distance(x, y, t1, t2):
        return math.hypot(
            math.cos(t1) + math.cos(t1 + t2) - x, math.sin(t1) + math.sin(t1 + t2) - y
        )

    return [
        [distance(*place, *pair) for pair in pairs]
        for place, pairs in zip(xy.tolist(), angles.tolist())
    ]


def right_complex_plane(xy, angles):
    first = np.exp(1j * angles[..., 0])
    return np.abs(first + first * np.exp(1j * angles[..., 1]) - (xy[:, :1] + 1j * xy[:, 1:]))


def wrong_better_of_the_two(xy, angles):
    """one distance is returned for both"""
    return right_components(xy, angles).min(axis=1)


def wrong_places_not_lined_up(xy, angles):
    """ValueError"""
    ends = np.exp(1j * np.cumsum(angles, axis=-1)).sum(axis=-1)
    return np.linalg.norm(np.stack([ends.real, ends.imag], -1) - xy, axis=-1)


def wrong_at_most_twice_the_reach(xy, angles):
    """an error is not |f(q) - xy|"""
    return np.minimum(right_components(xy, angles), 4.0)
