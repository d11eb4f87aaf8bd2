"""What students write for newton_ik(screws, M, T_target, q0)."""

import numpy as np
from scipy.optimize import least_squares

from course_lib import ik
from course_lib.arms import ur5e
from course_lib.rigid import adjoint, exp_se3, inverse, log_se3
from course_lib.rotations import log_so3


def _arm(screws, M, q):
    """The pose and the space Jacobian."""
    T, J = np.eye(4), []
    for S, angle in zip(screws, q):
        J.append(adjoint(T) @ S)
        T = T @ exp_se3(S * angle)
    return T @ M, np.array(J).T


def search(
    screws,
    M,
    T_target,
    q0,
    tol=1e-6,
    steps=50,
    transposed=False,
    last=False,
    growth=np.inf,
    limit=np.inf,
):
    q, first = np.array(q0, float), None
    for _ in range(steps):
        T, J = _arm(screws, M, q)
        V, J = log_se3(inverse(T) @ T_target), adjoint(inverse(T)) @ J
        if np.linalg.norm(V[:3]) <= tol and np.linalg.norm(V[3:]) <= tol:
            return q
        first = np.linalg.norm(V) if first is None else first
        if np.linalg.norm(V) > growth * first:
            break
        q = q + (0.5 * J.T if transposed else np.linalg.pinv(J)) @ V
        q = np.clip(q, -limit, limit)
    return q if last else np.full(len(q), np.nan)


def right_by_least_squares_as_a_column(screws, M, T_target, q0):
    q = q0 + 0.0
    for _ in range(51):
        T, J = _arm(screws, M, q)
        V = log_se3(inverse(T) @ T_target)
        if max(abs(V)) < 5e-7:
            return q[:, None]
        q += np.linalg.lstsq(adjoint(inverse(T)) @ J, V, rcond=None)[0]
    return q0 * np.nan


def right_seen_from_the_base(screws, M, T_target, q0):
    q = list(q0)
    for _ in range(50):
        T, J = _arm(screws, M, q)
        V = log_se3(T_target @ inverse(T))
        if np.linalg.norm(V) < 1e-9:
            return q
        q = list(q + np.linalg.pinv(J) @ V)
    return [float("nan")] * len(q)


def right_damped_with_another_error(screws, M, T_target, q0):
    """The position's difference in place of v, and a damping that vanishes with the error."""
    q = q0.copy()
    for _ in range(50):
        T, J = _arm(screws, M, q)
        D = inverse(T) @ T_target
        V, J = np.append(log_so3(D[:3, :3]), D[:3, 3]), adjoint(inverse(T)) @ J
        if np.linalg.norm(V) < 1e-7:
            return q
        q = q + J.T @ np.linalg.solve(J @ J.T + 1e-3 * (V @ V) * np.eye(6), V)
    return np.full_like(q, np.nan)


def wrong_transposed(screws, M, T_target, q0):
    """the steps do not converge to a target close by"""
    return search(screws, M, T_target, q0, transposed=True)


def wrong_stopped_early(screws, M, T_target, q0):
    """the answer is right to its first digits only"""
    return search(screws, M, T_target, q0, tol=1e-3)


def wrong_last_angles(screws, M, T_target, q0):
    """the last angles are returned"""
    return search(screws, M, T_target, q0, last=True)


def wrong_gives_up_where_the_error_grows(screws, M, T_target, q0):
    """the iteration gives up although the target can be reached"""
    return search(screws, M, T_target, q0, growth=5)


def wrong_within_the_limits(screws, M, T_target, q0):
    """the iteration gives up although the target can be reached"""
    limit = np.radians([170, 120, 170, 120, 170, 120, 175]) if len(q0) == 7 else np.inf
    return search(screws, M, T_target, q0, limit=limit)


def wrong_scipys(screws, M, T_target, q0):
    """scipy.optimize.least_squares is called"""
    return least_squares(lambda q: (_arm(screws, M, q)[0] - T_target)[:3].ravel(), q0, xtol=1e-12).x


def wrong_library(screws, M, T_target, q0):
    """course_lib.ik.solve is called"""
    return ik.solve(ur5e(), T_target, np.random.default_rng(0), q0=q0).q
