"""What students write for arm_angles(center)."""

import numpy as np

from course_lib import subproblems
from course_lib.rotations import exp_so3, rot_y

ex, ey, ez = np.eye(3)
SHOULDER, ELBOW, WRIST = np.array([0, 0, 0.29]), np.array([0, 0, 0.56]), np.array([0.302, 0, 0.63])


def subproblem2(*case):
    answer = subproblems.subproblem2(*case)
    return list(answer.theta) if answer.exact else []


def subproblem3(*case):
    answer = subproblems.subproblem3(*case)
    return list(answer.theta) if answer.exact else []


def _bends(center):
    return subproblem3(ey, WRIST - ELBOW, SHOULDER - ELBOW, np.linalg.norm(center - SHOULDER))


def _after(q3):
    return ELBOW - SHOULDER + exp_so3(q3 * ey) @ (WRIST - ELBOW)


def right_by_subproblems(center):
    found = []
    for q3 in _bends(center):
        for q2, back in subproblem2(ey, ez, _after(q3), center - SHOULDER):
            found.append((-back, q2, q3))
    return found


def right_axes_in_the_other_order(center):
    return [[-t, q2, q3] for q3 in _bends(center) for t, q2 in subproblem2(ez, ey, center - SHOULDER, _after(q3))]


def right_by_the_law_of_cosines(center):
    x, y, z = center - SHOULDER
    upper, fore = 0.27, np.hypot(0.302, 0.07)
    cosine = (x * x + y * y + z * z - upper**2 - fore**2) / (2 * upper * fore)
    if abs(cosine) > 1:
        return np.empty((0, 3))
    found = []
    for bend in (np.arccos(cosine), -np.arccos(cosine)):
        q3 = bend - np.arctan2(0.302, 0.07)
        ahead, _, up = _after(q3)
        for q1, reach in ((np.arctan2(y, x), np.hypot(x, y)), (np.arctan2(-y, -x), -np.hypot(x, y))):
            found.append([q1, np.arctan2(reach, z) - np.arctan2(ahead, up), q3])
    return np.array(found)


def wrong_one_elbow(center):
    """solutions are missing"""
    return right_by_subproblems(center)[:2]


def wrong_first_pair_only(center):
    """solutions are missing"""
    return [
        (
            -subproblem2(ey, ez, _after(q3), center - SHOULDER)[0][1],
            subproblem2(ey, ez, _after(q3), center - SHOULDER)[0][0],
            q3,
        )
        for q3 in _bends(center)
    ]


def wrong_sign_of_q1(center):
    """q1 has the wrong sign"""
    return [(-a, b, c) for a, b, c in right_by_subproblems(center)]


def wrong_from_the_base(center):
    """measured from another point than the shoulder"""
    found = []
    for q3 in subproblem3(ey, WRIST - ELBOW, -ELBOW, np.linalg.norm(center)):
        answer = subproblems.subproblem2(ey, ez, _after(q3), center - SHOULDER)
        found += [(-back, q2, q3) for q2, back in answer.theta]
    return found


def wrong_straight_elbow(center):
    """the elbow is not bent"""
    found = []
    for q3 in _bends(center):
        answer = subproblems.subproblem2(ey, ez, WRIST - SHOULDER, center - SHOULDER)
        found += [(-back, q2, q3) for q2, back in answer.theta]
    return found


def wrong_order_of_the_triple(center):
    """q1 and q2 are swapped"""
    return [(b, a, c) for a, b, c in right_by_subproblems(center)]


def wrong_degrees(center):
    """degrees"""
    return np.rad2deg(right_by_subproblems(center))


def wrong_nearest_for_what_is_out_of_reach(center):
    """out of reach"""
    bent = subproblems.subproblem3(ey, WRIST - ELBOW, SHOULDER - ELBOW, np.linalg.norm(center - SHOULDER))
    found = []
    for q3 in bent.theta:
        for q2, back in subproblems.subproblem2(ey, ez, _after(q3), center - SHOULDER).theta:
            found.append((-back, q2, q3))
    return found


def wrong_elbow_other_sign(center):
    """q3 has the wrong sign"""
    found = []
    for q3 in _bends(center):
        p = ELBOW - SHOULDER + rot_y(q3) @ (WRIST - ELBOW)
        found += [(-back, q2, -q3) for q2, back in subproblem2(ey, ez, p, center - SHOULDER)]
    return found
