"""What students write for solve_lm(q0, target, alpha, eps, steps)."""

import numpy as np

from course_lib.checks.exercises.subproblems_damped_ik.lm_step import step as lm_step
from course_lib.checks.exercises.subproblems_damped_ik.planar_jacobian import jacobian, tip


def right_filled_in(q0, target, alpha, eps, steps):
    path = np.zeros((steps + 1, 4))
    path[0] = q0
    for k in range(1, steps + 1):
        path[k] = lm_step(path[k - 1], target, alpha, eps)
    return path


def right_recursive(q0, target, alpha, eps, steps):
    if steps == 0:
        return [list(q0)]
    return [list(q0), *right_recursive(lm_step(q0, target, alpha, eps), target, alpha, eps, steps - 1)]


def right_stacked(q0, target, alpha, eps, steps):
    path = np.reshape(q0, (1, 4))
    for _ in range(steps):
        q = path[-1]
        J = jacobian(q)
        taken = alpha * J.T @ np.linalg.inv(J @ J.T + eps * np.eye(2)) @ (tip(q) - target)
        path = np.concatenate([path, [q - taken]])
    return path


def wrong_tips(q0, target, alpha, eps, steps):
    """the positions of the tip"""
    return [tip(q) for q in right_filled_in(q0, target, alpha, eps, steps)]


def wrong_wrapped(q0, target, alpha, eps, steps):
    """the angles are wrapped"""
    path = [np.array(q0, float)]
    for _ in range(steps):
        path.append((lm_step(path[-1], target, alpha, eps) + np.pi) % (2 * np.pi) - np.pi)
    return np.array(path)


def wrong_every_second_step(q0, target, alpha, eps, steps):
    """unnamed"""
    return right_filled_in(q0, target, alpha, eps, 2 * steps)[::2]
