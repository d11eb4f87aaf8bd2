"""What students write for random_rotations_euler(n, rng)."""

import math

import numpy as np

from course_lib.rotations import rot_x, rot_y, rot_z


def right_arrays(n, rng):
    alpha, beta, gamma = 2 * np.pi * rng.random(n), np.pi * rng.random(n), 2 * np.pi * rng.random(n)
    return rot_z(gamma) @ rot_y(beta) @ rot_x(alpha)


def right_loop(n, rng):
    matrices = []
    for _ in range(n):
        a, b, c = rng.uniform(0, [2 * math.pi, math.pi, 2 * math.pi])
        X = np.array([[1, 0, 0], [0, math.cos(a), -math.sin(a)], [0, math.sin(a), math.cos(a)]])
        Y = np.array([[math.cos(b), 0, math.sin(b)], [0, 1, 0], [-math.sin(b), 0, math.cos(b)]])
        Z = np.array([[math.cos(c), -math.sin(c), 0], [math.sin(c), math.cos(c), 0], [0, 0, 1]])
        matrices.append(Z @ Y @ X)
    return matrices


def right_angles_about_zero(n, rng):
    alpha, gamma = rng.uniform(-np.pi, np.pi, size=(2, n))
    beta = np.pi - rng.uniform(0, np.pi, size=n)
    return np.einsum("nij,njk,nkl->nil", rot_z(gamma), rot_y(beta), rot_x(alpha))


def right_entry_by_entry(n, rng):
    angles = rng.random((n, 3)) * [2 * np.pi, np.pi, 2 * np.pi]
    (a, b, c), (A, B, C) = np.cos(angles).T, np.sin(angles).T
    R = np.zeros((n, 3, 3))
    R[:, 0, 0], R[:, 0, 1], R[:, 0, 2] = c * b, c * B * A - C * a, c * B * a + C * A
    R[:, 1, 0], R[:, 1, 1], R[:, 1, 2] = C * b, C * B * A + c * a, C * B * a - c * A
    R[:, 2, 0], R[:, 2, 1], R[:, 2, 2] = -B, b * A, b * a
    return R


def wrong_numpy_random(n, rng):
    """the numbers do not come from rng"""
    alpha, beta, gamma = 2 * np.pi * np.random.rand(n), np.pi * np.random.rand(n), 2 * np.pi * np.random.rand(n)
    return rot_z(gamma) @ rot_y(beta) @ rot_x(alpha)


def wrong_own_generator(n, rng):
    """a generator is made inside the function"""
    rng = np.random.default_rng(0)
    alpha, beta, gamma = 2 * np.pi * rng.random(n), np.pi * rng.random(n), 2 * np.pi * rng.random(n)
    return rot_z(gamma) @ rot_y(beta) @ rot_x(alpha)


def wrong_own_generator_without_seed(n, rng):
    """the numbers do not come from rng"""
    rng = np.random.default_rng()
    alpha, beta, gamma = 2 * np.pi * rng.random(n), np.pi * rng.random(n), 2 * np.pi * rng.random(n)
    return rot_z(gamma) @ rot_y(beta) @ rot_x(alpha)


def wrong_own_seed(n, rng):
    """a generator is made inside the function"""
    np.random.seed(1)
    alpha, beta, gamma = np.random.rand(3, n) * [[2 * np.pi], [np.pi], [2 * np.pi]]
    return rot_z(gamma) @ rot_y(beta) @ rot_x(alpha)


def wrong_one_draw_repeated(n, rng):
    """one draw is repeated"""
    alpha, beta, gamma = rng.random(3) * [2 * np.pi, np.pi, 2 * np.pi]
    return np.array([rot_z(gamma) @ rot_y(beta) @ rot_x(alpha)] * n)


def wrong_order(n, rng):
    """the factors stand in the other order"""
    alpha, beta, gamma = 2 * np.pi * rng.random(n), np.pi * rng.random(n), 2 * np.pi * rng.random(n)
    return rot_x(alpha) @ rot_y(beta) @ rot_z(gamma)


