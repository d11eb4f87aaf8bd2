"""What students write for six_axis_ik(T)."""

import numpy as np

from course_lib import subproblems
from course_lib.lessons.subproblems_damped_ik.exercises.six_axis_arm import (
    HOME,
    SWAP,
    WRIST,
    arm_solutions,
    wrist_angles,
)
from course_lib.rigid import inverse
from course_lib.rotations import rot_x, rot_y, rot_z


def right_by_the_motion_from_home(T):
    motion, found = T @ inverse(HOME), []
    for a, b, c in arm_solutions((motion @ [*WRIST, 1])[:3]):
        W = (rot_z(a) @ rot_y(b + c)).T @ motion[:3, :3]
        found += [(a, b, c, *wrist) for wrist in wrist_angles(W)]
    return np.reshape(found, (-1, 6))


def right_by_the_flange(T, axis=2):
    found = []
    for q1, q2, q3 in arm_solutions(T[:3, 3] - 0.072 * T[:3, axis]):
        R = rot_y(-q3) @ rot_y(-q2) @ rot_z(-q1) @ T[:3, :3] @ rot_y(-np.pi / 2)
        for b1, b2, b3 in subproblems.euler_yxy(SWAP @ R @ SWAP).theta:
            found.append([q1, q2, q3, b1, b2, b3])
    return found


def right_without_the_exchange(T):
    found = []
    for q1, q2, q3 in arm_solutions(T[:3, 3] - 0.072 * T[:3, 2]):
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


def wrong_along_x(T):
    """the wrist center is at another point"""
    return right_by_the_flange(T, axis=0)


def wrong_elbows_that_are_nearly_the_same(T):
    """solutions are missing"""
    found = right_by_the_flange(T)
    merge = len(found) == 8 and abs(found[0][2] - found[4][2]) < 1e-3
    return found[:4] if merge else found


def wrong_one_wrist_where_its_axes_are_nearly_the_same(T):
    """solutions are missing"""
    found = right_by_the_flange(T)
    return [q for k, q in enumerate(found) if abs(np.sin(q[4])) > 1e-3 or k % 2 == 0]


def wrong_nothing_below_the_base(T):
    """the list is empty although the target is within reach"""
    center = T[:3, 3] - 0.072 * T[:3, 2]
    return right_by_the_flange(T) if center[2] > 0 else []
