"""What students write for fit_sag(q, xy)."""

import numpy as np
from sklearn.linear_model import LinearRegression


def right_lstsq(q, xy):
    q1, both = q[:, 0], q.sum(axis=1)
    gap = (q[:, 0] + q[:, 1] / 2 - np.arctan2(xy[:, 1], xy[:, 0]) + np.pi) % (2 * np.pi) - np.pi
    return np.linalg.lstsq(np.column_stack([np.cos(q1), np.cos(both)]), gap)[0]


def right_by_rotating_back(q, xy):
    middle = q[:, 0] + q[:, 1] / 2
    c, s = np.cos(middle), np.sin(middle)
    gap = -np.arctan2(c * xy[:, 1] - s * xy[:, 0], c * xy[:, 0] + s * xy[:, 1])
    line = LinearRegression(fit_intercept=False).fit(np.cos(np.c_[q[:, 0], q[:, 0] + q[:, 1]]), gap)
    return line.coef_


def right_normal_equations_as_a_list(q, xy):
    A = np.cos(q @ np.array([[1, 1], [0, 1]]))
    gap = np.angle(np.exp(1j * (q @ [1, 0.5])) / (xy[:, 0] + 1j * xy[:, 1]))
    return np.linalg.solve(A.T @ A, A.T @ gap).tolist()


def wrong_the_mean(q, xy):
    """their fit is not that of the text"""
    gap = q[:, 0] + q[:, 1] / 2 - np.arctan2(xy[:, 1], xy[:, 0])
    return np.array([gap.mean(), gap.mean()])


def _terms_and_gaps(q, xy):
    A = np.cos(np.column_stack([q[:, 0], q[:, 0] + q[:, 1]]))
    return A, q[:, 0] + q[:, 1] / 2 - np.arctan2(xy[:, 1], xy[:, 0])


def wrong_wrapped_by_half_revolutions(q, xy):
    """delta, one of its two columns, or their fit is not that of the text"""
    A, gaps = _terms_and_gaps(q, xy)
    return np.linalg.lstsq(A, gaps - np.pi * np.round(gaps / np.pi))[0]


def wrong_large_gaps_left_out(q, xy):
    """delta, one of its two columns, or their fit is not that of the text"""
    A, gaps = _terms_and_gaps(q, xy)
    gaps = gaps - 2 * np.pi * np.round(gaps / (2 * np.pi))
    near = np.abs(gaps) < 0.8
    return np.linalg.lstsq(A[near], gaps[near])[0]


def wrong_small_coefficients_taken_for_0(q, xy):
    """delta, one of its two columns, or their fit is not that of the text"""
    answer = np.array(right_lstsq(q, xy))
    answer[np.abs(answer) < 1e-6] = 0
    return answer


def wrong_wrapped_on_one_side(q, xy):
    """a delta is off by a full revolution, or by several"""
    A, _ = _terms_and_gaps(q, xy)
    x, y = A.sum(axis=1), np.sin(q[:, 0]) + np.sin(q[:, 0] + q[:, 1])
    gap = np.arctan2(y, x) - np.arctan2(xy[:, 1], xy[:, 0])
    return np.linalg.lstsq(A, np.where(gap > np.pi, gap - 2 * np.pi, gap))[0]


def wrong_small_singular_value_cut(q, xy):
    """is not that of the text"""
    A, gap = _terms_and_gaps(q, xy)
    return np.linalg.lstsq(A, np.angle(np.exp(1j * gap)), rcond=0.05)[0]
