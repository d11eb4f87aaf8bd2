"""What students write for find_signs(table, q, poses)."""

import itertools

import numpy as np

from course_lib.arms import DHRow, SerialArm


def fk(table, angles, convention="standard"):
    return SerialArm.from_dh([DHRow(*row) for row in table], convention).fk(angles)


def right_by_the_sum_of_squares(table, q, poses):
    patterns = list(itertools.product([1, -1], repeat=len(table)))
    return patterns[int(np.argmin([((fk(table, s * q) - poses) ** 2).sum() for s in patterns]))]


def right_all_patterns_at_once(table, q, poses):
    patterns = np.array(list(itertools.product([1.0, -1.0], repeat=len(table))))
    return patterns[np.abs(fk(table, patterns[:, None] * q) - poses).max((1, 2, 3)).argmin()]


def right_by_counting_in_binary(table, q, poses):
    n, best = len(table), (np.inf, None)
    for k in range(2**n):
        signs = np.array([-1 if k >> i & 1 else 1 for i in range(n)])
        best = min(best, (np.linalg.norm(fk(table, signs * q) - poses), list(signs)))
    return best[1]


def wrong_one_joint_keeps_its_sign(table, q, poses):
    """the answers to some inputs only are wrong"""
    return [1] if len(table) == 1 else right_by_the_sum_of_squares(table, q, poses)
