"""What students write for random_rotations(n, rng)."""

import numpy as np

from course_lib.rotations import rot_y, rot_z


def right_arvo(n, rng):
    x1, x2, x3 = rng.random((3, n))
    phi, z = 2 * np.pi * x2, x3
    V = np.stack([np.cos(phi) * np.sqrt(z), np.sin(phi) * np.sqrt(z), np.sqrt(1 - z)], axis=1)
    H = np.eye(3) - 2 * V[:, :, None] * V[:, None, :]
    return -H @ rot_z(2 * np.pi * x1)


def right_qr_of_normal_numbers(n, rng):
    Q, upper = np.linalg.qr(rng.standard_normal((n, 3, 3)))
    Q = Q * np.sign(np.einsum("nii->ni", upper))[:, None, :]
    Q[:, :, 0] *= np.linalg.det(Q)[:, None]
    return Q


def right_euler_angles_with_the_right_density(n, rng):
    first, last = rng.uniform(-np.pi, np.pi, (2, n))
    return rot_z(last) @ rot_y(np.arccos(rng.uniform(-1, 1, n))) @ rot_z(first)


def wrong_nearest_to_even_entries(n, rng):
    """rotation angles between 0 and 30 degrees come too often"""
    U, _, Vt = np.linalg.svd(rng.random((n, 3, 3)))
    U[:, :, -1] *= np.linalg.det(U @ Vt)[:, None]
    return U @ Vt


def wrong_first_is_the_identity(n, rng):
    """a draw is the same for every seed"""
    R = right_qr_of_normal_numbers(n, rng)
    R[0] = np.eye(3)
    return R


def wrong_poles_from_a_generator_of_its_own(n, rng):
    """some of the numbers do not come from rng"""
    x2, x3 = np.random.default_rng(1).random((2, n))
    phi, z = 2 * np.pi * x2, x3
    V = np.stack([np.cos(phi) * np.sqrt(z), np.sin(phi) * np.sqrt(z), np.sqrt(1 - z)], axis=1)
    return (2 * V[:, :, None] * V[:, None, :] - np.eye(3)) @ rot_z(2 * np.pi * rng.random(n))


def wrong_angles_from_a_generator_of_its_own(n, rng):
    """some of the numbers do not come from rng"""
    phi, z = 2 * np.pi * rng.random(n), rng.random(n)
    V = np.stack([np.cos(phi) * np.sqrt(z), np.sin(phi) * np.sqrt(z), np.sqrt(1 - z)], axis=1)
    own = np.random.default_rng(1).random(n)
    return (2 * V[:, :, None] * V[:, None, :] - np.eye(3)) @ rot_z(2 * np.pi * own)


def wrong_one_angle_from_numpys_global_generator(n, rng):
    """the numbers do not come from rng"""
    theta, phi = 2 * np.pi * rng.random(n), 2 * np.pi * np.random.random(n)
    z = rng.random(n)
    v = np.stack([np.cos(phi) * np.sqrt(z), np.sin(phi) * np.sqrt(z), np.sqrt(1 - z)], -1)
    return (2 * v[:, :, None] * v[:, None, :] - np.eye(3)) @ rot_z(theta)
