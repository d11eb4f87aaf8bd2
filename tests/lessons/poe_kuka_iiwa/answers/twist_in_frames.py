"""What students write for twist_in_frames(V_s, T)."""

import numpy as np

from course_lib.rigid import adjoint, exp_se3, inverse


def right_by_adjoint(V_s, T):
    w, v, p = V_s[:3], V_s[3:], T[:3, 3]
    return np.array([V_s, adjoint(inverse(T)) @ V_s, np.concatenate([w, v + np.cross(w, p)])])


def right_two_adjoints_as_lists(V_s, T):
    third = np.eye(4)
    third[:3, 3] = T[:3, 3]
    return [list(np.linalg.inv(adjoint(frame)) @ V_s) for frame in (np.eye(4), T, third)]


def right_by_the_hands_view(V_s, T):
    R = T[:3, :3]
    hand = np.linalg.solve(adjoint(T), V_s)
    return V_s, hand, np.append(V_s[:3], R @ hand[3:])


def wrong_next_position(V_s, T):
    """the third row is not"""
    moved = exp_se3(V_s) @ T
    return np.array(
        [V_s, adjoint(inverse(T)) @ V_s, np.concatenate([V_s[:3], moved[:3, 3] - T[:3, 3]])]
    )
