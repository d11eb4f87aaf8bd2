"""What students write for pose_error(T, T_target)."""

import numpy as np
import scipy.linalg
from scipy.spatial.transform import Rotation

from course_lib import rigid, rotations


def right_by_log_so3(T, T_target):
    e_p = T_target[:3, 3] - T[:3, 3]
    e_phi = rotations.log_so3(T_target[:3, :3] @ T[:3, :3].T)
    return np.concatenate([e_p, e_phi])


def right_by_scipy_as_a_list(T, T_target):
    phi = Rotation.from_matrix(T_target[:3, :3]) * Rotation.from_matrix(T[:3, :3]).inv()
    return [*(T_target[:3, 3] - T[:3, 3]), *phi.as_rotvec()]


def right_by_quaternions(T, T_target):
    w, v = np.split(rotations.matrix_to_quaternion(T[:3, :3]), [1])
    wt, vt = np.split(rotations.matrix_to_quaternion(T_target[:3, :3]), [1])
    cosine, across = wt * w + vt @ v, w * vt - wt * v + np.cross(v, vt)
    if cosine < 0:
        cosine, across = -cosine, -across
    sine = np.linalg.norm(across)
    angle = 2 * np.arctan2(sine, cosine)
    return np.r_[T_target[:3, 3] - T[:3, 3], across * (angle / sine if sine > 0 else 2)]


def right_seen_from_the_hand_and_turned_back(T, T_target):
    R = T[:3, :3]
    X = rigid.inverse(T) @ T_target
    phi = R @ rotations.log_so3(X[:3, :3])
    return np.concatenate([R @ X[:3, 3], phi]).reshape(6, 1)


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


def right_from_the_twist_of_the_world(T, T_target):
    """The twist about the world's origin, whose motion of the end-effector is integrated again."""
    twist = rigid.log_se3(T_target @ rigid.inverse(T))
    position = (rigid.exp_se3(twist) @ T)[:3, 3]
    return np.concatenate([position - T[:3, 3], twist[:3]])


def right_by_angle_and_axis(T, T_target):
    X = T_target[:3, :3] @ T[:3, :3].T
    across = np.array([X[2, 1] - X[1, 2], X[0, 2] - X[2, 0], X[1, 0] - X[0, 1]])
    sine = np.sqrt(across @ across)
    angle = np.arctan2(sine, np.trace(X) - 1)
    if sine > 1e-7:
        n = across / sine
    elif angle < 1:
        n, angle = across / 2, 1.0
    else:
        values, vectors = np.linalg.eigh(X + X.T)
        n = vectors[:, -1]
    return tuple(T_target[:3, 3] - T[:3, 3]) + tuple(angle * n)


def _parts(T, T_target):
    return T[:3, :3], T[:3, 3], T_target[:3, :3], T_target[:3, 3]


def _vee(M):
    return np.array([M[2, 1] - M[1, 2], M[0, 2] - M[2, 0], M[1, 0] - M[0, 1]]) / 2


def wrong_seven_numbers(T, T_target):
    """the difference of positions and quaternions is returned"""
    R, p, R_target, p_target = _parts(T, T_target)
    difference = rotations.matrix_to_quaternion(R_target) - rotations.matrix_to_quaternion(R)
    return np.concatenate([p_target - p, difference])


def wrong_arccos_and_unit_axis(T, T_target):
    """small rotations"""
    R, p, R_target, p_target = _parts(T, T_target)
    X = R_target @ R.T
    angle = np.arccos(np.clip((np.trace(X) - 1) / 2, -1, 1))
    across = _vee(X)
    if angle > 3.14159:
        return right_by_log_so3(T, T_target)
    return np.concatenate([p_target - p, angle * across / max(np.linalg.norm(across), 1e-300)])


def wrong_zero_below_the_arccos(T, T_target):
    """small rotations are cut off to zero"""
    R, p, R_target, p_target = _parts(T, T_target)
    angle = np.arccos(np.clip((np.trace(R_target @ R.T) - 1) / 2, -1, 1))
    phi = np.zeros(3) if angle < 1e-6 else rotations.log_so3(R_target @ R.T)
    return np.concatenate([p_target - p, phi])


def wrong_allclose(T, T_target):
    """small rotations are cut off to zero"""
    R, p, R_target, p_target = _parts(T, T_target)
    if np.allclose(R, R_target):
        return np.concatenate([p_target - p, np.zeros(3)])
    return right_by_log_so3(T, T_target)


