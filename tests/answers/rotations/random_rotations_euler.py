"""What students write for random_rotations_euler(n, rng)."""

import numpy as np

from course_lib.rotations import rot_x, rot_y, rot_z


def right_arrays(n, rng):
    alpha, beta, gamma = 2 * np.pi * rng.random(n), np.pi * rng.random(n), 2 * np.pi * rng.random(n)
    return rot_z(gamma) @ rot_y(beta) @ rot_x(alpha)


def right_angles_about_zero(n, rng):
    alpha, gamma = rng.uniform(-np.pi, np.pi, size=(2, n))
    beta = np.pi - rng.uniform(0, np.pi, size=n)
    return np.einsum("nij,njk,nkl->nil", rot_z(gamma), rot_y(beta), rot_x(alpha))


def wrong_beta_spread_as_the_sine(n, rng):
    """beta is not uniform in [0, pi]"""
    alpha, beta, gamma = 2 * np.pi * rng.random(n), np.arccos(1 - 2 * rng.random(n)), 2 * np.pi * rng.random(n)
    return rot_z(gamma) @ rot_y(beta) @ rot_x(alpha)


def right_gamma_up_to_pi(n, rng):
    """Of the same distribution: with beta beyond pi/2 both others grow by pi."""
    a, b, c = 2 * np.pi * rng.random(n), np.pi * rng.random(n), np.pi * rng.random(n)
    return rot_z(c) @ rot_y(b) @ rot_x(a)
