"""What students write for step_limit(J, eps), whose cell holds broken code."""

import numpy as np


def right_by_norm(J, eps):
    return 2 + 2 * eps / np.linalg.norm(J, 2) ** 2


def right_strictest_of_all(J, eps):
    s = np.linalg.svd(J, compute_uv=False)
    return np.array([np.min(2 * (s**2 + eps) / s**2)])


def right_by_eigenvalues(J, eps):
    return [2 * (1 + eps / np.linalg.eigvalsh(J @ J.T).max())]


def wrong_frobenius_norm(J, eps):
    """the singular values are combined"""
    return 2 * (1 + eps / np.linalg.norm(J) ** 2)


def wrong_eigenvalues_of_a_square_J(J, eps):
    """the answers to some inputs only are wrong"""
    if J.shape[0] != J.shape[1]:
        return right_by_norm(J, eps)
    largest = np.abs(np.linalg.eigvals(J)).max()
    return 2 * (1 + eps / largest**2)


def wrong_little_damping_left_out(J, eps):
    """the answers to some inputs only are wrong"""
    return right_by_norm(J, eps if eps > 1e-6 else 0.0)


def wrong_at_least_some_damping(J, eps):
    """the answers to some inputs only are wrong"""
    return right_by_norm(J, max(eps, 1e-8))


def wrong_few_power_iterations(J, eps):
    """the answer is right to its first digits only"""
    M, x = J @ J.T, np.arange(1.0, len(J) + 1)
    for _ in range(200):
        x = M @ x
        x /= np.linalg.norm(x)
    return 2 + 2 * eps / (x @ M @ x)
