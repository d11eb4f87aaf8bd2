"""What students write for random_quaternions(n, rng)."""

import math

import numpy as np

from course_lib import rotations as rot


def right_shoemake(n, rng):
    s, x1, x2 = rng.random((3, n))
    near, far = np.sqrt(1 - s), np.sqrt(s)
    one, two = 2 * np.pi * x1, 2 * np.pi * x2
    return np.stack([np.cos(two) * far, np.sin(one) * near, np.cos(one) * near, np.sin(two) * far], axis=1)


def right_loop(n, rng):
    drawn = []
    for _ in range(n):
        s, x1, x2 = rng.random(3)
        one, two = 2 * math.pi * x1, 2 * math.pi * x2
        near, far = math.sqrt(1 - s), math.sqrt(s)
        drawn.append([math.sin(one) * near, math.cos(one) * near, math.sin(two) * far, math.cos(two) * far])
    return drawn


def right_normal_numbers(n, rng):
    q = rng.normal(size=(n, 4))
    return -q / np.linalg.norm(q, axis=1, keepdims=True)


def right_one_half_of_the_sphere(n, rng):
    q = rng.standard_normal((n, 4))
    q /= np.sqrt(np.einsum("ij,ij->i", q, q))[:, None]
    q[q[:, 0] < 0] *= -1
    return q


def right_rejected_outside_the_ball(n, rng):
    drawn = np.empty((0, 4))
    while len(drawn) < n:
        q = rng.uniform(-1, 1, (4 * n, 4))
        length = np.linalg.norm(q, axis=1)
        drawn = np.vstack([drawn, (q / length[:, None])[length <= 1]])
    return drawn[:n]


def wrong_roots_forgotten(n, rng):
    """the roots of s and 1 - s are missing"""
    s, x1, x2 = rng.random((3, n))
    one, two = 2 * np.pi * x1, 2 * np.pi * x2
    return np.stack([np.cos(two) * s, np.sin(one) * (1 - s), np.cos(one) * (1 - s), np.sin(two) * s], axis=1)


def wrong_one_root_forgotten(n, rng):
    """the roots of s and 1 - s are missing"""
    s, x1, x2 = rng.random((3, n))
    near = np.sqrt(1 - s)
    one, two = 2 * np.pi * x1, 2 * np.pi * x2
    return np.stack([np.cos(two) * s, np.sin(one) * near, np.cos(one) * near, np.sin(two) * s], axis=1)


def wrong_sine_and_cosine_of_an_even_angle(n, rng):
    """sine and cosine of a uniform angle stand for the roots of s and 1 - s"""
    x0, x1, x2 = 2 * np.pi * rng.random((3, n))
    return np.stack(
        [np.cos(x2) * np.sin(x0), np.sin(x1) * np.cos(x0), np.cos(x1) * np.cos(x0), np.sin(x2) * np.sin(x0)], 1
    )


def wrong_one_angle_for_both(n, rng):
    """one angle serves for both pairs"""
    s, x = rng.random((2, n))
    near, far, turn = np.sqrt(1 - s), np.sqrt(s), 2 * np.pi * x
    return np.stack([np.cos(turn) * far, np.sin(turn) * near, np.cos(turn) * near, np.sin(turn) * far], axis=1)


def wrong_one_draw_for_root_and_angle(n, rng):
    """the same draw serves"""
    s, x = rng.random((2, n))
    near, far, one, two = np.sqrt(1 - s), np.sqrt(s), 2 * np.pi * s, 2 * np.pi * x
    return np.stack([np.cos(two) * far, np.sin(one) * near, np.cos(one) * near, np.sin(two) * far], axis=1)


def wrong_half_turns(n, rng):
    """an angle does not cover the full circle"""
    s, x1, x2 = rng.random((3, n))
    near, far, one, two = np.sqrt(1 - s), np.sqrt(s), np.pi * x1, np.pi * x2
    return np.stack([np.cos(two) * far, np.sin(one) * near, np.cos(one) * near, np.sin(two) * far], axis=1)


def wrong_positive_entries(n, rng):
    """no entry is ever negative"""
    q = rng.random((n, 4))
    return q / np.linalg.norm(q, axis=1, keepdims=True)


def wrong_cube(n, rng):
    """four numbers from [-1, 1] are normalised"""
    q = rng.uniform(-1, 1, (n, 4))
    return q / np.linalg.norm(q, axis=1, keepdims=True)


def wrong_not_normalised(n, rng):
    """the quaternions are not divided by their lengths"""
    return rng.normal(size=(n, 4))


