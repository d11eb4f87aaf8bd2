"""What students write for twist_in_frames(V_s, T)."""

import numpy as np

from course_lib.arms import SerialArm
from course_lib.rigid import adjoint, exp_se3, hat_se3, inverse
from course_lib.rotations import hat


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


def right_both_halves_turned_back(V_s, T):
    R = T[:3, :3]
    hand = adjoint(inverse(T)) @ V_s
    return np.vstack([V_s, hand, np.kron(np.eye(2), R) @ hand])


def right_by_conjugation(V_s, T):
    rows = np.zeros((3, 6))
    for i, R in enumerate((None, T[:3, :3], np.eye(3))):
        frame = np.eye(4)
        if R is not None:
            frame[:3, :3], frame[:3, 3] = R, T[:3, 3]
        V = np.linalg.inv(frame) @ hat_se3(V_s) @ frame
        rows[i] = V[2, 1], V[0, 2], V[1, 0], V[0, 3], V[1, 3], V[2, 3]
    return rows


def right_component_by_component(V_s, T):
    a, b, c, u, v, w = V_s
    x, y, z = T[:3, 3]
    velocity = [u + b * z - c * y, v + c * x - a * z, w + a * y - b * x]
    along = [[sum(T[k, i] * q[k] for k in range(3)) for i in range(3)] for q in ([a, b, c], velocity)]
    return [[a, b, c, u, v, w], along[0] + along[1], [a, b, c] + velocity]


def _third(V_s, T):
    return np.concatenate([V_s[:3], V_s[3:] + np.cross(V_s[:3], T[:3, 3])])


def wrong_reports_adjoint(V_s, T):
    """the upper left block of the adjoint is R^-1"""

    def ad(T):
        R, p = T[:3, :3], T[:3, 3]
        return np.block([[np.linalg.inv(R), np.zeros((3, 3))], [hat(p) @ R, R]])

    return np.array([V_s, ad(inverse(T)) @ V_s, _third(V_s, T)])


def wrong_inverse_without_R(V_s, T):
    """lacks its R^T or its minus"""
    R, p = T[:3, :3], T[:3, 3]
    ad = np.block([[R.T, np.zeros((3, 3))], [hat(-p) @ R.T, R.T]])
    return np.array([V_s, ad @ V_s, _third(V_s, T)])


def wrong_R_for_its_transpose(V_s, T):
    """R stands where R^T belongs"""
    R, third = T[:3, :3], _third(V_s, T)
    return np.array([V_s, np.concatenate([R @ third[:3], R @ third[3:]]), third])


def wrong_columns(V_s, T):
    """rows and columns are swapped"""
    return np.column_stack([V_s, adjoint(inverse(T)) @ V_s, _third(V_s, T)])


def wrong_third_frame_forgotten(V_s, T):
    """one of the three frames is missing"""
    return V_s, adjoint(inverse(T)) @ V_s


def wrong_V_changed(V_s, T):
    """V_s is changed in place"""
    hand = adjoint(inverse(T)) @ V_s
    third = V_s
    third[3:] = V_s[3:] + np.cross(V_s[:3], T[:3, 3])
    return np.array([V_s, hand, third])


def wrong_next_position(V_s, T):
    """unnamed"""
    moved = exp_se3(V_s) @ T
    return np.array([V_s, adjoint(inverse(T)) @ V_s, np.concatenate([V_s[:3], moved[:3, 3] - T[:3, 3]])])


def wrong_the_librarys(V_s, T):
    """course_lib.arms.SerialArm is called"""
    return SerialArm(V_s[None], T[None], None).screw_axes
