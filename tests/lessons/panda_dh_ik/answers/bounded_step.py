"""What students write for bounded_step(J, v, bound, eps)."""

import numpy as np
from scipy.optimize import lsq_linear


def right_by_lsq_linear(J, v, bound, eps):
    A = np.vstack([J, np.sqrt(eps) * np.eye(J.shape[1])])
    return lsq_linear(A, np.append(v, np.zeros(J.shape[1])), bounds=(-bound, bound), tol=1e-12).x


def right_by_projected_gradients(J, v, bound, eps):
    H = J.T @ J + eps * np.eye(J.shape[1])
    x, rate = np.zeros(J.shape[1]), 1 / np.linalg.norm(H, 2)
    step = np.inf
    while step > 1e-10 * bound:
        before, x = x, np.clip(x - rate * (H @ x - J.T @ v), -bound, bound)
        step = np.abs(x - before).max()
    return x[:, None]


def right_by_coordinates(J, v, bound, eps):
    H, g = J.T @ J + eps * np.eye(J.shape[1]), J.T @ v
    x = [0.0] * len(g)
    step = np.inf
    while step > 1e-10 * bound:
        before = list(x)
        for i in range(len(g)):
            x[i] = min(max((g[i] - H[i] @ x + H[i, i] * x[i]) / H[i, i], -bound), bound)
        step = np.abs(np.subtract(x, before)).max()
    return x


def wrong_projected_gradients_of_too_few_steps(J, v, bound, eps):
    """other velocities within the bounds are better"""
    H = J.T @ J + eps * np.eye(J.shape[1])
    x, rate = np.zeros(J.shape[1]), 1 / np.linalg.norm(H, 2)
    for _ in range(1000):
        x = np.clip(x - rate * (H @ x - J.T @ v), -bound, bound)
    return x


def wrong_projected_gradients_of_many_steps(J, v, bound, eps):
    """other velocities within the bounds are better"""
    H = J.T @ J + eps * np.eye(J.shape[1])
    x, rate = np.zeros(J.shape[1]), 1 / np.linalg.norm(H, 2)
    for _ in range(5000):
        x = np.clip(x - rate * (H @ x - J.T @ v), -bound, bound)
    return x


def wrong_eps_raised(J, v, bound, eps):
    """other velocities within the bounds are better"""
    return right_by_lsq_linear(J, v, bound, max(eps, 1e-5))


def wrong_eps_raised_a_little(J, v, bound, eps):
    """other velocities within the bounds are better"""
    return right_by_lsq_linear(J, v, bound, max(eps, 1e-8))


def right_with_the_solver_s_own_tolerance(J, v, bound, eps):
    A = np.vstack([J, np.sqrt(eps) * np.eye(J.shape[1])])
    return lsq_linear(A, np.append(v, np.zeros(J.shape[1])), bounds=(-bound, bound)).x


def wrong_for_one_row(J, v, bound, eps):
    """other velocities within the bounds are better"""
    if len(J) == 1:
        return np.clip(np.linalg.pinv(J) @ v, -bound, bound)
    return right_by_lsq_linear(J, v, bound, eps)


def wrong_bound_raised(J, v, bound, eps):
    """a joint is faster than the argument `bound`"""
    return right_by_lsq_linear(J, v, max(bound, 0.01), eps)


def wrong_eps_lowered(J, v, bound, eps):
    """other velocities within the bounds are better"""
    return right_by_lsq_linear(J, v, bound, min(eps, 1.0))
