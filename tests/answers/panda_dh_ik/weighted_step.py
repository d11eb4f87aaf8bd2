"""What students write for weighted_step(q, J, e, eps, weights)."""

import numpy as np


def step(J, e, eps):
    return J.T @ np.linalg.solve(J @ J.T + eps * np.eye(len(J)), e)


def right_by_scaled_rows(q, J, e, eps, weights):
    roots = np.sqrt(weights)
    return q + step(roots[:, None] * J, roots * e, eps)


def right_by_normal_equations(q, J, e, eps, weights):
    W = np.diag(weights)
    return q + np.linalg.inv(J.T @ W @ J + eps * np.eye(len(q))) @ J.T @ W @ e


def right_by_stacked_least_squares(q, J, e, eps, weights):
    roots = np.sqrt(weights)
    A = np.vstack([roots[:, None] * J, np.sqrt(eps) * np.eye(len(q))])
    b = np.concatenate([roots * e, np.zeros(len(q))])
    return list(np.array(q) + np.linalg.lstsq(A, b, rcond=None)[0])


def wrong_no_roots(q, J, e, eps, weights):
    """the weights come in as their squares"""
    return q + step(weights[:, None] * J, weights * e, eps)


def wrong_only_the_error(q, J, e, eps, weights):
    """only one of J and e is weighted"""
    return q + step(J, np.sqrt(weights) * e, eps)


def wrong_only_the_jacobian(q, J, e, eps, weights):
    """only one of J and e is weighted"""
    return q + step(np.sqrt(weights)[:, None] * J, e, eps)


def wrong_error_times_weights(q, J, e, eps, weights):
    """only one of J and e is weighted"""
    return q + step(J, weights * e, eps)


def wrong_weights_unused(q, J, e, eps, weights):
    """the weights are not used"""
    return q + step(J, e, eps)


def wrong_divided(q, J, e, eps, weights):
    """the rows are divided by the weights"""
    roots = np.sqrt(weights)
    return q + step(J / roots[:, None], e / roots, eps)


def wrong_divided_where_it_can_be(q, J, e, eps, weights):
    """divided by the weights"""
    roots = np.sqrt(np.where(np.array(weights) > 0, weights, np.inf))
    return q + step(J / roots[:, None], e / roots, eps)


def wrong_normalized(q, J, e, eps, weights):
    """the weights are scaled"""
    roots = np.sqrt(weights / np.sum(weights))
    return q + step(roots[:, None] * J, roots * e, eps)


def wrong_weight_in_the_middle_only(q, J, e, eps, weights):
    """only one of J and e is weighted"""
    W = np.diag(weights)
    return q + J.T @ np.linalg.solve(J @ J.T + eps * np.eye(len(J)), W @ W @ e)


def wrong_step_only(q, J, e, eps, weights):
    """only the step is returned"""
    return right_by_scaled_rows(0 * q, J, e, eps, weights)


def wrong_away(q, J, e, eps, weights):
    """the step leads away"""
    return 2 * q - right_by_scaled_rows(q, J, e, eps, weights)


def wrong_columns(q, J, e, eps, weights):
    """ValueError"""
    return q + step(J * np.sqrt(weights), np.sqrt(weights) * e, eps)


def wrong_damping_weighted_too(q, J, e, eps, weights):
    """the weights are not used"""
    W = np.diag(weights)
    return q + J.T @ W @ np.linalg.solve(J @ J.T @ W + eps * W, e)
