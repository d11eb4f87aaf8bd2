"""What students write for register_points(src, dst, weights)."""

import numpy as np
import scipy.linalg
from scipy.spatial.transform import Rotation

from course_lib import registration
from course_lib.rotations import nearest_so, quaternion_to_matrix


def right_kabsch(src, dst, weights):
    c_src, c_dst = np.average(src, axis=0, weights=weights), np.average(dst, axis=0, weights=weights)
    H = (src - c_src).T @ (weights[:, None] * (dst - c_dst))
    U, _, Vt = np.linalg.svd(H)
    V = Vt.T.copy()
    if np.linalg.det(V @ U.T) < 0:
        V[:, 2] *= -1
    T = np.eye(4)
    T[:3, :3] = V @ U.T
    T[:3, 3] = c_dst - T[:3, :3] @ c_src
    return T


def right_loops_and_lists(src, dst, weights):
    total = sum(weights)
    c = [sum(w * p[k] for w, p in zip(weights, src, strict=True)) / total for k in range(3)]
    d = [sum(w * p[k] for w, p in zip(weights, dst, strict=True)) / total for k in range(3)]
    H = np.zeros((3, 3))
    for w, p, q in zip(weights, src, dst, strict=True):
        H += w / total * np.outer(q - d, p - c)
    R = nearest_so(H)
    return [[*R[i], d[i] - sum(R[i, j] * c[j] for j in range(3))] for i in range(3)] + [[0, 0, 0, 1]]


def right_horns_quaternion(src, dst, weights):
    w = weights / weights.sum()
    a, b = src - w @ src, dst - w @ dst
    M = a.T @ np.diag(w) @ b
    skew = M - M.T
    N = np.zeros((4, 4))
    N[0, 0] = np.trace(M)
    N[0, 1:] = N[1:, 0] = skew[1, 2], skew[2, 0], skew[0, 1]
    N[1:, 1:] = M + M.T - np.trace(M) * np.eye(3)
    R = quaternion_to_matrix(np.linalg.eigh(N)[1][:, -1])
    return np.vstack([np.column_stack([R, w @ dst - R @ (w @ src)]), [0, 0, 0, 1]])


def right_scipys(src, dst, weights):
    c_src = (weights[:, None] * src).sum(0) / weights.sum()
    c_dst = (weights[:, None] * dst).sum(0) / weights.sum()
    T = np.eye(4)
    T[:3, :3] = Rotation.align_vectors(dst - c_dst, src - c_src, weights)[0].as_matrix()
    T[:3, 3] = c_dst - T[:3, :3] @ c_src
    return T


def right_roots_on_both_sides(src, dst, weights):
    keep = weights > 0
    root = np.sqrt(weights[keep])[:, None]
    c, d = (np.average(points[keep], axis=0, weights=weights[keep]) for points in (src, dst))
    U, _, Vt = scipy.linalg.svd((root * (dst[keep] - d)).T @ (root * (src[keep] - c)))
    U[:, -1] *= np.linalg.det(U) * np.linalg.det(Vt)
    R = U @ Vt
    back, phi, on = np.eye(4), np.eye(4), np.eye(4)
    back[:3, 3], phi[:3, :3], on[:3, 3] = -c, R, d
    return (on @ phi @ back).astype(complex)


def right_one_side_centred(src, dst, weights):
    c, d = weights @ src / sum(weights), weights @ dst / sum(weights)
    H = np.einsum("n,ni,nj->ij", weights, src - c, dst)
    U, _, Vt = np.linalg.svd(H)
    R = Vt.T @ np.diag([1, 1, np.linalg.det(Vt.T @ U.T)]) @ U.T
    return tuple(map(tuple, np.r_[np.c_[R, d - R @ c], [[0, 0, 0, 1]]]))


def _pose(R, p):
    T = np.eye(4)
    T[:3, :3], T[:3, 3] = R, p
    return T


def _middles(src, dst, weights):
    return weights @ src / weights.sum(), weights @ dst / weights.sum()


def _product(src, dst, weights):
    c, d = _middles(src, dst, weights)
    return (src - c).T @ (weights[:, None] * (dst - d))


def _rotation(src, dst, weights):
    return nearest_so(_product(src, dst, weights).T)


def _finished(R, src, dst, weights):
    c, d = _middles(src, dst, weights)
    return _pose(R, d - R @ c)


def wrong_reflections_stay(src, dst, weights):
    """U V^T is returned as it is, a reflection if its determinant is -1"""
    U, _, Vt = np.linalg.svd(_product(src, dst, weights))
    return _finished(Vt.T @ U.T, src, dst, weights)


def wrong_as_in_the_report(src, dst, weights):
    """a column or row of the finished R is negated"""
    U, _, Vt = np.linalg.svd(_product(src, dst, weights))
    R = Vt.T @ U.T
    if np.linalg.det(R) < 0:
        R[:, 2] *= -1
    return _finished(R, src, dst, weights)


def wrong_last_row_negated(src, dst, weights):
    """a column or row of the finished R is negated"""
    U, _, Vt = np.linalg.svd(_product(src, dst, weights))
    R = Vt.T @ U.T
    if np.linalg.det(R) < 0:
        R[2] *= -1
    return _finished(R, src, dst, weights)


