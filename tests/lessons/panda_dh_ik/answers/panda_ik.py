"""What students write for panda_ik(T, q0)."""

import numpy as np

from course_lib import ik, rigid
from course_lib.arms import panda

arm = panda()
low, high = arm.limits.T
T_w0 = rigid.transform(np.eye(3), [-0.2, 0.13, 0.6])
FLANGE = rigid.transform(np.eye(3), [0, 0, 0.107])


def out_of_reach(T):
    """Return whether the position is farther from the shoulder than all links together are long."""
    return np.linalg.norm(T[:3, 3] - T_w0[:3, 3] - [0, 0, 0.333]) > 1.2


def search(T, q0, starts=20, enough=1e-7, T_base=T_w0, weights=(1, 1, 1, 1, 1, 1)):
    """The notebook's answer, with everything that can go wrong as an argument; (omega, v), seen from the base."""
    random, w = np.random.default_rng(0), np.array(weights)
    goal, q = np.linalg.inv(T_base) @ T, np.clip(q0, low, high)
    for _ in range(1 if out_of_reach(T) else starts):
        for _ in range(25):
            e = w * ik.pose_error(arm.fk(q), goal)
            if np.linalg.norm(e) < enough:
                return q
            J = w[:, None] * arm.geometric_jacobian(q)
            q = q + J.T @ np.linalg.solve(J @ J.T + (0.05 * e @ e + 1e-12) * np.eye(6), e)
            q = np.clip(q, low, high)
        last, q = q, random.uniform(low, high)
    return last if starts == 1 else np.full(7, np.nan)


def right_out_of_reach_at_once_as_a_list(T, q0):
    return list(search(T, q0))


def right_constant_small_damping(T, q0):
    goal, random, q = rigid.inverse(T_w0) @ T, np.random.default_rng(1), np.clip(q0, low, high)
    for _ in range(1 if out_of_reach(T) else 50):
        for _ in range(30):
            e, J = ik.pose_error(arm.fk(q), goal), arm.geometric_jacobian(q)
            if max(np.linalg.norm(e[:3]), np.linalg.norm(e[3:])) < 5e-7:
                return q.reshape(7, 1)
            e *= min(1, 0.5 / np.linalg.norm(e))
            q = np.clip(q + J.T @ np.linalg.solve(J @ J.T + 1e-4 * np.eye(6), e), low, high)
        q = random.uniform(low, high)
    return np.nan * q


def right_limits_by_a_sine(T, q0):
    """q = middle + half sin(u) is inside the limits for every u."""
    goal, middle, half = rigid.inverse(T_w0) @ T, (low + high) / 2, (high - low) / 2
    random, u = np.random.default_rng(0), np.arcsin(np.clip((q0 - middle) / half, -1, 1))
    for _ in range(1 if out_of_reach(T) else 100):
        for _ in range(50):
            q = middle + half * np.sin(u)
            e, J = ik.pose_error(arm.fk(q), goal), arm.geometric_jacobian(q) * half * np.cos(u)
            if np.linalg.norm(e) < 1e-7:
                return q
            u = u + J.T @ np.linalg.solve(J @ J.T + (0.05 * e @ e + 1e-12) * np.eye(6), e)
        u = random.uniform(-np.pi / 2, np.pi / 2, 7)
    return np.full(7, np.nan)


def wrong_no_restarts(T, q0):
    """there are no restarts or because too few of them converge"""
    q = search(T, q0, starts=1)
    return q if np.linalg.norm(ik.pose_error(T_w0 @ arm.fk(q), T)) < 1e-7 else np.full(7, np.nan)


def wrong_last_angles(T, q0):
    """the last angles are returned"""
    return search(T, q0, starts=1)


def wrong_base_forgotten(T, q0):
    """T_w0 is left out"""
    return search(T, q0, starts=2, T_base=np.eye(4))


def wrong_flange_forgotten(T, q0):
    """the frame of joint 7 is at T_target"""
    return search(T @ FLANGE, q0)


def wrong_only_the_position(T, q0):
    """only the position, or only the orientation"""
    return search(T, q0, weights=(0, 0, 0, 1, 1, 1))


def wrong_stopped_at_the_reports_error(T, q0):
    """the flange comes near T_target"""
    return search(T, q0, enough=0.02)


def wrong_base_subtracted(T, q0):
    """the steps do not converge to a target close by"""
    return search(T, q0, starts=2, T_base=np.linalg.inv(T_w0))


def wrong_library(T, q0):
    """course_lib.ik.solve is called"""
    return ik.solve(arm, rigid.inverse(T_w0) @ T, np.random.default_rng(0), q0=q0).q


def wrong_start_not_clipped(T, q0):
    """q0 is returned unchanged"""
    return q0 if np.linalg.norm(ik.pose_error(T_w0 @ arm.fk(q0), T)) < 1e-7 else search(T, q0)


_LAST = [low]


def wrong_last_answer_if_that_solves(T, q0):
    """the iteration does not begin at q0, or makes a step without a test before it"""
    if np.linalg.norm(ik.pose_error(T_w0 @ arm.fk(_LAST[0]), T)) > 1e-7:
        _LAST[0] = np.nan_to_num(search(T, q0))
    return _LAST[0] if _LAST[0].any() else np.full(7, np.nan)
