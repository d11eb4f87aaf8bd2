"""What students write for bounded_step(J, v, bound, eps)."""

import numpy as np
from scipy.optimize import lsq_linear


def stacked(J, v, eps):
    n = J.shape[1]
    return np.vstack([J, np.sqrt(eps) * np.eye(n)]), np.append(v, np.zeros(n))


def right_by_lsq_linear(J, v, bound, eps):
    return lsq_linear(*stacked(J, v, eps), bounds=(-bound, bound), tol=1e-12).x


def right_by_projected_gradients(J, v, bound, eps):
    H = J.T @ J + eps * np.eye(J.shape[1])
    x, rate = np.zeros(J.shape[1]), 1 / np.linalg.norm(H, 2)
    for _ in range(4000):
        x = np.clip(x - rate * (H @ x - J.T @ v), -bound, bound)
    return x


def right_by_coordinates(J, v, bound, eps):
    H, g = J.T @ J + eps * np.eye(J.shape[1]), J.T @ v
    x = [0.0] * len(g)
    for _ in range(2000):
        for i in range(len(g)):
            x[i] = np.clip((g[i] - H[i] @ x + H[i, i] * x[i]) / H[i, i], -bound, bound)
    return x


def wrong_unbounded(J, v, bound, eps):
    """the bounds are ignored"""
    return J.T @ np.linalg.solve(J @ J.T + eps * np.eye(len(J)), v)


def wrong_clipped(J, v, bound, eps):
    """clipped afterwards"""
    return np.clip(wrong_unbounded(J, v, bound, eps), -bound, bound)


def wrong_scaled(J, v, bound, eps):
    """scaled down afterwards"""
    x = wrong_unbounded(J, v, bound, eps)
    return x / max(1, np.abs(x).max() / bound)


def wrong_eps_as_it_is(J, v, bound, eps):
    """eps stands for its square root"""
    n = J.shape[1]
    return lsq_linear(np.vstack([J, eps * np.eye(n)]), np.append(v, np.zeros(n)), bounds=(-bound, bound)).x


def wrong_result_object(J, v, bound, eps):
    """another form"""
    return lsq_linear(*stacked(J, v, eps), bounds=(-bound, bound))
