"""What students write for panda_ik(T, q0)."""

import numpy as np

from course_lib import ik, rigid, rotations
from course_lib.arms import panda

arm = panda()
limits = arm.limits
low, high = limits.T
T_w0 = rigid.transform(np.eye(3), [-0.2, 0.13, 0.6])


def panda_fk(q):
    return T_w0 @ arm.frames(q)


def geometric_jacobian(frames):
    z, o, p = frames[:-1, :3, 2], frames[:-1, :3, 3], frames[-1, :3, 3]
    return np.vstack([np.cross(z, p - o).T, z.T])


def pose_error(T, T_target):
    R = T_target[:3, :3] @ T[:3, :3].T
    return np.concatenate([T_target[:3, 3] - T[:3, 3], rotations.log_so3(R)])


def ik_step_dls(q, J, e, eps):
    return q + J.T @ np.linalg.solve(J @ J.T + eps * np.eye(6), e)


def out_of_reach(T):
    """Return whether the position is farther from the shoulder than all links together are long."""
    return np.linalg.norm(T[:3, 3] - T_w0[:3, 3] - [0, 0, 0.333]) > 1.2


def search(
    T,
    q0,
    starts=20,
    steps=25,
    enough=1e-7,
    clip=True,
    frames_of=panda_fk,
    error=pose_error,
    weights=(1, 1, 1, 1, 1, 1),
    jacobian=geometric_jacobian,
    quick=True,
):
    """The notebook's answer, with everything that can go wrong as an argument."""
    random = np.random.default_rng(0)
    q = np.clip(q0, low, high)
    for _ in range(1 if quick and out_of_reach(T) else starts):
        for _ in range(steps):
            frames = frames_of(q)
            e = weights * error(frames[-1], T)
            if np.linalg.norm(e) < enough:
                return q
            q = ik_step_dls(q, np.array(weights)[:, None] * jacobian(frames), e, 0.05 * e @ e + 1e-12)
            if clip:
                q = np.clip(q, low, high)
        last, q = q, random.uniform(low, high)
    return last if starts == 1 else np.full(7, np.nan)


def right_out_of_reach_at_once(T, q0):
    return np.full(7, np.nan) if out_of_reach(T) else search(T, q0)


def right_as_in_the_notebook(T, q0):
    random = np.random.default_rng(0)
    q = np.clip(q0, low, high)
    for _start in range(20):
        for _step in range(20):
            frames = panda_fk(q)
            e = pose_error(frames[-1], T)
            if np.linalg.norm(e) < 1e-7:
                return q
            q = np.clip(ik_step_dls(q, geometric_jacobian(frames), e, 0.05 * e @ e + 1e-12), low, high)
        q = random.uniform(low, high)
    return np.full(7, np.nan)


def right_as_lists_with_the_librarys_jacobian(T, q0):
    """Errors in the order (omega, v), as seen from the base; both stopping rules by themselves."""
    goal, random, q = rigid.inverse(T_w0) @ T, np.random.default_rng(5), list(q0)
    for _ in range(1 if out_of_reach(T) else 50):
        for _ in range(40):
            here = arm.fk(q)
            phi, e_p = rotations.log_so3(goal[:3, :3] @ here[:3, :3].T), goal[:3, 3] - here[:3, 3]
            if np.linalg.norm(e_p) < 1e-6 and np.linalg.norm(phi) < 1e-6:
                return [float(angle) for angle in q]
            e, J = np.r_[phi, e_p], arm.geometric_jacobian(q)
            dq = np.linalg.solve(J.T @ J + (0.01 * e @ e + 1e-9) * np.eye(7), J.T @ e)
            q = [min(max(q[j] + dq[j], low[j]), high[j]) for j in range(7)]
        q = [random.uniform(*limits[j]) for j in range(7)]
    return 7 * [float("nan")]


def right_constant_small_damping(T, q0):
    random, q = np.random.default_rng(1), np.array(q0)
    for _ in range(1 if out_of_reach(T) else 50):
        for _ in range(30):
            frames = panda_fk(q)
            e = pose_error(frames[-1], T)
            if max(np.linalg.norm(e[:3]), np.linalg.norm(e[3:])) < 5e-7:
                return q.reshape(7, 1)
            e *= min(1, 0.5 / np.linalg.norm(e))
            q = np.clip(ik_step_dls(q, geometric_jacobian(frames), e, 1e-4), low, high)
        q = random.uniform(low, high)
    return np.nan * q


