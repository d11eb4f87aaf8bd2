"""What students write for random_rotations(n, rng)."""

import math
import random

import numpy as np
import scipy.stats
from scipy.spatial.transform import Rotation

from course_lib.rotations import exp_so3, hat, rot_x, rot_y, rot_z
from course_lib.rotations import random_rotations as ready_made


def right_arvo(n, rng):
    x1, x2, x3 = rng.random((3, n))
    phi, z = 2 * np.pi * x2, x3
    V = np.stack([np.cos(phi) * np.sqrt(z), np.sin(phi) * np.sqrt(z), np.sqrt(1 - z)], axis=1)
    H = np.eye(3) - 2 * V[:, :, None] * V[:, None, :]
    return -H @ rot_z(2 * np.pi * x1)


def right_arvo_in_a_loop(n, rng):
    matrices = []
    for _ in range(n):
        theta, phi, z = rng.uniform(0, [2 * math.pi, 2 * math.pi, 1])
        c, s, root = math.cos(theta), math.sin(theta), math.sqrt(z)
        V = np.array([[math.cos(phi) * root, math.sin(phi) * root, math.sqrt(1 - z)]])
        matrices.append((2 * V.T * V - np.eye(3)) @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1]]))
    return matrices


def right_qr_of_normal_numbers(n, rng):
    Q, upper = np.linalg.qr(rng.standard_normal((n, 3, 3)))
    Q = Q * np.sign(np.einsum("nii->ni", upper))[:, None, :]
    Q[:, :, 0] *= np.linalg.det(Q)[:, None]
    return Q


def right_normal_quaternions(n, rng):
    w, x, y, z = rng.normal(size=(4, n))
    l = w * w + x * x + y * y + z * z
    rows = [
        [1 - 2 * (y * y + z * z) / l, 2 * (x * y - w * z) / l, 2 * (x * z + w * y) / l],
        [2 * (x * y + w * z) / l, 1 - 2 * (x * x + z * z) / l, 2 * (y * z - w * x) / l],
        [2 * (x * z - w * y) / l, 2 * (y * z + w * x) / l, 1 - 2 * (x * x + y * y) / l],
    ]
    return np.moveaxis(np.array(rows), -1, 0)


def right_euler_angles_with_the_right_density(n, rng):
    first, last = rng.uniform(-np.pi, np.pi, (2, n))
    return rot_z(last) @ rot_y(np.arccos(rng.uniform(-1, 1, n))) @ rot_z(first)


def wrong_euler(n, rng):
    """Euler angles are drawn uniformly"""
    alpha, beta, gamma = 2 * np.pi * rng.random(n), np.pi * rng.random(n), 2 * np.pi * rng.random(n)
    return rot_z(gamma) @ rot_y(beta) @ rot_x(alpha)


def wrong_euler_over_full_turns(n, rng):
    """Euler angles are drawn uniformly"""
    alpha, beta, gamma = 2 * np.pi * rng.random((3, n))
    return rot_x(gamma) @ rot_y(beta) @ rot_z(alpha)


def wrong_reflection(n, rng):
    """a reflection"""
    x1, x2, z = rng.random((3, n))
    phi = 2 * np.pi * x2
    V = np.stack([np.cos(phi) * np.sqrt(z), np.sin(phi) * np.sqrt(z), np.sqrt(1 - z)], axis=1)
    return (np.eye(3) - 2 * V[:, :, None] * V[:, None, :]) @ rot_z(2 * np.pi * x1)


def wrong_root_forgotten(n, rng):
    """the root over z is missing"""
    x1, x2, z = rng.random((3, n))
    phi = 2 * np.pi * x2
    V = np.stack([np.cos(phi) * z, np.sin(phi) * z, np.sqrt(1 - z)], axis=1)
    return (2 * V[:, :, None] * V[:, None, :] - np.eye(3)) @ rot_z(2 * np.pi * x1)


def wrong_root_forgotten_but_unit(n, rng):
    """the root over z is missing"""
    x1, x2, z = rng.random((3, n))
    phi = 2 * np.pi * x2
    V = np.stack([np.cos(phi) * z, np.sin(phi) * z, np.sqrt(1 - z**2)], axis=1)
    return (2 * V[:, :, None] * V[:, None, :] - np.eye(3)) @ rot_z(2 * np.pi * x1)


