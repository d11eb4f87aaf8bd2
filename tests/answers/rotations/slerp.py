"""What students write for slerp(q0, q1, t)."""

import numpy as np

from course_lib.rotations import exp_so3, log_so3, matrix_to_quaternion, quaternion_to_matrix


def right_two_sines(q0, q1, t):
    if q0 @ q1 < 0:
        q1 = -q1
    a = np.arccos(np.clip(q0 @ q1, -1, 1))
    if a < 1e-6:
        q = (1 - t) * q0 + t * q1
        return q / np.linalg.norm(q)
    return (np.sin((1 - t) * a) * q0 + np.sin(t * a) * q1) / np.sin(a)


def right_along_an_orthogonal_direction(q0, q1, t):
    q1 = q1 * (1 if q0 @ q1 >= 0 else -1)
    across = q1 - (q0 @ q1) * q0
    size = np.linalg.norm(across)
    if size == 0:
        return q0.tolist()
    a = np.arctan2(size, q0 @ q1)
    return (np.cos(t * a) * q0 + np.sin(t * a) * across / size).tolist()


def right_by_matrices(q0, q1, t):
    R0, R1 = quaternion_to_matrix(q0), quaternion_to_matrix(q1)
    return -matrix_to_quaternion(R0 @ exp_so3(t * log_so3(R0.T @ R1))).reshape(4, 1)


def wrong_longer_arc(q0, q1, t):
    """the longer arc is taken"""
    a = np.arccos(np.clip(q0 @ q1, -1, 1))
    if abs(np.sin(a)) < 1e-7:
        return q0
    return (np.sin((1 - t) * a) * q0 + np.sin(t * a) * q1) / np.sin(a)


def wrong_no_special_case(q0, q1, t):
    """the sine of a very small angle"""
    if q0 @ q1 < 0:
        q1 = -q1
    a = np.arccos(np.clip(q0 @ q1, -1, 1))
    return (np.sin((1 - t) * a) * q0 + np.sin(t * a) * q1) / np.sin(a) if a else np.full(4, np.nan)


def wrong_absolute_cosine_without_the_sign(q0, q1, t):
    """the angle belongs to -q1"""
    a = np.arccos(np.clip(abs(q0 @ q1), 0, 1))
    if a < 1e-6:
        return q0
    return (np.sin((1 - t) * a) * q0 + np.sin(t * a) * q1) / np.sin(a)


def wrong_straight_line_if_close(q0, q1, t):
    """the quaternions are mixed on the straight line and normalised"""
    q1 = q1 * (1 if q0 @ q1 >= 0 else -1)
    a = np.arccos(np.clip(q0 @ q1, -1, 1))
    if a < 1.5:
        q = (1 - t) * q0 + t * q1
        return q / np.linalg.norm(q)
    return (np.sin((1 - t) * a) * q0 + np.sin(t * a) * q1) / np.sin(a)


def wrong_clip_forgotten(q0, q1, t):
    """the sine of a very small angle"""
    q1 = q1 * (1 if q0 @ q1 >= 0 else -1)
    with np.errstate(all="ignore"):
        a = np.arccos((q0 @ q1) * (1 + 1e-15))
        return (np.sin((1 - t) * a) * q0 + np.sin(t * a) * q1) / np.sin(a)


def wrong_weights_swapped(q0, q1, t):
    """t runs from q1 to q0"""
    if q0 @ q1 < 0:
        q1 = -q1
    a = np.arccos(np.clip(q0 @ q1, -1, 1))
    if a < 1e-6:
        return t * q0 + (1 - t) * q1
    return (np.sin(t * a) * q0 + np.sin((1 - t) * a) * q1) / np.sin(a)


def wrong_cosines(q0, q1, t):
    """q1 is taken for a direction"""
    if q0 @ q1 < 0:
        q1 = -q1
    a = np.arccos(np.clip(q0 @ q1, -1, 1))
    return np.cos(t * a) * q0 + np.sin(t * a) * q1


def wrong_in_place(q0, q1, t):
    """q1 is changed in place"""
    if q0 @ q1 < 0:
        q1 *= -1
    a = np.arccos(np.clip(q0 @ q1, -1, 1))
    return q0 if a < 1e-6 else (np.sin((1 - t) * a) * q0 + np.sin(t * a) * q1) / np.sin(a)


def wrong_small_angles_stay(q0, q1, t):
    """nearly equal rotations are taken for equal"""
    if q0 @ q1 < 0:
        q1 = -q1
    a = np.arccos(np.clip(q0 @ q1, -1, 1))
    if a < 1e-4:
        return q0
    return (np.sin((1 - t) * a) * q0 + np.sin(t * a) * q1) / np.sin(a)
