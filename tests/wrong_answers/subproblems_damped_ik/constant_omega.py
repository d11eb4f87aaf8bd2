"""What students write for constant_omega(R0, Rf, T)."""

import numpy as np
from scipy.spatial.transform import Rotation

from course_lib.rotations import log_so3, matrix_to_quaternion


def right_logarithm(R0, Rf, T):
    return log_so3(Rf @ R0.T) / T


def right_turned_from_the_hand(R0, Rf, T):
    return list(R0 @ log_so3(R0.T @ Rf) / T)


def right_by_scipy(R0, Rf, T):
    return (Rotation.from_matrix(Rf) * Rotation.from_matrix(R0).inv()).as_rotvec()[:, None] / T


def right_other_sign_at_half_a_turn(R0, Rf, T):
    w = -log_so3(R0 @ Rf.T)
    return tuple(float(x) / T for x in w)


def right_by_quaternions(R0, Rf, T):
    w, *v = matrix_to_quaternion(np.einsum("ik,jk->ij", Rf, R0))
    sine = np.linalg.norm(v)
    if sine == 0:
        return np.zeros(3, int)
    return 2 * np.arctan2(sine, w) / sine * np.array(v) / T


def right_three_branches(R0, Rf, T):
    R = Rf @ np.linalg.inv(R0)
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    if angle < 1e-6:
        return _vector(R) / 2 / T
    if angle > np.pi - 1e-6:
        return _at_half_turn(R) / T
    return angle * _vector(R) / (2 * np.sin(angle)) / T


def _vector(R):
    return np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])


def _at_half_turn(R):
    columns = R + np.eye(3)
    longest = columns[:, np.argmax(np.linalg.norm(columns, axis=0))]
    return np.pi * longest / np.linalg.norm(longest)


def _axis_and_angle(R):
    w = log_so3(R)
    angle = np.linalg.norm(w)
    return (w / angle if angle > 0 else w), angle


def wrong_seen_from_the_hand(R0, Rf, T):
    """seen from the rotating end-effector"""
    return log_so3(R0.T @ Rf) / T


def wrong_backwards(R0, Rf, T):
    """the rotation is backwards"""
    return log_so3(R0 @ Rf.T) / T


def wrong_backwards_from_the_hand(R0, Rf, T):
    """the rotation is backwards"""
    return log_so3(Rf.T @ R0) / T


def wrong_not_divided(R0, Rf, T):
    """not divided by T"""
    return log_so3(Rf @ R0.T)


def wrong_multiplied(R0, Rf, T):
    """multiplied by T"""
    return log_so3(Rf @ R0.T) * T


def wrong_divided_twice(R0, Rf, T):
    """divided by T twice"""
    return log_so3(Rf @ R0.T) / T**2


def wrong_logarithms_subtracted(R0, Rf, T):
    """the rotation vectors of R0 and Rf are subtracted"""
    return (log_so3(Rf) - log_so3(R0)) / T


def wrong_rf_alone(R0, Rf, T):
    """R0 is left out"""
    return log_so3(Rf) / T


def wrong_axis_of_rf_and_difference_of_the_angles(R0, Rf, T):
    """unnamed"""
    n, angle = _axis_and_angle(Rf)
    return n * (angle - _axis_and_angle(R0)[1]) / T


def wrong_transpose_missing(R0, Rf, T):
    """the transpose is missing"""
    return log_so3(Rf @ R0) / T


def wrong_transpose_missing_other_order(R0, Rf, T):
    """the transpose is missing"""
    return log_so3(R0 @ Rf) / T


def wrong_long_way_round(R0, Rf, T):
    """the long way round"""
    n, angle = _axis_and_angle(Rf @ R0.T)
    return n * (angle - 2 * np.pi) / T if angle > 0 else n


def wrong_a_whole_turn_more(R0, Rf, T):
    """the long way round"""
    n, angle = _axis_and_angle(Rf @ R0.T)
    return n * (angle + 2 * np.pi) / T if angle > 0 else n


def wrong_degrees(R0, Rf, T):
    """degrees"""
    return np.rad2deg(log_so3(Rf @ R0.T)) / T


def wrong_angle_taken_for_degrees(R0, Rf, T):
    """degrees"""
    return np.deg2rad(log_so3(Rf @ R0.T) / T)


