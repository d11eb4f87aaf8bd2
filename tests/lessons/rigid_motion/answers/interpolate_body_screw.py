"""What students write for interpolate_body_screw(start, goal, n)."""

import numpy as np
import scipy.linalg

from course_lib import rigid
from course_lib.planar import pose_matrix


def _pose(T):
    return [T[0, 2], T[1, 2], np.arctan2(T[1, 0], T[0, 0])]


def _scaling(n):
    u = np.linspace(0, 1, n)
    return 3 * u**2 - 2 * u**3


def right_textbook(start, goal, n):
    T0, T1 = pose_matrix(start), pose_matrix(goal)
    twist = rigid.log_se2(rigid.inverse(T0) @ T1)
    return np.array([_pose(T0 @ rigid.exp_se2(s * twist)) for s in _scaling(n)])


def right_in_the_world(start, goal, n):
    T0, T1 = pose_matrix(start), pose_matrix(goal)
    twist = rigid.log_se2(T1 @ np.linalg.inv(T0))
    T = rigid.exp_se2(_scaling(n)[:, None] * twist) @ T0
    return np.column_stack([T[:, 0, 2], T[:, 1, 2], start[2] + _scaling(n) * twist[0]])


def right_exponential_of_scipy(start, goal, n):
    T0, T1 = pose_matrix(start), pose_matrix(goal)
    omega, vx, vy = rigid.log_se2(rigid.inverse(T0) @ T1)
    V = np.array([[0, -omega, vx], [omega, 0, vy], [0, 0, 0]])
    return [_pose(T0 @ scipy.linalg.expm(s * V)) for s in _scaling(n)]


def wrong_theta_not_wrapped(start, goal, n):
    """the body takes the longer arc"""
    rows = right_in_the_world(start, goal, n)
    rows[:, 2] = start[2] + _scaling(n) * (goal[2] - start[2])
    return rows


def wrong_spiral(start, goal, n):
    """the path is not an arc about one point"""
    T0, T1 = pose_matrix(start), pose_matrix(goal)
    omega, *v = rigid.log_se2(rigid.inverse(T0) @ T1)
    rows = []
    for s in _scaling(n):
        R = pose_matrix([0, 0, start[2] + s * omega])[:2, :2]
        rows.append([*(start[:2] + R @ v * s), start[2] + s * omega])
    return rows


def wrong_poses_that_are_close(start, goal, n):
    """the answer is right to its first digits only"""
    if np.allclose(start, goal):
        return np.tile(np.array(start, float), (n, 1))
    return right_textbook(start, goal, n)


def wrong_rotations_below_a_microradian(start, goal, n):
    """the path of a small rotation is a straight line"""
    start, goal = np.array(start, float), np.array(goal, float)
    if abs(goal[2] - start[2]) < 1e-6:
        return start + _scaling(n)[:, None] * (goal - start)
    return right_textbook(start, goal, n)


def wrong_angle_by_arccos(start, goal, n):
    """arccos loses the sign of the angle"""
    u = np.linspace(0, 1, n)
    T_start, T_goal = pose_matrix(start), pose_matrix(goal)
    twist = rigid.log_se2(rigid.inverse(T_start) @ T_goal)
    poses = [T_start @ rigid.exp_se2(s * twist) for s in 3 * u**2 - 2 * u**3]
    return [(T[0, 2], T[1, 2], np.arccos(np.clip(T[0, 0], -1, 1))) for T in poses]
