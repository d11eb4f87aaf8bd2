"""What students write for plan_pick(q0, T_grasp)."""

import numpy as np

from course_lib import ik, rigid
from course_lib.arms import panda
from course_lib.lessons.panda_dh_ik import pick

arm = panda()
EASED = np.linspace(0, 1, 41)[:, None] ** 2 * (3 - 2 * np.linspace(0, 1, 41)[:, None])


def reach(T_gripper, q):
    goal = rigid.inverse(pick.BASE) @ T_gripper @ rigid.inverse(pick.IN_FLANGE)
    return ik.solve(arm, goal, np.random.default_rng(0), q0=q).q


def lifted(T, height):
    return rigid.transform(T[:3, :3], T[:3, 3] + [0, 0, height])


def timed(joints, start=0.0, slower=1.0):
    leg = np.column_stack([np.linspace(0, 1, len(joints)), joints])
    speed, acceleration = (share.max() for share in pick.shares(leg))
    leg[:, 0] = start + slower * max(speed, acceleration**0.5) * leg[:, 0]
    return leg


def planned(q0, T_grasp, high=0.15, n=41, ease=lambda u: 3 * u**2 - 2 * u**3, slower=1.0):
    s = ease(np.linspace(0, 1, n))
    down = [reach(lifted(T_grasp, high), q0)]
    for part in s[1:]:
        down.append(reach(lifted(T_grasp, high * (1 - part)), down[-1]))
    over = timed(np.array([q0 + part * (down[0] - q0) for part in s]), slower=slower)
    return np.vstack([over, timed(np.array(down), over[-1, 0], slower)[1:]])


def right_as_in_the_notebook(q0, T_grasp):
    return planned(q0, T_grasp)


def right_by_a_quintic_from_higher_and_slower_as_lists(q0, T_grasp):
    return planned(q0, T_grasp, 0.12, 61, lambda u: 10 * u**3 - 15 * u**4 + 6 * u**5, 1.2).tolist()


def right_all_in_the_time_of_the_hardest_joint(q0, T_grasp):
    """One clock for both legs: its step is the smallest that the bounds allow."""
    x = planned(q0, T_grasp)
    dq = np.diff(np.vstack([x[:1], x, x[-1:]])[:, 1:], axis=0)
    dt = max(
        (np.abs(dq) / pick.MAX_SPEEDS).max(),
        np.sqrt((np.abs(np.diff(dq, axis=0)) / pick.MAX_ACCELERATIONS).max()),
    )
    x[:, 0] = dt * np.arange(len(x))
    return x


def wrong_times_missing(q0, T_grasp):
    """the times are missing"""
    return planned(q0, T_grasp)[:, 1:]


def wrong_slow(q0, T_grasp):
    """the plan is slower than necessary"""
    return planned(q0, T_grasp, slower=20)


def wrong_down_in_joint_space(q0, T_grasp):
    """the arm comes too near to something"""
    above, grasp = planned(q0, T_grasp)[[40, 80], 1:]
    return np.vstack([planned(q0, T_grasp)[:41], timed(above + EASED * (grasp - above), 3.0)])


def wrong_rows_too_far_apart(q0, T_grasp):
    """two rows are too far apart in time"""
    return np.column_stack([0.3 * np.arange(17), planned(q0, T_grasp)[::5, 1:]])


def wrong_one_second_for_each_leg(q0, T_grasp):
    """a leg takes less time than its speeds need"""
    x = planned(q0, T_grasp)
    x[:, 0] = np.linspace(0, 2, len(x))
    return x


def wrong_each_solution_from_the_start(q0, T_grasp):
    """the joint angles jump between two rows"""
    s = EASED[:, 0]
    down = np.array([reach(lifted(T_grasp, 0.15 * (1 - part)), q0) for part in s])
    over = timed(q0 + EASED * (down[0] - q0))
    return np.vstack([over, timed(down, over[-1, 0])[1:]])


def wrong_without_a_short_first_leg(q0, T_grasp):
    """the plan does not begin at time 0 and q0"""
    x = planned(q0, T_grasp)
    if np.allclose(q0, x[40, 1:], rtol=0, atol=0.05):
        x = x[40:] - x[40, 0] * np.eye(8)[0]
    return x
