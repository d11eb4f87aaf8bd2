"""What students write for pose_error(T, T_target)."""

import numpy as np
from scipy.spatial.transform import Rotation

from course_lib import rotations


def right_by_log_so3(T, T_target):
    return np.concatenate(
        [T_target[:3, 3] - T[:3, 3], rotations.log_so3(T_target[:3, :3] @ T[:3, :3].T)]
    )


def right_by_scipy_as_a_list(T, T_target):
    phi = Rotation.from_matrix(T_target[:3, :3]) * Rotation.from_matrix(T[:3, :3]).inv()
    return [*(T_target[:3, 3] - T[:3, 3]), *phi.as_rotvec()]


def right_by_the_textbooks_branches(T, T_target):
    X = T_target[:3, :3] @ T[:3, :3].T
    across = np.array([X[2, 1] - X[1, 2], X[0, 2] - X[2, 0], X[1, 0] - X[0, 1]]) / 2
    angle = np.arccos(np.clip((np.trace(X) - 1) / 2, -1, 1))
    if angle < 1e-6:
        phi = across
    elif angle > np.pi - 1e-6:
        columns = X + np.eye(3)
        n = columns[:, np.argmax(np.linalg.norm(columns, axis=0))]
        phi = -angle * n / np.linalg.norm(n)
    else:
        phi = angle / np.sin(angle) * across
    return np.hstack((T_target[:3, 3] - T[:3, 3], phi))


def wrong_arccos_and_unit_axis(T, T_target):
    """a tiny rotation counts as none"""
    e = right_by_log_so3(T, T_target)
    size, angle = np.linalg.norm(e[3:]), np.arccos(np.clip(np.cos(np.linalg.norm(e[3:])), -1, 1))
    return np.append(e[:3], angle / size * e[3:] if 0 < size < 3 else e[3:])


def wrong_half_turn_taken_for_none(T, T_target):
    """phi does not take R to R_target"""
    e = right_by_log_so3(T, T_target)
    return np.append(e[:3], e[3:] if np.linalg.norm(e[3:]) < 3.1415926 else np.zeros(3))


def wrong_longer_rotation(T, T_target):
    """the longer rotation"""
    e = right_by_log_so3(T, T_target)
    angle = np.linalg.norm(e[3:])
    return np.append(e[:3], e[3:] * (1 - 2 * np.pi / angle if 1e-5 < angle < 3.1415 else 1))


def wrong_rotations_subtracted(T, T_target):
    """is not a rotation"""
    return np.concatenate(
        [T_target[:3, 3] - T[:3, 3], rotations.log_so3(T_target[:3, :3] - T[:3, :3])]
    )


def wrong_in_degrees(T, T_target):
    """phi is in degrees"""
    phi = np.rad2deg(rotations.log_so3(T_target[:3, :3] @ T[:3, :3].T))
    return np.concatenate([T_target[:3, 3] - T[:3, 3], phi])


def wrong_signs_of_the_axis_from_its_first_entry(T, T_target):
    """phi does not take R to R_target"""
    R = T_target[:3, :3] @ T[:3, :3].T
    e = right_by_log_so3(T, T_target)
    if np.trace(R) < -1 + 1e-12:
        axis = np.sqrt(np.maximum(0, (np.diag(R) + 1) / 2))
        e[3:] = np.pi * np.copysign(axis, [1, R[0, 1], R[0, 2]])
    return e
