"""What students write for six_axis_ik(T)."""

import numpy as np

from course_lib import subproblems
from course_lib.rigid import inverse, transform
from course_lib.rotations import exp_so3, rot_x, rot_y, rot_z

ex, ey, ez = np.eye(3)
SHOULDER, ELBOW, WRIST = np.array([0, 0, 0.29]), np.array([0, 0, 0.56]), np.array([0.302, 0, 0.63])
HOME = transform(rot_y(np.pi / 2), [0.374, 0, 0.63])
SWAP = np.array([[0, 1, 0], [1, 0, 0], [0, 0, -1]])


def euler_yxy(R):
    return subproblems.euler_yxy(R).theta


def arm_angles(center):
    bent = subproblems.subproblem3(ey, WRIST - ELBOW, SHOULDER - ELBOW, np.linalg.norm(center - SHOULDER))
    found = []
    for q3 in bent.theta if bent.exact else []:
        p = ELBOW - SHOULDER + exp_so3(q3 * ey) @ (WRIST - ELBOW)
        found += [(-back, q2, q3) for q2, back in subproblems.subproblem2(ey, ez, p, center - SHOULDER).theta]
    return found


def _solved(T, center, rest):
    return np.array([(*q, *b) for q in arm_angles(center) for b in euler_yxy(rest(*q))]).reshape(-1, 6)


def right_by_the_motion_from_home(T):
    motion = T @ inverse(HOME)
    center = (motion @ [*WRIST, 1])[:3]
    return _solved(T, center, lambda a, b, c: SWAP @ (rot_z(a) @ rot_y(b + c)).T @ motion[:3, :3] @ SWAP.T)


def right_by_the_flange(T):
    found = []
    for q1, q2, q3 in arm_angles(T[:3, 3] - 0.072 * T[:3, 2]):
        R = rot_y(-q3) @ rot_y(-q2) @ rot_z(-q1) @ T[:3, :3] @ rot_y(-np.pi / 2)
        for b1, b2, b3 in euler_yxy(SWAP @ R @ SWAP):
            found.append([q1, q2, q3, b1, b2, b3])
    return found


def right_without_the_exchange(T):
    found = []
    for q1, q2, q3 in arm_angles(T[:3, 3] - 0.072 * T[:3, 2]):
        W = (rot_z(q1) @ rot_y(q2 + q3)).T @ T[:3, :3] @ HOME[:3, :3].T
        for sign in (1, -1):
            q4 = np.arctan2(sign * W[1, 0], -sign * W[2, 0])
            q5 = np.arctan2(sign * np.hypot(W[1, 0], W[2, 0]), W[0, 0])
            rest = (rot_x(q4) @ rot_y(q5)).T @ W
            found.append((q1, q2, q3, q4, q5, np.arctan2(rest[2, 1], rest[1, 1])))
    return found


def wrong_four_only(T):
    """solutions are missing"""
    return right_by_the_flange(T)[::2]


def wrong_center(T):
    """the flange's position is taken for the wrist center"""
    R = T[:3, :3] @ HOME[:3, :3].T
    return _solved(T, T[:3, 3], lambda a, b, c: SWAP @ (rot_z(a) @ rot_y(b + c)).T @ R @ SWAP.T)


def wrong_flange_added(T):
    """the flange's length is subtracted along another direction"""
    R = T[:3, :3] @ HOME[:3, :3].T
    center = T[:3, 3] + 0.072 * T[:3, 2]
    return _solved(T, center, lambda a, b, c: SWAP @ (rot_z(a) @ rot_y(b + c)).T @ R @ SWAP.T)


def wrong_home_left_out(T):
    """the home orientation is left out"""
    center = T[:3, 3] - 0.072 * T[:3, 2]
    return _solved(T, center, lambda a, b, c: SWAP @ (rot_z(a) @ rot_y(b + c)).T @ T[:3, :3] @ SWAP.T)


def wrong_not_exchanged(T):
    """x and y are not exchanged"""
    R, center = T[:3, :3] @ HOME[:3, :3].T, T[:3, 3] - 0.072 * T[:3, 2]
    return _solved(T, center, lambda a, b, c: (rot_z(a) @ rot_y(b + c)).T @ R)


def wrong_elbow_left_out(T):
    """joint 3 is left out"""
    R, center = T[:3, :3] @ HOME[:3, :3].T, T[:3, 3] - 0.072 * T[:3, 2]
    return _solved(T, center, lambda a, b, c: SWAP @ (rot_z(a) @ rot_y(b)).T @ R @ SWAP.T)


def wrong_not_undone(T):
    """not undone"""
    R, center = T[:3, :3] @ HOME[:3, :3].T, T[:3, 3] - 0.072 * T[:3, 2]
    return _solved(T, center, lambda a, b, c: SWAP @ rot_z(a) @ rot_y(b + c) @ R @ SWAP.T)


def wrong_wrist_alone(T):
    """another form"""
    return [row[3:] for row in right_by_the_flange(T)] or [1.0, 2, 3]
