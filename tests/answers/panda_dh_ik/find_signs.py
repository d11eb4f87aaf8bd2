"""What students write for find_signs(table, q, poses)."""

import itertools

import numpy as np

from course_lib.arms import DHRow, SerialArm


def dh_standard(a, alpha, d, theta):
    ca, sa, c, s = np.cos(alpha), np.sin(alpha), np.cos(theta), np.sin(theta)
    return np.array([[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]])


def end(table, angles):
    T = np.eye(4)
    for (a, alpha, d), theta in zip(table, angles):
        T = T @ dh_standard(a, alpha, d, theta)
    return T


def right_by_the_sum_of_squares(table, q, poses):
    patterns = list(itertools.product([1, -1], repeat=len(table)))
    cost = [sum(((end(table, s * a) - T) ** 2).sum() for a, T in zip(q, poses)) for s in patterns]
    return patterns[int(np.argmin(cost))]


def right_by_the_library_s_arm(table, q, poses):
    arm = SerialArm.from_dh([DHRow(*row) for row in table], "standard")
    patterns = np.array(list(itertools.product([1.0, -1.0], repeat=len(table))))
    gaps = np.abs(arm.fk(patterns[:, None] * q) - poses).max((1, 2, 3))
    return patterns[gaps.argmin()]


def right_by_counting_in_binary(table, q, poses):
    n, best = len(table), (np.inf, None)
    for k in range(2**n):
        signs = np.array([-1 if k >> i & 1 else 1 for i in range(n)])
        worst = max(np.linalg.norm(end(table, signs * a) - T) for a, T in zip(q, poses))
        best = min(best, (worst, list(signs)))
    return best[1]


def wrong_position_only(table, q, poses):
    """only positions are compared"""
    patterns = list(itertools.product([1, -1], repeat=len(table)))
    return min(
        patterns, key=lambda s: round(max(np.abs((end(table, s * a) - T)[:3, 3]).max() for a, T in zip(q, poses)), 9)
    )


def wrong_first_configuration(table, q, poses):
    """only the first configuration is compared"""
    patterns = list(itertools.product([1, -1], repeat=len(table)))
    return min(patterns, key=lambda s: round(np.abs(end(table, s * q[0]) - poses[0]).max(), 9))


def wrong_one_joint_at_a_time(table, q, poses):
    """one joint is decided after the other"""
    signs = np.ones(len(table))
    for i in range(len(table)):
        gaps = []
        for sign in (1, -1):
            signs[i] = sign
            gaps.append(max(np.abs(end(table, signs * a) - T).max() for a, T in zip(q, poses)))
        signs[i] = 1 if gaps[0] <= gaps[1] else -1
    return signs


def wrong_number_of_the_pattern(table, q, poses):
    """another form"""
    patterns = list(itertools.product([1, -1], repeat=len(table)))
    return int(np.argmin([max(np.abs(end(table, s * a) - T).max() for a, T in zip(q, poses)) for s in patterns]))


def wrong_truth_values(table, q, poses):
    """something other than signs"""
    return np.array(right_by_counting_in_binary(table, q, poses)) > 0


def wrong_zeros_and_ones(table, q, poses):
    """something other than signs"""
    patterns = list(itertools.product([0, 1], repeat=len(table)))
    return min(patterns, key=lambda s: max(np.abs(end(table, s * a) - T).max() for a, T in zip(q, poses)))


def wrong_worst(table, q, poses):
    """the worst pattern is chosen"""
    patterns = list(itertools.product([1, -1], repeat=len(table)))
    return max(patterns, key=lambda s: max(np.abs(end(table, s * a) - T).max() for a, T in zip(q, poses)))
