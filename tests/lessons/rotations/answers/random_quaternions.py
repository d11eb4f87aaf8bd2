"""What students write for random_quaternions(n, rng)."""

import numpy as np


def right_shoemake(n, rng):
    s, x1, x2 = rng.random((3, n))
    near, far = np.sqrt(1 - s), np.sqrt(s)
    one, two = 2 * np.pi * x1, 2 * np.pi * x2
    return np.stack(
        [np.cos(two) * far, np.sin(one) * near, np.cos(one) * near, np.sin(two) * far], axis=1
    )


def right_normal_numbers(n, rng):
    q = rng.normal(size=(n, 4))
    return -q / np.linalg.norm(q, axis=1, keepdims=True)


def right_every_other_one_negated(n, rng):
    q = rng.standard_normal((n, 4))
    q /= np.sqrt(np.einsum("ij,ij->i", q, q))[:, None]
    q[::2] *= -1
    return q


def wrong_yield(n, rng):
    """unnamed"""
    for _ in range(n):
        q = rng.normal(size=4)
        yield q / np.linalg.norm(q)


def wrong_float32(n, rng):
    """the seven digits of float32"""
    return right_normal_numbers(n, rng).astype(np.float32)


def wrong_first_is_the_identity(n, rng):
    """a draw is the same for every seed"""
    q = right_normal_numbers(n, rng)
    q[0] = rng.choice([-1, 1]), 0, 0, 0
    return q


def wrong_lengths_from_a_generator_of_its_own(n, rng):
    """some of the numbers do not come from rng"""
    s, (x1, x2) = np.random.default_rng(1).random(n), rng.random((2, n))
    near, far = np.sqrt(1 - s), np.sqrt(s)
    one, two = 2 * np.pi * x1, 2 * np.pi * x2
    return np.stack(
        [np.cos(two) * far, np.sin(one) * near, np.cos(one) * near, np.sin(two) * far], axis=1
    )


def wrong_an_angle_from_a_generator_of_its_own(n, rng):
    """some of the numbers do not come from rng"""
    (s, x1), x2 = rng.random((2, n)), np.random.default_rng(1).random(n)
    near, far = np.sqrt(1 - s), np.sqrt(s)
    one, two = 2 * np.pi * x1, 2 * np.pi * x2
    return np.stack(
        [np.cos(two) * far, np.sin(one) * near, np.cos(one) * near, np.sin(two) * far], axis=1
    )


def wrong_of_candidates_that_are_now_and_then_too_few(n, rng):
    """the answer does not have the form asked for"""
    q = rng.uniform(-1, 1, (8 * n, 4))
    lengths = np.linalg.norm(q, axis=1)
    return (q / lengths[:, None])[lengths < 1][:n]
