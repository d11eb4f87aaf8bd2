"""What students write for reached_targets(targets, q0, eps, steps)."""

import numpy as np

from course_lib import ik
from course_lib.arms import panda as make_panda

panda = make_panda()
low, high = panda.limits.T


def descended(targets, q0, eps, steps):
    q = q0 + np.zeros((len(targets), 7))
    for _ in range(steps):
        J = panda.geometric_jacobian(q)
        J_T = np.swapaxes(J, -1, -2)
        x = np.linalg.solve(
            J @ J_T + eps * np.eye(6), ik.pose_error(panda.fk(q), targets)[..., None]
        )
        q = np.clip(q + (J_T @ x)[..., 0], low, high)
    return ik.pose_error(panda.fk(q), targets)


def right_all_at_once(targets, q0, eps, steps):
    e = descended(targets, q0, eps, steps)
    return (np.linalg.norm(e[:, :3], axis=1) < 1e-3) & (np.linalg.norm(e[:, 3:], axis=1) < 1e-3)


def right_as_numbers(targets, q0, eps, steps):
    e = descended(targets, q0, eps, steps)
    return (np.linalg.norm(e.reshape(-1, 2, 3), axis=2) <= 1e-3).all(1).astype(int)[:, None]


def right_one_after_the_other(targets, q0, eps, steps):
    found = []
    for T, start in zip(targets, q0 + np.zeros((len(targets), 7))):
        q = np.array(start)
        for _ in range(steps):
            e, J = ik.pose_error(panda.fk(q), T), panda.geometric_jacobian(q)
            if np.linalg.norm(e) < 1e-6:
                break
            q = np.clip(q + np.linalg.solve(J.T @ J + eps * np.eye(7), J.T @ e), low, high)
        e = ik.pose_error(panda.fk(q), T)
        found.append(max(np.linalg.norm(e[:3]), np.linalg.norm(e[3:])) <= 1e-3)
    return found


def wrong_transposed_as_one_matrix(targets, q0, eps, steps):
    """ValueError"""
    J = panda.geometric_jacobian(q0 + np.zeros((len(targets), 7)))
    return np.linalg.solve(J @ J.T + eps * np.eye(6), np.ones(6))


def wrong_share(targets, q0, eps, steps):
    """one number is returned"""
    return right_all_at_once(targets, q0, eps, steps).mean()


def wrong_distances(targets, q0, eps, steps):
    """something other than True or False"""
    return np.linalg.norm(descended(targets, q0, eps, steps), axis=1)


def wrong_last_step_not_clipped(targets, q0, eps, steps):
    """the answers to some inputs only are wrong"""
    q = q0 + np.zeros((len(targets), 7))
    for _ in range(steps):
        q = np.clip(q, low, high)
        J = panda.geometric_jacobian(q)
        A = J @ np.swapaxes(J, -1, -2) + eps * np.eye(6)
        x = np.linalg.solve(A, ik.pose_error(panda.fk(q), targets)[..., None])
        q = q + (np.swapaxes(J, -1, -2) @ x)[..., 0]
    e = ik.pose_error(panda.fk(q), targets).reshape(-1, 2, 3)
    return (np.linalg.norm(e, axis=2) < 1e-3).all(1)


def wrong_seven_starts_taken_for_one(targets, q0, eps, steps):
    """the answers to some inputs only are wrong"""
    start = q0.reshape(-1, 7)[0] if len(q0) == 7 else q0
    return right_all_at_once(targets, start, eps, steps)
