"""What students write for step_limit(J, eps), whose cell holds broken code."""

import numpy as np


def right_largest(J, eps):
    s = np.linalg.svd(J, compute_uv=False)
    return 2 * (1 + eps / s[0] ** 2)


def right_by_norm(J, eps):
    return 2 + 2 * eps / np.linalg.norm(J, 2) ** 2


def right_strictest_of_all(J, eps):
    s = np.linalg.svd(J, compute_uv=False)
    return np.min(2 * (s**2 + eps) / s**2)


def right_by_eigenvalues(J, eps):
    return [2 * (1 + eps / np.linalg.eigvalsh(J @ J.T).max())]


def wrong_second(J, eps):
    """another singular value than the largest"""
    return 2 * (1 + eps / np.linalg.svd(J, compute_uv=False)[1] ** 2)


def wrong_mean(J, eps):
    """another singular value than the largest"""
    return 2 * (1 + eps / np.linalg.svd(J, compute_uv=False).mean() ** 2)


def wrong_not_squared(J, eps):
    """s is not squared"""
    return 2 * (1 + eps / np.linalg.svd(J, compute_uv=False)[0])


def wrong_gradient_descent(J, eps):
    """the limit without damping"""
    return 2 / np.linalg.norm(J, 2) ** 2


def wrong_all_limits(J, eps):
    """another form"""
    return 2 * (1 + eps / np.linalg.svd(J, compute_uv=False) ** 2)


def wrong_half(J, eps):
    """half of what it should be"""
    return 1 + eps / np.linalg.norm(J, 2) ** 2


def wrong_frobenius(J, eps):
    """another singular value than the largest"""
    return 2 * (1 + eps / np.linalg.norm(J) ** 2)


def wrong_smallest_not_squared(J, eps):
    """s is not squared"""
    singular_values = np.linalg.svd(J, compute_uv=False)
    return 2 * (1 + eps / singular_values[-1])


def wrong_eigenvalue_squared(J, eps):
    """s is squared twice"""
    largest = np.linalg.eigvalsh(J @ J.T).max()
    return 2 * (1 + eps / largest**2)