def wrong_zero_divided_by_zero(T, T_target):
    """divides by zero, or asks arccos outside"""
    R, p, R_target, p_target = _parts(T, T_target)
    X = R_target @ R.T
    angle = np.arccos((np.trace(X) - 1) / 2)
    return np.concatenate([p_target - p, angle / np.sin(angle) * _vee(X)])


def wrong_half_turn_taken_for_none(T, T_target):
    """pi is taken for a rotation of 0, or its axis is wrong"""
    R, p, R_target, p_target = _parts(T, T_target)
    X = R_target @ R.T
    angle = np.arccos(np.clip((np.trace(X) - 1) / 2, -1, 1))
    factor = angle / np.sin(angle) if 1e-6 < angle < 3.1415926 else 1
    return np.concatenate([p_target - p, factor * _vee(X)])


def wrong_longer_rotation(T, T_target):
    """the longer rotation"""
    R, p, R_target, p_target = _parts(T, T_target)
    phi = rotations.log_so3(R_target @ R.T)
    angle = np.linalg.norm(phi)
    return np.concatenate([p_target - p, phi - 2 * np.pi * phi / angle if 1e-5 < angle < 3.1415 else phi])


def wrong_quaternion_without_sign(T, T_target):
    """the longer rotation"""
    R, p, R_target, p_target = _parts(T, T_target)
    w, v = np.split(rotations.matrix_to_quaternion(R), [1])
    wt, vt = np.split(rotations.matrix_to_quaternion(R_target), [1])
    cosine, across = wt * w + vt @ v, w * vt - wt * v + np.cross(v, vt)
    sine = np.linalg.norm(across)
    angle = 2 * np.arctan2(sine, cosine[0])
    return np.r_[p_target - p, across * (angle / sine if sine > 0 else 2)]


def wrong_rotations_subtracted(T, T_target):
    """is not a rotation"""
    return np.concatenate([T_target[:3, 3] - T[:3, 3], rotations.log_so3(T_target[:3, :3] - T[:3, :3])])


def wrong_entry_by_entry(T, T_target):
    """is not a rotation"""
    return np.concatenate([T_target[:3, 3] - T[:3, 3], rotations.log_so3(T_target[:3, :3] * T[:3, :3].T)])


def wrong_logarithm_of_the_pose(T, T_target):
    """its shape is (4, 4)"""
    return np.concatenate([T_target[:3, 3] - T[:3, 3], rotations.log_so3(T_target @ np.linalg.inv(T))])


def wrong_halves_apart(T, T_target):
    """the halves are not joined"""
    return T_target[:3, 3] - T[:3, 3], rotations.log_so3(T_target[:3, :3] @ T[:3, :3].T)


def wrong_lengths(T, T_target):
    """two lengths are returned"""
    e = right_by_log_so3(T, T_target)
    return np.array([np.linalg.norm(e[:3]), np.linalg.norm(e[3:])])


def wrong_matrix_logarithm(T, T_target):
    """pi is taken for a rotation of 0, or its axis is wrong"""
    R, p, R_target, p_target = _parts(T, T_target)
    X = R_target @ R.T
    if np.trace(X) > -0.999999:
        W = scipy.linalg.logm(X).real
    else:
        W = np.pi * (X - X.T)
    return np.concatenate([p_target - p, [W[2, 1], W[0, 2], W[1, 0]]])


def wrong_target_changed(T, T_target):
    """T_target is changed in place"""
    T_target[:3, 3] -= T[:3, 3]
    return np.concatenate([T_target[:3, 3], rotations.log_so3(T_target[:3, :3] @ T[:3, :3].T)])


def wrong_rounded(T, T_target):
    """first digits only"""
    return np.round(right_by_log_so3(T, T_target), 5)


def wrong_weighted(T, T_target):
    """unnamed"""
    R, p, R_target, p_target = _parts(T, T_target)
    return np.concatenate([p_target - p, 0.3 * rotations.log_so3(R_target @ R.T)])


def wrong_tangent_of_half_the_angle(T, T_target):
    """unnamed"""
    X = T_target[:3, :3] @ T[:3, :3].T
    return np.concatenate(
        [T_target[:3, 3] - T[:3, 3], 2 * _vee(X) / (1 + np.trace(X)) if np.trace(X) > -0.99 else _vee(X)]
    )
