"""What students write for branch_by_sign(q), whose cell holds broken code."""

import numpy as np


def right_by_comparison(q):
    return (q[:, 1] < 0).astype(int)


def right_truth_values(q):
    return q[:, 1] < 0


def right_by_the_sign(q):
    return (1 - np.sign(q[:, 1])) // 2


def wrong_sign_bit(q):
    """the zero with a minus sign, -0.0, is in branch 1"""
    return np.signbit(q[:, 1])


def wrong_tolerance(q):
    """a small negative q2 counts as 0"""
    return (q[:, 1] < -1e-12).astype(int)


def right_one_by_one(q):
    return [0 if second >= 0 else 1 for _, second in q]


def wrong_sign_itself(q):
    """a sample does not have the label that its own q2 gives"""
    return np.sign(q[:, 1])


def wrong_cut_at_the_mean(q):
    """the answers to some inputs only are wrong"""
    return (q[:, 1] < q[:, 1].mean()).astype(int) if len(q) else np.zeros(0)


def wrong_type_of_the_first_column(q):
    """a small negative q2 counts as 0"""
    kind = int if np.array_equal(q[:, 0], np.rint(q[:, 0])) else float
    return q[:, 1].astype(kind) < 0
