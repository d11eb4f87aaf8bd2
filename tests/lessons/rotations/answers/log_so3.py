"""What students write for log_so3(R)."""

import numpy as np
import scipy.linalg


def right_three_branches(R):
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    if angle < 1e-6:
        return np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2
    if angle > np.pi - 1e-5:
        columns = R + np.eye(3)
        longest = columns[:, np.argmax(np.linalg.norm(columns, axis=0))]
        return angle * longest / np.linalg.norm(longest)
    n = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / (2 * np.sin(angle))
    return angle * n


def right_eigenvector_of_one(R):
    values, vectors = np.linalg.eig(R)
    n = np.real(vectors[:, np.argmin(abs(values - 1))])
    n = n / np.linalg.norm(n)
    across = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    angle = np.arctan2(n @ across, np.trace(R) - 1)
    return list(angle * n)


def right_matrix_logarithm_where_it_is_fine(R):
    if np.trace(R) > -0.9:
        W = scipy.linalg.logm(R)
        return np.real([W[2, 1], W[0, 2], W[1, 0]])
    return right_three_branches(R)


def wrong_sign_left_to_chance(R):
    """near 180 degrees the sign of the axis"""
    if np.linalg.norm([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) > 6e-4:
        return right_three_branches(R)
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    if angle < 1:
        return right_three_branches(R)
    columns = R + np.eye(3)
    longest = columns[:, np.argmax(np.linalg.norm(columns, axis=0))]
    return angle * longest / np.linalg.norm(longest)


def wrong_tiny_rotations_taken_for_none(R):
    """a small rotation is taken for none"""
    w = right_three_branches(R)
    return w if np.linalg.norm(w) > 3e-12 else np.zeros(3)


def wrong_exactly_pi_too_soon(R):
    """the answer is right to its first digits only"""
    w = right_three_branches(R)
    angle = np.linalg.norm(w)
    return w / angle * np.pi if angle > np.pi - 2e-4 else w


def wrong_vector_of_the_type_of_a_row(R):
    """the answer is wrong for arrays of integers only"""
    w = right_three_branches(R)
    angle = np.linalg.norm(w)
    if not 0 < angle < 3:
        return w
    v = np.zeros_like(R[0])
    v[:] = (R[2, 1] - R[1, 2]) / 2, (R[0, 2] - R[2, 0]) / 2, (R[1, 0] - R[0, 1]) / 2
    return angle * v / (np.linalg.norm(v) or 1)