def right_many_starts_at_once(T, q0):
    """All starts take their steps together; the first that arrives is the answer."""
    goal = rigid.inverse(T_w0) @ T
    Q = np.vstack([q0, np.random.default_rng(2).uniform(low, high, (99, 7))])
    for _ in range(30):
        here = arm.fk(Q)
        phi = rotations.log_so3(goal[:3, :3] @ np.swapaxes(here[:, :3, :3], 1, 2))
        e = np.concatenate([phi, goal[:3, 3] - here[:, :3, 3]], 1)
        size = np.sqrt((e**2).sum(1))
        if size.min() < 1e-7:
            return Q[np.argmin(size)]
        J = arm.geometric_jacobian(Q)
        M = J @ np.swapaxes(J, 1, 2) + (0.1 * size**2 + 1e-12)[:, None, None] * np.eye(6)
        Q = np.clip(Q + np.einsum("kij,ki->kj", J, np.linalg.solve(M, e[:, :, None])[:, :, 0]), low, high)
    return np.full((1, 7), np.nan)


def right_limits_by_a_sine(T, q0):
    """q = middle + half sin(u) is inside the limits for every u."""
    middle, half = (low + high) / 2, (high - low) / 2
    random, u = np.random.default_rng(0), np.arcsin(np.clip((q0 - middle) / half, -1, 1))
    for _ in range(1 if out_of_reach(T) else 100):
        for _ in range(50):
            q = middle + half * np.sin(u)
            frames = panda_fk(q)
            e = pose_error(frames[-1], T)
            if np.linalg.norm(e) < 1e-7:
                return q
            u = ik_step_dls(u, geometric_jacobian(frames) * half * np.cos(u), e, 0.05 * e @ e + 1e-12)
        u = random.uniform(-np.pi / 2, np.pi / 2, 7)
    return np.full(7, np.nan)


def wrong_no_restarts(T, q0):
    """no start leads to this target: there are no restarts, or too few of them converge"""
    q = search(T, q0, starts=1)
    return q if np.linalg.norm(pose_error(panda_fk(q)[-1], T)) < 1e-7 else np.full(7, np.nan)


def wrong_always_the_same_start(T, q0):
    """no start leads to this target: there are no restarts, or too few of them converge"""
    q = q0
    for _ in range(100):
        frames = panda_fk(q)
        e = pose_error(frames[-1], T)
        if np.linalg.norm(e) < 1e-7:
            return q
        q = np.clip(ik_step_dls(q, geometric_jacobian(frames), e, 0.05 * e @ e + 1e-12), low, high)
    return np.full(7, np.nan)


def wrong_last_angles(T, q0):
    """the last angles are returned"""
    return search(T, q0, starts=1)


def wrong_limits_ignored(T, q0):
    """the limits are ignored"""
    return search(T, q0, clip=False)


def wrong_clipped_at_the_end_only(T, q0):
    """the last angles are returned"""
    return np.clip(search(T, q0, clip=False), low, high)


def wrong_wrapped_at_the_end(T, q0):
    """the limits are ignored"""
    q = search(T, q0)
    return (q + np.pi / 2) % np.pi - np.pi / 2


def wrong_wrapped_to_whole_turns(T, q0):
    """multiples of 2 pi are added, and lead out of the limits"""
    return search(T, q0) % (2 * np.pi)


def wrong_base_forgotten(T, q0):
    """the base is forgotten"""
    return search(T, q0, frames_of=arm.frames, starts=2, quick=False)


def wrong_base_twice(T, q0):
    """NaN is returned although"""
    return search(T_w0 @ T, q0, frames_of=arm.frames, starts=2)


def wrong_flange_forgotten(T, q0):
    """the flange is forgotten"""
    return search(T, q0, frames_of=lambda q: panda_fk(q)[:7], jacobian=lambda f: geometric_jacobian(f[[*range(7), 6]]))


def wrong_only_the_position(T, q0):
    """only the position is brought to T_target, not the orientation"""
    return search(T, q0, weights=(1, 1, 1, 0, 0, 0))


def wrong_only_the_orientation(T, q0):
    """only the orientation is brought to T_target, not the position"""
    q = search(T, q0, weights=(0, 0, 0, 1, 1, 1))
    return np.full(7, np.nan) if out_of_reach(T) else q


def wrong_stopped_at_the_reports_error(T, q0):
    """the iteration stops too early, or the angles are rounded"""
    return search(T, q0, enough=0.02)


