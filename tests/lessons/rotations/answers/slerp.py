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


def wrong_chord_between_near_rotations(q0, q1, t):
    """the answer is right to its first digits only"""
    cosine = q0 @ q1
    if cosine < 0:
        q1, cosine = -q1, -cosine
    if cosine > 0.9999:
        chord = (1 - t) * q0 + t * q1
        return chord / np.linalg.norm(chord)
    a = np.arccos(cosine)
    return (np.sin((1 - t) * a) * q0 + np.sin(t * a) * q1) / np.sin(a)


def wrong_longer_arc_with_q0_for_opposite_ones(q0, q1, t):
    """the longer arc is taken"""
    a = np.arccos(np.clip(q0 @ q1, -1, 1))
    if np.sin(a) < 1e-9:
        return q0
    return (np.sin((1 - t) * a) * q0 + np.sin(t * a) * q1) / np.sin(a)


def wrong_chord_of_nearly_length_one(q0, q1, t):
    """the answer is right to its first digits only"""
    q1 = q1 if q0 @ q1 >= 0 else -q1
    a = np.arccos(min(q0 @ q1, 1))
    if a < 1.4e-4:
        return (1 - t) * q0 + t * q1
    return (np.sin((1 - t) * a) * q0 + np.sin(t * a) * q1) / np.sin(a)
