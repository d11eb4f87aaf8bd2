"""What students write for cubic_time_scaling(t, T, s0, s1, v0, v1)."""

import numpy as np
from scipy.interpolate import CubicHermiteSpline


def right_textbook(t, T, s0, s1, v0, v1):
    u = t / T
    way = s1 - s0
    return (
        s0 + v0 * T * u + (3 * way - (2 * v0 + v1) * T) * u**2 + (-2 * way + (v0 + v1) * T) * u**3
    )


def right_coefficients_of_t(t, T, s0, s1, v0, v1):
    a2 = 3 * (s1 - s0) / T**2 - (2 * v0 + v1) / T
    a3 = -2 * (s1 - s0) / T**3 + (v0 + v1) / T**2
    return np.polyval([a3, a2, v0, s0], t)


def right_spline_of_scipy(t, T, s0, s1, v0, v1):
    return CubicHermiteSpline([0, T], [s0, s1], [v0, v1])(t)


def wrong_flat(t, T, s0, s1, v0, v1):
    """the answer is flattened"""
    value = right_textbook(t, T, s0, s1, v0, v1)
    return np.ravel(value) if np.ndim(t) > 1 else value


def wrong_goal_a_moment_too_early(t, T, s0, s1, v0, v1):
    """the answer is right to its first digits only"""
    return np.where(np.asarray(t) > T - 1e-3, s1, right_textbook(t, T, s0, s1, v0, v1))


def wrong_nearly_equal_velocities(t, T, s0, s1, v0, v1):
    """the answer is right to its first digits only"""
    return right_textbook(t, T, s0, s1, v0, v0 if np.isclose(v0, v1) else v1)


def wrong_nearly_equal_ends(t, T, s0, s1, v0, v1):
    """the answer is right to its first digits only"""
    stays = v0 == v1 == 0 and np.isclose(s0, s1)
    return np.full(np.shape(t), float(s0)) if stays else right_textbook(t, T, s0, s1, v0, v1)
