"""What students write for test_log_so3(log_so3)."""

import numpy as np

from course_lib.rotations import exp_so3, rot_x


def _agrees(log_so3, w, atol=1e-6):
    R = exp_so3(np.asarray(w))
    answer = np.asarray(log_so3(R))
    return (
        np.allclose(exp_so3(answer), R, rtol=0, atol=atol)
        and np.linalg.norm(answer) <= np.pi + atol
    )


def right_exponential_of_the_answer(log_so3):
    axes = np.array([[1, 0, 0], [0, 0.6, -0.8], [-0.48, 0.6, 0.64], [-1, 0, 0]])
    for n in axes:
        for a in (0, 2e-5, 1e-3, 0.5, 2, 3.14, np.pi - 2e-4, np.pi):
            if not _agrees(log_so3, a * n):
                return False
    return True


def right_known_answers(log_so3):
    axes = np.array([[2, -1, 2], [3, 0, 0], [0, 0, -3]]) / 3
    near = lambda x, y: np.abs(np.asarray(x) - y).max() < 1e-6
    ordinary = all(
        near(log_so3(exp_so3(a * axes[0])), a * axes[0])
        for a in (0.0, 5e-6, 0.005, 1.0, 2.5, 3.13, 3.1415)
    )
    half = [(log_so3(2 * np.outer(n, n) - np.eye(3)), np.pi * n) for n in axes]
    return bool(ordinary and all(near(answer, w) or near(answer, -w) for answer, w in half))


def right_one_and_zero(log_so3):
    return int(right_exponential_of_the_answer(log_so3))


def wrong_length_not_asked(log_so3):
    """unnamed"""
    for a in (0, 1e-3, 1.0, 2.0, 3.0, np.pi):
        R = exp_so3(a * np.array([-0.48, 0.6, 0.64]))
        if not np.allclose(exp_so3(np.asarray(log_so3(R))), R):
            return False
    return True


def wrong_only_the_last_digits_may_differ(log_so3):
    """your test rejects an answer whose error the task allows"""
    angles = (0, 2e-5, 1e-3, 0.5, 2, 3.14, np.pi - 2e-4, np.pi)
    n = np.array([-0.48, 0.6, 0.64])
    return all(_agrees(log_so3, a * n, atol=1e-8) for a in angles)


def wrong_no_angle_close_to_the_special_ones(log_so3):
    """unnamed"""
    axes = np.array([[1, 0, 0], [0, 0.6, -0.8], [-0.48, 0.6, 0.64], [-1, 0, 0]])
    return all(_agrees(log_so3, a * n) for a in (0, 1e-3, 0.5, 2, 3.14, np.pi) for n in axes)


def wrong_strict_length(log_so3):
    """longer than pi by rounding only"""
    half = log_so3(exp_so3(np.pi * np.array([-0.48, 0.6, 0.64])))
    return right_exponential_of_the_answer(log_so3) and np.linalg.norm(half) <= np.pi


def wrong_vectors_longer_than_pi(log_so3):
    """your test rejects everything"""
    w = np.random.default_rng(0).normal(size=(200, 3))
    return all(np.allclose(log_so3(exp_so3(each)), each) for each in w)


def wrong_one_sign_at_half_turns(log_so3):
    """only one of the two signs at 180 degrees"""
    half = exp_so3(np.pi * np.array([-0.48, 0.6, 0.64]))
    own = np.pi * np.array([-0.48, 0.6, 0.64])
    one_sign = np.array_equal(np.sign(log_so3(half)), np.sign(own))
    return right_exponential_of_the_answer(log_so3) and one_sign
