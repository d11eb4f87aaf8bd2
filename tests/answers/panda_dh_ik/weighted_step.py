"""What students write for weighted_step(q, J, e, eps, weights)."""

import numpy as np


def right_by_scaled_rows(q, J, e, eps, weights):
    r = np.sqrt(weights)
    A = r[:, None] * J
    return q + A.T @ np.linalg.solve(A @ A.T + eps * np.eye(len(J)), r * e)


def right_by_normal_equations(q, J, e, eps, weights):
    W = np.diag(weights)
    return (q + np.linalg.inv(J.T @ W @ J + eps * np.eye(len(q))) @ J.T @ W @ e)[:, None]


def right_by_stacked_least_squares(q, J, e, eps, weights):
    A = np.vstack([np.sqrt(weights)[:, None] * J, np.sqrt(eps) * np.eye(len(q))])
    b = np.concatenate([np.sqrt(weights) * e, np.zeros(len(q))])
    return list(np.array(q) + np.linalg.lstsq(A, b, rcond=None)[0])


def wrong_rounded_weights(q, J, e, eps, weights):
    """unnamed"""
    return right_by_scaled_rows(q, J, e, eps, np.round(weights))
