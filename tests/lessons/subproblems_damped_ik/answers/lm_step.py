"""What students write for lm_step(q, target, alpha, eps)."""

import numpy as np

from course_lib.lessons.subproblems_damped_ik.exercises.planar_jacobian import jacobian, tip


def right_solved(q, target, alpha, eps):
    J = jacobian(q)
    return list(q - alpha * np.linalg.solve(J.T @ J + eps * np.eye(4), J.T @ (tip(q) - target)))


def right_smaller_matrix(q, target, alpha, eps):
    J = jacobian(q)
    e = (tip(q) - target)[:, None]
    return q[:, None] - alpha * J.T @ np.linalg.inv(J @ J.T + eps * np.eye(2)) @ e


def right_least_squares(q, target, alpha, eps):
    A = np.vstack([jacobian(q), np.sqrt(eps) * np.eye(4)])
    e = np.concatenate([tip(q) - target, np.zeros(4)])
    return q - alpha * np.linalg.lstsq(A, e, rcond=None)[0]


def wrong_singular(q, target, alpha, eps):
    """LinAlgError"""
    J = jacobian(np.zeros(4))
    return q - alpha * np.linalg.solve(J.T @ J, J.T @ (tip(q) - target))


def wrong_wrapped(q, target, alpha, eps):
    """the angles are wrapped"""
    return (right_least_squares(q, target, alpha, eps) + np.pi) % (2 * np.pi) - np.pi


def wrong_at_least_some_damping(q, target, alpha, eps):
    """the answers to some inputs only are wrong"""
    return right_solved(q, target, alpha, max(eps, 1e-6))


def wrong_that_stays_near_the_target(q, target, alpha, eps):
    """q is returned as it came"""
    is_near = np.linalg.norm(tip(q) - target) < 1e-6
    return q if is_near else right_solved(q, target, alpha, eps)