def wrong_first_column_negated(src, dst, weights):
    """a column or row of the finished R is negated"""
    U, _, Vt = np.linalg.svd(_product(src, dst, weights))
    R = Vt.T @ U.T
    R[:, 0] *= np.linalg.det(R)
    return _finished(R, src, dst, weights)


def wrong_all_of_it_negated(src, dst, weights):
    """a column or row of the finished R is negated"""
    U, _, Vt = np.linalg.svd(_product(src, dst, weights))
    R = Vt.T @ U.T
    return _finished(R * np.linalg.det(R), src, dst, weights)


def wrong_sign_at_the_largest(src, dst, weights):
    """another singular value than the smallest"""
    U, _, Vt = np.linalg.svd(_product(src, dst, weights))
    R = Vt.T @ np.diag([np.linalg.det(Vt.T @ U.T), 1, 1]) @ U.T
    return _finished(R, src, dst, weights)


def wrong_column_of_Vt_negated(src, dst, weights):
    """unnamed"""
    U, _, Vt = np.linalg.svd(_product(src, dst, weights))
    if np.linalg.det(Vt.T @ U.T) < 0:
        Vt[:, 2] *= -1
        U[0] *= -1
        Vt[:, 0] *= -1
    return _finished(Vt.T @ U.T, src, dst, weights)


def wrong_sign_always(src, dst, weights):
    """the sign is always changed"""
    U, _, Vt = np.linalg.svd(_product(src, dst, weights))
    Vt[2] *= -1
    return _finished(Vt.T @ U.T, src, dst, weights)


def wrong_sign_by_the_products_determinant(src, dst, weights):
    """the sign is random"""
    H = _product(src, dst, weights)
    U, _, Vt = np.linalg.svd(H)
    if np.linalg.det(H) < 0:
        Vt[2] *= -1
    return _finished(Vt.T @ U.T, src, dst, weights)


def wrong_sign_by_the_products_determinant_with_a_tolerance(src, dst, weights):
    """the sign is random"""
    H = _product(src, dst, weights)
    U, _, Vt = np.linalg.svd(H)
    D = np.diag([1, 1, -1 if np.linalg.det(H) < -1e-12 else 1])
    return _finished(Vt.T @ D @ U.T, src, dst, weights)


def wrong_sign_of_the_products_determinant(src, dst, weights):
    """the sign is taken from the determinant of the sum of the b_i a_i^T"""
    H = _product(src, dst, weights)
    U, _, Vt = np.linalg.svd(H)
    return _finished(Vt.T @ np.diag([1, 1, np.sign(np.linalg.det(H))]) @ U.T, src, dst, weights)


def wrong_Vt_taken_for_V(src, dst, weights):
    """numpy's third result is taken for V"""
    U, _, V = np.linalg.svd(_product(src, dst, weights))
    R = V @ U.T
    if np.linalg.det(R) < 0:
        V[:, 2] *= -1
        R = V @ U.T
    return _finished(R, src, dst, weights)


def wrong_Vt_transposed_once_more(src, dst, weights):
    """numpy's third result is taken for V"""
    U, _, Vt = np.linalg.svd(_product(src, dst, weights).T)
    D = np.diag([1, 1, np.linalg.det(U @ Vt.T)])
    return _finished(U @ D @ Vt.T, src, dst, weights)


def wrong_U_not_transposed(src, dst, weights):
    """a factor is transposed once too often"""
    U, _, Vt = np.linalg.svd(_product(src, dst, weights))
    return _finished(Vt.T @ U, src, dst, weights)


def wrong_rotation_alone(src, dst, weights):
    """only the rotation R is returned"""
    return _rotation(src, dst, weights)


def wrong_apart(src, dst, weights):
    """R and p are returned apart"""
    c, d = _middles(src, dst, weights)
    R = _rotation(src, dst, weights)
    return R, d - R @ c


def wrong_three_rows(src, dst, weights):
    """the last row is missing"""
    return right_kabsch(src, dst, weights)[:3]


def wrong_last_row_zero(src, dst, weights):
    """the last row is not that of a pose"""
    T = np.zeros((4, 4))
    T[:3] = right_kabsch(src, dst, weights)[:3]
    return T


def wrong_product_of_points(src, dst, weights):
    """ValueError"""
    c, d = _middles(src, dst, weights)
    U, _, Vt = np.linalg.svd((src - c) @ (dst - d).T)
    R = Vt.T @ U.T
    return _pose(R, d - R @ c)


def wrong_weights_times_rows(src, dst, weights):
    """ValueError"""
    c = np.sum(weights * src, axis=0) / np.sum(weights)
    d = np.sum(weights * dst, axis=0) / np.sum(weights)
    return _pose(nearest_so((dst - d).T @ (src - c)), d - c)


def wrong_rounded(src, dst, weights):
    """right to its first digits only"""
    return np.round(right_kabsch(src, dst, weights), 4)


def wrong_in_place(src, dst, weights):
    """src is changed in place"""
    c, d = _middles(src, dst, weights)
    src[:] = src - c
    R = nearest_so((dst - d).T @ (weights[:, None] * src))
    return _pose(R, d - R @ c)


def wrong_weights_with_a_number_added(src, dst, weights):
    """unnamed"""
    return right_kabsch(src, dst, np.where(weights > 0, weights + 0.3, 0))


def wrong_the_librarys(src, dst, weights):
    """course_lib.registration.register_points is called"""
    return registration.register_points(src, dst, weights)
