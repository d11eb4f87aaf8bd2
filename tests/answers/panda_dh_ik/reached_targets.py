"""What students write for reached_targets(targets, q0, eps, steps)."""

import numpy as np

from course_lib import ik
from course_lib.arms import panda as make_panda

panda = make_panda()
low, high = panda.limits.T


def errors(q, targets):
    return np.roll(ik.pose_error(panda.fk(q), targets), 3, axis=-1)


def jacobians(q):
    return np.roll(panda.geometric_jacobian(q), 3, axis=-2)


def right_all_at_once(targets, q0, eps, steps):
    q = np.tile(q0, (len(targets), 1))
    for _ in range(steps):
        J = jacobians(q)
        J_T = np.swapaxes(J, -1, -2)
        x = np.linalg.solve(J @ J_T + eps * np.eye(6), errors(q, targets)[..., None])
        q = np.clip(q + (J_T @ x)[..., 0], low, high)
    e = errors(q, targets)
    return (np.linalg.norm(e[:, :3], axis=1) < 1e-3) & (np.linalg.norm(e[:, 3:], axis=1) < 1e-3)


def right_one_after_the_other(targets, q0, eps, steps):
    found = []
    for T in targets:
        q = np.array(q0, float)
        for _ in range(steps):
            e = errors(q, T)
            if np.linalg.norm(e) < 1e-6:
                break
            J = jacobians(q)
            q = np.clip(q + np.linalg.solve(J.T @ J + eps * np.eye(7), J.T @ e), low, high)
        e = errors(q, T)
        found.append(max(np.linalg.norm(e[:3]), np.linalg.norm(e[3:])) <= 1e-3)
    return found


def right_in_the_other_order(targets, q0, eps, steps):
    q = q0 + np.zeros((len(targets), 7))
    for _ in range(steps):
        J = panda.geometric_jacobian(q)
        A = np.einsum("nij,nkj->nik", J, J) + eps * np.eye(6)
        x = np.linalg.solve(A, ik.pose_error(panda.fk(q), targets)[..., None])[..., 0]
        q = np.minimum(np.maximum(q + np.einsum("nij,ni->nj", J, x), low), high)
    e = ik.pose_error(panda.fk(q), targets)
    return (np.linalg.norm(e.reshape(-1, 2, 3), axis=2) < 1e-3).all(1).astype(int)


def descended(targets, q0, eps, steps, clip=True, sign=1):
    q = np.tile(q0, (len(targets), 1))
    for _ in range(steps):
        J = jacobians(q)
        J_T = np.swapaxes(J, -1, -2)
        x = np.linalg.solve(J @ J_T + eps * np.eye(6), errors(q, targets)[..., None])
        q = q + sign * (J_T @ x)[..., 0]
        q = np.clip(q, low, high) if clip else q
    return q


def wrong_limits_ignored(targets, q0, eps, steps):
    """the limits are ignored"""
    e = errors(descended(targets, q0, eps, steps, clip=False), targets)
    return (np.linalg.norm(e[:, :3], axis=1) < 1e-3) & (np.linalg.norm(e[:, 3:], axis=1) < 1e-3)


def wrong_transposed_as_one_matrix(targets, q0, eps, steps):
    """ValueError"""
    J = jacobians(np.tile(q0, (len(targets), 1)))
    return np.linalg.solve(J @ J.T + eps * np.eye(6), np.ones(6))


def wrong_share(targets, q0, eps, steps):
    """one number is returned"""
    return right_all_at_once(targets, q0, eps, steps).mean()


def wrong_distances(targets, q0, eps, steps):
    """errors or counts are returned"""
    return np.linalg.norm(errors(descended(targets, q0, eps, steps), targets), axis=1)


def wrong_sign(targets, q0, eps, steps):
    """no target counts as reached"""
    e = errors(descended(targets, q0, eps, steps, sign=-1), targets)
    return np.linalg.norm(e, axis=1) < 1e-3


def wrong_position_only(targets, q0, eps, steps):
    """only the position is tested"""
    e = errors(descended(targets, q0, eps, steps), targets)
    return np.linalg.norm(e[:, :3], axis=1) < 1e-3


def wrong_one_step(targets, q0, eps, steps):
    """no target counts as reached"""
    e = errors(descended(targets, q0, eps, 1), targets)
    return np.linalg.norm(e, axis=1) < 1e-3


def wrong_joint_angles(targets, q0, eps, steps):
    """another form"""
    return descended(targets, q0, eps, steps)