def wrong_divided_by_the_sine_at_half_a_turn(R0, Rf, T):
    """a rotation by 180 degrees is taken for none"""
    R = Rf @ R0.T
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    if np.isclose(np.sin(angle), 0, atol=1e-6):
        return _vector(R) / 2 / T
    return angle * _vector(R) / (2 * np.sin(angle)) / T


def wrong_sine_of_pi(R0, Rf, T):
    """the answer is not the axis times pi / T"""
    R = Rf @ R0.T
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    if angle < 1e-6:
        return np.zeros(3)
    if angle > np.pi - 1e-6:
        return np.pi * np.sqrt(np.maximum((np.diag(R) + 1) / 2, 0)) / T
    return angle * _vector(R) / (2 * np.sin(angle)) / T


def wrong_nan_at_half_a_turn(R0, Rf, T):
    """at a half turn"""
    R = Rf @ R0.T
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    if angle < 1e-6:
        return np.zeros(3)
    across = _vector(R)
    return angle * across / np.linalg.norm(across) / T


def wrong_arccos_outside_its_domain(R0, Rf, T):
    """arccos is asked outside"""
    R = Rf @ R0.T
    angle = np.arccos((np.trace(R) - 1) / 2)
    if angle < 1e-6:
        return _vector(R) / 2 / T
    if angle > np.pi - 1e-6:
        return _at_half_turn(R) / T
    return angle * _vector(R) / (2 * np.sin(angle)) / T


def wrong_branch_for_tiny_turns(R0, Rf, T):
    """the half is missing"""
    R = Rf @ R0.T
    w = log_so3(R)
    return w / T if np.linalg.norm(w) > 1e-6 else _vector(R) / T


def wrong_divided_by_the_angle_of_no_turn(R0, Rf, T):
    """where nothing rotates"""
    w = log_so3(Rf @ R0.T)
    return w / np.linalg.norm(w) * np.linalg.norm(w) / T


def wrong_an_axis_for_no_turn(R0, Rf, T):
    """where nothing rotates"""
    w = log_so3(Rf @ R0.T)
    return w / T if np.linalg.norm(w) > 1e-9 else np.array([0, 0, 1])


def wrong_axis_alone(R0, Rf, T):
    """the axis alone"""
    return _axis_and_angle(Rf @ R0.T)[0] / T


def wrong_angle_twice(R0, Rf, T):
    """the angle is multiplied twice"""
    w = log_so3(Rf @ R0.T)
    return np.linalg.norm(w) * w / T


def wrong_skew_part(R0, Rf, T):
    """the skew part"""
    return _vector(Rf @ R0.T) / 2 / T


def wrong_skew_part_whole(R0, Rf, T):
    """the half is missing"""
    return _vector(Rf @ R0.T) / T


def wrong_difference_quotient(R0, Rf, T):
    """the difference Rf - R0"""
    W = (Rf - R0) / T @ R0.T
    return np.array([W[2, 1], W[0, 2], W[1, 0]])


def wrong_small_turns_cut(R0, Rf, T):
    """small rotations are cut off"""
    w = log_so3(Rf @ R0.T)
    return w / T if np.linalg.norm(w) > 1e-3 else np.zeros(3)


def wrong_arcsine(R0, Rf, T):
    """beyond a quarter turn"""
    R = Rf @ R0.T
    n, _ = _axis_and_angle(R)
    return n * np.arcsin(min(np.linalg.norm(_vector(R)) / 2, 1)) / T


def wrong_half_angle(R0, Rf, T):
    """half of the angle"""
    w, *v = matrix_to_quaternion(Rf @ R0.T)
    sine = np.linalg.norm(v)
    return np.arctan2(sine, w) / sine * np.array(v) / T if sine > 0 else np.zeros(3)


def wrong_speed_alone(R0, Rf, T):
    """another form"""
    return np.linalg.norm(log_so3(Rf @ R0.T)) / T


def wrong_skew_matrix(R0, Rf, T):
    """another form"""
    w = log_so3(Rf @ R0.T) / T
    return np.array([[0, -w[2], w[1]], [w[2], 0, -w[0]], [-w[1], w[0], 0]])


def wrong_start_changed_in_place(R0, Rf, T):
    """R0 is changed in place"""
    R0[:] = R0.T
    return log_so3(Rf @ R0) / T
