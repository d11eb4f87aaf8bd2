"""What students write for arm_angles(center)."""

import numpy as np

from course_lib import subproblems
from course_lib.lessons.subproblems_damped_ik.exercises.six_axis_arm import (
    ELBOW,
    SHOULDER,
    WRIST,
    bent,
)

ex, ey, ez = np.eye(3)


def _bends(center):
    answer = subproblems.subproblem3(
        ey, WRIST - ELBOW, SHOULDER - ELBOW, np.linalg.norm(center - SHOULDER)
    )
    return answer.theta if answer.exact else []


def right_by_subproblems(center):
    found = []
    for q3 in _bends(center):
        for q2, back in subproblems.subproblem2(ey, ez, bent(q3), center - SHOULDER).theta:
            found.append((-back, q2, q3))
    return found


def right_axes_in_the_other_order(center):
    both = [
        (q3, subproblems.subproblem2(ez, ey, center - SHOULDER, bent(q3)).theta)
        for q3 in _bends(center)
    ]
    return [[-t, q2, q3] for q3, pairs in both for t, q2 in pairs]


def right_by_the_law_of_cosines(center):
    x, y, z = center - SHOULDER
    upper, fore = 0.27, np.hypot(0.302, 0.07)
    cosine = (x * x + y * y + z * z - upper**2 - fore**2) / (2 * upper * fore)
    if abs(cosine) > 1:
        return np.empty((0, 3))
    found = []
    for bend in (np.arccos(cosine), -np.arccos(cosine)):
        q3 = bend - np.arctan2(0.302, 0.07)
        ahead, _, up = bent(q3)
        for q1, reach in (
            (np.arctan2(y, x), np.hypot(x, y)),
            (np.arctan2(-y, -x), -np.hypot(x, y)),
        ):
            found.append([q1, np.arctan2(reach, z) - np.arctan2(ahead, up), q3])
    return np.array(found)


def wrong_one_elbow(center):
    """solutions are missing"""
    return right_by_subproblems(center)[:2]


def wrong_nan_out_of_reach(center):
    """nan is returned where there is no solution"""
    return right_by_subproblems(center) or [(np.nan, np.nan, np.nan)]


def wrong_nearest_for_what_is_out_of_reach(center):
    """out of reach"""
    return right_by_subproblems(center) or [(0.0, 0.0, 0.0)]


def wrong_points_exchanged(center):
    """q1 or q2 is wrong"""
    both = [
        (q3, subproblems.subproblem2(ey, ez, center - SHOULDER, bent(q3)).theta)
        for q3 in _bends(center)
    ]
    return [(-back, q2, q3) for q3, pairs in both for q2, back in pairs]


def wrong_wrist_not_moved(center):
    """p is WRIST - SHOULDER"""
    p, (x, y, z) = WRIST - SHOULDER, center - SHOULDER
    scale = np.sqrt(p @ p - z**2) / np.hypot(x, y)
    found = subproblems.subproblem2(ey, ez, p, np.array([scale * x, scale * y, z])).theta
    return [(-back, q2, q3) for q3 in _bends(center) for q2, back in found]


def wrong_elbows_that_are_nearly_the_same(center):
    """solutions are missing"""
    found = right_by_subproblems(center)
    merge = len(found) == 4 and abs(found[0][2] - found[2][2]) < 1e-3
    return found[:2] if merge else found


def wrong_nothing_near_the_axis_of_joint_1(center):
    """the list is empty although the target is within reach"""
    return right_by_subproblems(center) if np.hypot(*center[:2]) > 1e-3 else []


def wrong_stretched_for_what_is_just_out_of_reach(center):
    """joint angles are returned for a target out of reach"""
    reach = np.linalg.norm(ELBOW - SHOULDER) + np.linalg.norm(WRIST - ELBOW)
    ratio = np.linalg.norm(center - SHOULDER) / reach
    if 1 < ratio < 1 + 1e-5:
        return right_by_subproblems(SHOULDER + (center - SHOULDER) / ratio * (1 - 1e-9))
    return right_by_subproblems(center)