def wrong_transposed(n, rng):
    """transposed"""
    alpha, beta, gamma = 2 * np.pi * rng.random(n), np.pi * rng.random(n), 2 * np.pi * rng.random(n)
    return np.swapaxes(rot_z(gamma) @ rot_y(beta) @ rot_x(alpha), 1, 2)


def wrong_sine_in_y(n, rng):
    """the sine in Ry"""
    alpha, beta, gamma = 2 * np.pi * rng.random(n), np.pi * rng.random(n), 2 * np.pi * rng.random(n)
    return rot_z(gamma) @ np.swapaxes(rot_y(beta), 1, 2) @ rot_x(alpha)


def wrong_full_turn_for_beta(n, rng):
    """beta is drawn from the full circle, from -pi/2 to pi/2, or in degrees"""
    alpha, beta, gamma = 2 * np.pi * rng.random((3, n))
    return rot_z(gamma) @ rot_y(beta) @ rot_x(alpha)


def wrong_beta_about_zero(n, rng):
    """beta is drawn from the full circle, from -pi/2 to pi/2, or in degrees"""
    alpha, beta, gamma = 2 * np.pi * rng.random(n), np.pi * (rng.random(n) - 0.5), 2 * np.pi * rng.random(n)
    return rot_z(gamma) @ rot_y(beta) @ rot_x(alpha)


def wrong_half_turn_for_all(n, rng):
    """alpha and gamma are drawn from half the circle"""
    alpha, beta, gamma = np.pi * rng.random((3, n))
    return rot_z(gamma) @ rot_y(beta) @ rot_x(alpha)


def wrong_degrees(n, rng):
    """in degrees"""
    alpha, beta, gamma = 360 * rng.random(n), 180 * rng.random(n), 360 * rng.random(n)
    return rot_z(gamma) @ rot_y(beta) @ rot_x(alpha)


def wrong_pi_forgotten(n, rng):
    """beta is not uniform in [0, pi]"""
    alpha, beta, gamma = rng.random((3, n))
    return rot_z(gamma) @ rot_y(beta) @ rot_x(alpha)


def wrong_normal(n, rng):
    """beta is drawn from the full circle, from -pi/2 to pi/2, or in degrees"""
    alpha, beta, gamma = np.pi * rng.normal(size=(3, n))
    return rot_z(gamma) @ rot_y(beta) @ rot_x(alpha)


def wrong_alpha_normal(n, rng):
    """alpha or gamma is not uniform on the full circle"""
    alpha, beta, gamma = rng.normal(size=n), np.pi * rng.random(n), 2 * np.pi * rng.random(n)
    return rot_z(gamma) @ rot_y(beta) @ rot_x(alpha)


def wrong_one_draw_for_two_angles(n, rng):
    """the same draw serves"""
    turn = rng.random(n)
    return rot_z(2 * np.pi * turn) @ rot_y(np.pi * rng.random(n)) @ rot_x(2 * np.pi * turn)


def wrong_one_draw_for_two_neighbours(n, rng):
    """the same draw serves"""
    turn = rng.random(n)
    return rot_z(2 * np.pi * rng.random(n)) @ rot_y(np.pi * turn) @ rot_x(2 * np.pi * turn)


def wrong_one_draw_for_all(n, rng):
    """the same draw serves"""
    turn = rng.random(n)
    return rot_z(2 * np.pi * turn) @ rot_y(np.pi * turn) @ rot_x(2 * np.pi * turn)


def wrong_beta_spread_as_the_sine(n, rng):
    """beta is not uniform in [0, pi]"""
    alpha, beta, gamma = 2 * np.pi * rng.random(n), np.arccos(1 - 2 * rng.random(n)), 2 * np.pi * rng.random(n)
    return rot_z(gamma) @ rot_y(beta) @ rot_x(alpha)


