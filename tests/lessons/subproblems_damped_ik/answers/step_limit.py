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