def wrong_no_turn_about_z(n, rng):
    """the rotation about z is missing: every draw rotates by 180 degrees"""
    x2, z = rng.random((2, n))
    phi = 2 * np.pi * x2
    V = np.stack([np.cos(phi) * np.sqrt(z), np.sin(phi) * np.sqrt(z), np.sqrt(1 - z)], axis=1)
    return 2 * V[:, :, None] * V[:, None, :] - np.eye(3)


def wrong_turn_only(n, rng):
    """e_z always has the same image"""
    return rot_z(2 * np.pi * rng.random(n))


def wrong_same_draw_for_both_turns(n, rng):
    """the same draw serves"""
    x, z = rng.random((2, n))
    phi = theta = 2 * np.pi * x
    V = np.stack([np.cos(phi) * np.sqrt(z), np.sin(phi) * np.sqrt(z), np.sqrt(1 - z)], axis=1)
    return (2 * V[:, :, None] * V[:, None, :] - np.eye(3)) @ rot_z(theta)


def wrong_same_draw_for_height_and_turn(n, rng):
    """the same draw serves"""
    x, y = rng.random((2, n))
    phi, z = 2 * np.pi * y, x
    V = np.stack([np.cos(phi) * np.sqrt(z), np.sin(phi) * np.sqrt(z), np.sqrt(1 - z)], axis=1)
    return (2 * V[:, :, None] * V[:, None, :] - np.eye(3)) @ rot_z(2 * np.pi * x)


def wrong_same_draw_for_height_and_direction(n, rng):
    """the same draw serves"""
    x, y = rng.random((2, n))
    phi, z = 2 * np.pi * x, x
    V = np.stack([np.cos(phi) * np.sqrt(z), np.sin(phi) * np.sqrt(z), np.sqrt(1 - z)], axis=1)
    return (2 * V[:, :, None] * V[:, None, :] - np.eye(3)) @ rot_z(2 * np.pi * y)


def wrong_two_pi_forgotten(n, rng):
    """an angle does not cover the full circle"""
    theta, phi, z = rng.random((3, n))
    V = np.stack([np.cos(phi) * np.sqrt(z), np.sin(phi) * np.sqrt(z), np.sqrt(1 - z)], axis=1)
    return (2 * V[:, :, None] * V[:, None, :] - np.eye(3)) @ rot_z(theta)


def wrong_half_turn_about_z(n, rng):
    """an angle does not cover the full circle"""
    x1, x2, z = rng.random((3, n))
    phi = 2 * np.pi * x2
    V = np.stack([np.cos(phi) * np.sqrt(z), np.sin(phi) * np.sqrt(z), np.sqrt(1 - z)], axis=1)
    return (2 * V[:, :, None] * V[:, None, :] - np.eye(3)) @ rot_z(np.pi * x1)


def wrong_axis_and_angle(n, rng):
    """axis and angle are drawn uniformly"""
    axis = rng.normal(size=(n, 3))
    N = hat(axis / np.linalg.norm(axis, axis=1, keepdims=True))
    angle = np.pi * rng.random((n, 1, 1))
    return np.eye(3) + np.sin(angle) * N + (1 - np.cos(angle)) * N @ N


def wrong_axis_and_full_turn(n, rng):
    """axis and angle are drawn uniformly"""
    axis = rng.normal(size=(n, 3))
    N = hat(axis / np.linalg.norm(axis, axis=1, keepdims=True))
    angle = 2 * np.pi * rng.random((n, 1, 1))
    return np.eye(3) + np.sin(angle) * N + (1 - np.cos(angle)) * N @ N


def wrong_nearest_to_even_entries(n, rng):
    """unnamed"""
    U, _, Vt = np.linalg.svd(rng.random((n, 3, 3)))
    U[:, :, -1] *= np.linalg.det(U @ Vt)[:, None]
    return U @ Vt


def wrong_no_rotations(n, rng):
    """not orthogonal"""
    return rng.uniform(-1, 1, (n, 3, 3))


def wrong_numpy_random(n, rng):
    """the numbers do not come from rng"""
    x1, x2, z = np.random.rand(3, n)
    phi = 2 * np.pi * x2
    V = np.stack([np.cos(phi) * np.sqrt(z), np.sin(phi) * np.sqrt(z), np.sqrt(1 - z)], axis=1)
    return (2 * V[:, :, None] * V[:, None, :] - np.eye(3)) @ rot_z(2 * np.pi * x1)