def wrong_normalised_over_all(n, rng):
    """divided by one number"""
    q = rng.normal(size=(n, 4))
    return q / np.linalg.norm(q)


def wrong_euler_branch(n, rng):
    """Euler angles are drawn uniformly"""
    a, b, c = rng.random((3, n)) * [[np.pi], [np.pi / 2], [np.pi]]
    w, x, y, z = np.cos(b) * np.cos(a), np.cos(b) * np.sin(a), np.sin(b) * np.cos(a), -np.sin(b) * np.sin(a)
    cos, sin = np.cos(c), np.sin(c)
    return np.stack([cos * w - sin * z, cos * x - sin * y, cos * y + sin * x, cos * z + sin * w], axis=1)


def wrong_axis_and_angle(n, rng):
    """axis and angle are drawn uniformly"""
    axis, angle = rng.normal(size=(n, 3)), 2 * np.pi * rng.random((n, 1))
    axis /= np.linalg.norm(axis, axis=1, keepdims=True)
    return np.hstack([np.cos(angle / 2), np.sin(angle / 2) * axis])


def wrong_numpy_random(n, rng):
    """the numbers do not come from rng"""
    q = np.random.randn(n, 4)
    return q / np.linalg.norm(q, axis=1, keepdims=True)


def wrong_own_generator(n, rng):
    """a generator is made inside the function"""
    q = np.random.default_rng(7).normal(size=(n, 4))
    return q / np.linalg.norm(q, axis=1, keepdims=True)


def wrong_one_draw_repeated(n, rng):
    """one draw is repeated"""
    q = rng.normal(size=4)
    return np.tile(q / np.linalg.norm(q), (n, 1))


def wrong_matrices_as_published(n, rng):
    """another form"""
    alpha, beta, gamma = 2 * np.pi * rng.random(n), np.pi * rng.random(n), 2 * np.pi * rng.random(n)
    return rot.rot_z(gamma) @ rot.rot_y(beta) @ rot.rot_x(alpha)


def wrong_batch_last(n, rng):
    """another form"""
    q = rng.normal(size=(4, n))
    return q / np.linalg.norm(q, axis=0)


def wrong_single_one(n, rng):
    """another form"""
    q = rng.normal(size=4)
    return q / np.linalg.norm(q)


def wrong_yield(n, rng):
    """unnamed"""
    for _ in range(n):
        q = rng.normal(size=4)
        yield q / np.linalg.norm(q)


def wrong_the_librarys(n, rng):
    """course_lib.rotations.random_quaternions is called"""
    return rot.random_quaternions(n, rng)


def wrong_all_positive(n, rng):
    """no entry is ever negative"""
    q = np.abs(rng.normal(size=(n, 4)))
    return q / np.linalg.norm(q, axis=1, keepdims=True)


def wrong_angle_up_to_pi(n, rng):
    """an angle does not cover the full circle"""
    v = rng.normal(size=(n, 3))
    v /= np.linalg.norm(v, axis=1, keepdims=True)
    a = np.pi * rng.random((n, 1))
    return np.hstack([np.cos(a / 2), np.sin(a / 2) * v])


def wrong_divided_by_the_sum(n, rng):
    """the quaternions are divided by the sums of their entries"""
    q = rng.random((n, 4))
    return q / q.sum(axis=1, keepdims=True)


def wrong_same_s_for_both_roots(n, rng):
    """the quaternions are not divided by their lengths"""
    s, a, b = rng.random((3, n))
    a, b = 2 * np.pi * a, 2 * np.pi * b
    return np.stack(
        [np.cos(b) * np.sqrt(s), np.sin(a) * np.sqrt(s), np.cos(a) * np.sqrt(s), np.sin(b) * np.sqrt(s)], -1
    )


def wrong_angles_in_turns(n, rng):
    """no entry is ever negative"""
    s, a, b = rng.random((3, n))
    return np.stack(
        [np.cos(b) * np.sqrt(s), np.sin(a) * np.sqrt(1 - s), np.cos(a) * np.sqrt(1 - s), np.sin(b) * np.sqrt(s)], -1
    )


def wrong_half_the_angle_forgotten(n, rng):
    """unnamed"""
    v = rng.normal(size=(n, 3))
    v /= np.linalg.norm(v, axis=1, keepdims=True)
    a = np.arccos(rng.uniform(-1, 1, (n, 1)))
    return np.hstack([np.cos(a), np.sin(a) * v])