def wrong_stopped_at_a_ten_thousandth(T, q0):
    """the iteration stops too early, or the angles are rounded"""
    return search(T, q0, enough=1e-4)


def wrong_stopped_by_the_square(T, q0):
    """the iteration stops too early, or the angles are rounded"""
    return search(T, q0, enough=np.sqrt(1e-6))


def wrong_rounded(T, q0):
    """the iteration stops too early, or the angles are rounded"""
    return np.round(search(T, q0), 4)


def wrong_degrees(T, q0):
    """in degrees"""
    return np.rad2deg(search(T, q0))


def wrong_start_returned(T, q0):
    """q0 itself is returned"""
    return q0


def wrong_start_at_random(T, q0):
    """the iteration does not begin at q0"""
    return search(T, np.random.default_rng(5).uniform(low, high))


def wrong_start_in_the_middle(T, q0):
    """the iteration does not begin at q0"""
    return search(T, (low + high) / 2)


def wrong_nothing_found(T, q0):
    """NaN is returned although"""
    return np.full(7, np.nan)


def wrong_looks_at_the_error_too_late(T, q0):
    """NaN is returned although"""
    q = search(T, q0)
    return np.full(7, np.nan) if np.abs(q - q0).max() < 1e-9 and not out_of_reach(T) else q


def wrong_none_where_nothing_is_found(T, q0):
    """a return is missing"""
    q = search(T, q0)
    if np.isfinite(q).all():
        return q


def wrong_zeros_where_nothing_is_found(T, q0):
    """angles are returned for a target out of reach"""
    q = search(T, q0)
    return q if np.isfinite(q).all() else np.zeros(7)


def wrong_best_where_nothing_is_found(T, q0):
    """angles are returned for a target out of reach"""
    return search(T, q0, starts=1) if out_of_reach(T) else search(T, q0)


def wrong_joint_past_its_limit_reset_to_the_middle(T, q0):
    """no start leads to this target: there are no restarts, or too few of them converge"""
    q = np.array(q0)
    for _ in range(30):
        frames = panda_fk(q)
        e = pose_error(frames[-1], T)
        if np.linalg.norm(e) < 1e-7:
            return q
        q = ik_step_dls(q, geometric_jacobian(frames), e, 1e-3)
        q = np.where((q < low) | (q > high), (low + high) / 2, q)
    return np.full(7, np.nan)


def wrong_transpose_steps(T, q0):
    """the steps do not converge to a target close by"""
    q = np.array(q0)
    for _ in range(30):
        frames = panda_fk(q)
        e = pose_error(frames[-1], T)
        if np.linalg.norm(e) < 1e-7:
            return q
        q = np.clip(q + 0.3 * geometric_jacobian(frames).T @ e, low, high)
    return np.full(7, np.nan)


def wrong_order_of_the_error(T, q0):
    """the steps do not converge to a target close by"""
    return search(T, q0, starts=2, jacobian=lambda frames: np.roll(geometric_jacobian(frames), 3, axis=0))


def wrong_error_seen_from_the_end_effector(T, q0):
    """the steps do not converge to a target close by"""

    def error(A, B):
        return np.concatenate([B[:3, 3] - A[:3, 3], rotations.log_so3(A[:3, :3].T @ B[:3, :3])])

    return search(T, q0, starts=2, error=error)


def wrong_error_backwards(T, q0):
    """the steps do not converge to a target close by"""
    return search(T, q0, starts=2, error=lambda A, B: pose_error(B, A))


def wrong_orientation_transposed(T, q0):
    """the target's orientation is transposed"""
    return search(rigid.transform(T[:3, :3].T, T[:3, 3]), q0)


def wrong_position_in_millimetres(T, q0):
    """the iteration stops too early, or the angles are rounded"""
    return search(T, q0, weights=(0.001, 0.001, 0.001, 1, 1, 1), enough=1e-5)


def wrong_start_changed_in_place(T, q0):
    """q0 is changed in place"""
    q0[:] = search(T, q0)
    return q0


def wrong_pose_returned(T, q0):
    """a pose is returned"""
    q = search(T, q0)
    return panda_fk(q)[-1] if np.isfinite(q).all() else np.full((4, 4), np.nan)


def wrong_found_or_not_returned_as_well(T, q0):
    """another form"""
    q = search(T, q0)
    return q, bool(np.isfinite(q).all())


def wrong_library(T, q0):
    """course_lib.ik.solve is called"""
    return ik.solve(arm, rigid.inverse(T_w0) @ T, np.random.default_rng(0), q0=q0).q