def wrong_random_module(n, rng):
    """the numbers do not come from rng"""
    z, phi, turn = (np.array([random.random() for _ in range(n)]) * scale for scale in (1, 2 * np.pi, 2 * np.pi))
    V = np.stack([np.cos(phi) * np.sqrt(z), np.sin(phi) * np.sqrt(z), np.sqrt(1 - z)], axis=1)
    return (2 * V[:, :, None] * V[:, None, :] - np.eye(3)) @ rot_z(turn)


def wrong_own_generator(n, rng):
    """a generator is made inside the function"""
    x1, x2, z = np.random.default_rng(42).random((3, n))
    phi = 2 * np.pi * x2
    V = np.stack([np.cos(phi) * np.sqrt(z), np.sin(phi) * np.sqrt(z), np.sqrt(1 - z)], axis=1)
    return (2 * V[:, :, None] * V[:, None, :] - np.eye(3)) @ rot_z(2 * np.pi * x1)


def wrong_one_draw_repeated(n, rng):
    """one draw is repeated"""
    x1, x2, z = rng.random(3)
    phi = 2 * np.pi * x2
    V = np.array([np.cos(phi) * np.sqrt(z), np.sin(phi) * np.sqrt(z), np.sqrt(1 - z)])
    return [(2 * np.outer(V, V) - np.eye(3)) @ rot_z(2 * np.pi * x1)] * n


def wrong_batch_last(n, rng):
    """another form"""
    return np.moveaxis(right_arvo(n, rng), 0, -1)


def wrong_generator_of_the_caller(n, rng):
    """AttributeError"""
    x1, x2, z = rng.rand(3, n)
    return rot_z(2 * np.pi * x1)


def wrong_scipys(n, rng):
    """scipy.spatial.transform.Rotation is called"""
    return Rotation.random(n, rng).as_matrix()


def wrong_scipys_statistics(n, rng):
    """scipy.stats.special_ortho_group is called"""
    return scipy.stats.special_ortho_group.rvs(3, size=n, random_state=rng).reshape(n, 3, 3)


def wrong_the_librarys(n, rng):
    """course_lib.rotations.random_rotations is called"""
    return ready_made(n, rng)


def wrong_qr_without_signs(n, rng):
    """QR factors"""
    Q, _ = np.linalg.qr(rng.normal(size=(n, 3, 3)))
    Q[:, :, 0] *= np.linalg.det(Q)[:, None]
    return Q


def wrong_normal_rotation_vectors(n, rng):
    """unnamed"""
    return exp_so3(rng.normal(size=(n, 3)))


def wrong_vectors_in_the_ball(n, rng):
    """rotation vectors are drawn uniformly from the ball of radius pi"""
    v = rng.normal(size=(n, 3))
    v /= np.linalg.norm(v, axis=1, keepdims=True)
    return exp_so3(np.pi * np.cbrt(rng.random((n, 1))) * v)


def wrong_polar_angle_uniform(n, rng):
    """Euler angles are drawn uniformly"""
    t, phi, theta = rng.random((3, n)) * [[np.pi / 2], [2 * np.pi], [2 * np.pi]]
    V = np.stack([np.cos(phi) * np.sin(t), np.sin(phi) * np.sin(t), np.cos(t)], -1)
    return (2 * V[:, :, None] * V[:, None, :] - np.eye(3)) @ rot_z(theta)


def wrong_theta_up_to_pi(n, rng):
    """full circle"""
    theta, phi, z = rng.random((3, n)) * [[np.pi], [2 * np.pi], [1]]
    V = np.stack([np.cos(phi) * np.sqrt(z), np.sin(phi) * np.sqrt(z), np.sqrt(1 - z)], -1)
    return (2 * V[:, :, None] * V[:, None, :] - np.eye(3)) @ rot_z(theta)


def wrong_product_of_many_naive_ones(n, rng):
    """one draw is repeated"""
    a, b, c = rng.random(3) * [2 * np.pi, np.pi, 2 * np.pi]
    return np.array([rot_z(c) @ rot_y(b) @ rot_x(a)] * n)