def wrong_z_y_z(n, rng):
    """Rz Ry Rz"""
    alpha, beta, gamma = 2 * np.pi * rng.random(n), np.pi * rng.random(n), 2 * np.pi * rng.random(n)
    return rot_z(gamma) @ rot_y(beta) @ rot_z(alpha)


def wrong_sum_for_product(n, rng):
    """not orthogonal"""
    alpha, beta, gamma = 2 * np.pi * rng.random(n), np.pi * rng.random(n), 2 * np.pi * rng.random(n)
    return rot_z(gamma) + rot_y(beta) + rot_x(alpha)


def wrong_star_for_product(n, rng):
    """not orthogonal"""
    alpha, beta, gamma = 2 * np.pi * rng.random(n), np.pi * rng.random(n), 2 * np.pi * rng.random(n)
    return rot_z(gamma) * rot_y(beta) * rot_x(alpha)


def wrong_one_matrix(n, rng):
    """another form"""
    alpha, beta, gamma = rng.random(3) * [2 * np.pi, np.pi, 2 * np.pi]
    return rot_z(gamma) @ rot_y(beta) @ rot_x(alpha)


def wrong_return_inside_the_loop(n, rng):
    """another form"""
    matrices = []
    for _ in range(n):
        alpha, beta, gamma = rng.random(3) * [2 * np.pi, np.pi, 2 * np.pi]
        matrices.append(rot_z(gamma) @ rot_y(beta) @ rot_x(alpha))
        return matrices


def wrong_nothing_returned(n, rng):
    """a return is missing"""
    alpha, beta, gamma = 2 * np.pi * rng.random(n), np.pi * rng.random(n), 2 * np.pi * rng.random(n)
    R = rot_z(gamma) @ rot_y(beta) @ rot_x(alpha)


def wrong_method(n, rng):
    """AttributeError"""
    alpha, beta, gamma = 2 * np.pi * rng.rand(n), np.pi * rng.rand(n), 2 * np.pi * rng.rand(n)
    return rot_z(gamma) @ rot_y(beta) @ rot_x(alpha)


def wrong_degrees_in_radians(n, rng):
    """beta"""
    a, b, c = rng.integers(0, 360, n), rng.integers(0, 180, n), rng.integers(0, 360, n)
    return rot_z(c.astype(float)) @ rot_y(b.astype(float)) @ rot_x(a.astype(float))


def right_gamma_up_to_pi(n, rng):
    """Of the same distribution: with beta beyond pi/2 both others grow by pi."""
    a, b, c = 2 * np.pi * rng.random(n), np.pi * rng.random(n), np.pi * rng.random(n)
    return rot_z(c) @ rot_y(b) @ rot_x(a)


def right_alpha_up_to_pi(n, rng):
    """Of the same distribution: with beta beyond pi/2 both others grow by pi."""
    a, b, c = np.pi * rng.random(n), np.pi * rng.random(n), 2 * np.pi * rng.random(n)
    return rot_z(c) @ rot_y(b) @ rot_x(a)


def wrong_beta_and_alpha_swapped(n, rng):
    """beta is drawn from the full circle"""
    a, b, c = np.pi * rng.random(n), 2 * np.pi * rng.random(n), 2 * np.pi * rng.random(n)
    return rot_z(c) @ rot_y(b) @ rot_x(a)


def wrong_n_times_three_numbers_reshaped(n, rng):
    """ValueError"""
    a, b, c = rng.random((n, 3)) * [2 * np.pi, np.pi, 2 * np.pi]
    return rot_z(c) @ rot_y(b) @ rot_x(a)


def wrong_y_first(n, rng):
    """unnamed"""
    a, b, c = rng.random((3, n)) * [[2 * np.pi], [np.pi], [2 * np.pi]]
    return rot_z(c) @ rot_x(a) @ rot_y(b)


def right_beta_up_to_half_pi(n, rng):
    """Of the same distribution too."""
    a, b, c = 2 * np.pi * rng.random(n), np.pi / 2 * rng.random(n), 2 * np.pi * rng.random(n)
    return rot_z(c) @ rot_y(b) @ rot_x(a)
