"""What students write for register_points(src, dst, weights)."""

import numpy as np
from scipy.linalg import polar
from scipy.spatial.transform import Rotation

from course_lib import registration
from course_lib.rotations import quaternion_to_matrix


def kabsch(src, dst, weights, rotation):
    """The pose with rotation(V, U^T, H), of H = U S V^T, the sum of a_i b_i^T."""
    c, d = np.average(src, axis=0, weights=weights), np.average(dst, axis=0, weights=weights)
    H = (src - c).T @ (weights[:, None] * (dst - d))
    U, _, Vt = np.linalg.svd(H)
    R = rotation(Vt.T, U.T, H)
    return np.block([[R, (d - R @ c)[:, None]], [np.zeros(3), 1]])


def right_kabsch(src, dst, weights):
    return kabsch(
        src, dst, weights, lambda V, Ut, H: V @ np.diag([1, 1, np.linalg.det(V @ Ut)]) @ Ut
    )


def right_horns_quaternion_as_lists(src, dst, weights):
    w = weights / weights.sum()
    M = (src - w @ src).T @ np.diag(w) @ (dst - w @ dst)
    skew, N = M - M.T, np.zeros((4, 4))
    N[0, 0] = np.trace(M)
    N[0, 1:] = N[1:, 0] = skew[1, 2], skew[2, 0], skew[0, 1]
    N[1:, 1:] = M + M.T - np.trace(M) * np.eye(3)
    R = quaternion_to_matrix(np.linalg.eigh(N)[1][:, -1])
    return np.vstack([np.column_stack([R, w @ dst - R @ (w @ src)]), [0, 0, 0, 1]]).tolist()


def right_polar_decomposition(src, dst, weights):
    w, T = weights / weights.sum(), np.eye(4, dtype=complex)
    Q, stretch = polar((dst - w @ dst).T @ np.diag(w) @ (src - w @ src))
    least = np.linalg.eigh(stretch)[1][:, 0]
    T[:3, :3] = Q + (np.linalg.det(Q) - 1) * np.outer(Q @ least, least)
    T[:3, 3] = w @ dst - T[:3, :3] @ (w @ src)
    return T


def wrong_reflections_stay(src, dst, weights):
    """R has the other sign at the smallest singular value"""
    return kabsch(src, dst, weights, lambda V, Ut, H: V @ Ut)


def wrong_as_in_the_report(src, dst, weights):
    """R is not the best rotation if U V^T is a reflection"""
    return kabsch(src, dst, weights, lambda V, Ut, H: V @ Ut * [1, 1, np.linalg.det(V @ Ut)])


def wrong_sign_of_the_products_determinant(src, dst, weights):
    """the block is not a rotation"""
    return kabsch(
        src, dst, weights, lambda V, Ut, H: V @ np.diag([1, 1, np.sign(np.linalg.det(H))]) @ Ut
    )


def wrong_of_the_transpose(src, dst, weights):
    """R is the rotation nearest to the transpose of B"""
    return kabsch(
        src, dst, weights, lambda V, Ut, H: (V @ np.diag([1, 1, np.linalg.det(V @ Ut)]) @ Ut).T
    )


def wrong_Vt_taken_for_V(src, dst, weights):
    """T is wrong even without noise"""
    return kabsch(
        src, dst, weights, lambda V, Ut, H: V.T @ np.diag([1, 1, np.linalg.det(V.T @ Ut)]) @ Ut
    )


def wrong_apart(src, dst, weights):
    """R and p are returned separately"""
    T = right_kabsch(src, dst, weights)
    return T[:3, :3], T[:3, 3]


def wrong_weights_missing(src, dst, weights):
    """each positive weight counts as 1"""
    return right_kabsch(src, dst, np.ones(len(src)) * (weights > 0))


def wrong_scipys(src, dst, weights):
    """scipy.spatial.transform.Rotation is called"""
    return Rotation.align_vectors(dst, src, weights)[0].as_matrix()


def wrong_the_librarys(src, dst, weights):
    """course_lib.registration.register_points is called"""
    return registration.register_points(src, dst, weights)


def wrong_small_weights_are_all_the_same(src, dst, weights):
    """the answers to some inputs only are wrong"""
    return right_kabsch(src, dst, weights if weights.sum() > 1e-6 else np.ones(len(src)))


def wrong_light_points_left_out(src, dst, weights):
    """the answers to some inputs only are wrong"""
    return right_kabsch(src, dst, np.where(weights < 1e-4 * weights.max(), 0, weights))


def wrong_nearly_the_same_points_have_not_moved(src, dst, weights):
    """T is wrong even without noise"""
    if np.allclose(src, dst):
        return np.eye(4)
    return right_kabsch(src, dst, weights)
