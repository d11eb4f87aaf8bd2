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
    back, turn, on = np.eye(4), np.eye(4), np.eye(4)
    back[:3, 3], turn[:3, :3], on[:3, 3] = -c, R, d
    return (on @ turn @ back).astype(complex)


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
    """the sign is left to chance"""
    H = _product(src, dst, weights)
    U, _, Vt = np.linalg.svd(H)
    if np.linalg.det(H) < 0:
        Vt[2] *= -1
    return _finished(Vt.T @ U.T, src, dst, weights)


def wrong_sign_by_the_products_determinant_with_a_tolerance(src, dst, weights):
    """the sign is left to chance"""
    H = _product(src, dst, weights)
    U, _, Vt = np.linalg.svd(H)
    D = np.diag([1, 1, -1 if np.linalg.det(H) < -1e-12 else 1])
    return _finished(Vt.T @ D @ U.T, src, dst, weights)


def wrong_sign_of_the_products_determinant(src, dst, weights):
    """the sign is taken from the determinant of the sum of the b_i a_i^T"""
    H = _product(src, dst, weights)
    U, _, Vt = np.linalg.svd(H)
    return _finished(Vt.T @ np.diag([1, 1, np.sign(np.linalg.det(H))]) @ U.T, src, dst, weights)


def wrong_transposed_the_wrong_way(src, dst, weights):
    """R^T stands for R: the sum of the b_i a_i^T is transposed"""
    return _finished(nearest_so(_product(src, dst, weights)), src, dst, weights)


def wrong_block_transposed_at_the_end(src, dst, weights):
    """R^T stands for R: the sum of the b_i a_i^T is transposed"""
    T = _finished(_rotation(src, dst, weights), src, dst, weights)
    T[:3, :3] = T[:3, :3].T.copy()
    return T


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


def wrong_singular_values_kept(src, dst, weights):
    """the sum of the b_i a_i^T itself stands for R"""
    U, S, Vt = np.linalg.svd(_product(src, dst, weights) / weights.sum())
    return _finished(Vt.T @ np.diag(S) @ U.T, src, dst, weights)


def wrong_weights_ignored(src, dst, weights):
    """the weights are not used"""
    return right_kabsch(src, dst, np.ones(len(src)))


def wrong_plain_middles(src, dst, weights):
    """the centroids are taken without the weights"""
    c, d = src.mean(0), dst.mean(0)
    R = nearest_so((dst - d).T @ np.diag(weights) @ (src - c))
    return _pose(R, d - R @ c)


def wrong_plain_middles_in_p_only(src, dst, weights):
    """the centroids are taken without the weights"""
    R = _rotation(src, dst, weights)
    return _pose(R, np.mean(dst, axis=0) - R @ np.mean(src, axis=0))


def wrong_plain_product(src, dst, weights):
    """the weights are missing in the sum of the b_i a_i^T"""
    c, d = _middles(src, dst, weights)
    R = nearest_so((dst - d).T @ (src - c))
    return _pose(R, d - R @ c)


def wrong_both_sides_weighed(src, dst, weights):
    """the weights come in twice"""
    c, d = _middles(src, dst, weights)
    R = nearest_so((weights[:, None] * (dst - d)).T @ (weights[:, None] * (src - c)))
    return _pose(R, d - R @ c)


def wrong_root_on_one_side(src, dst, weights):
    """the square roots of the weights"""
    c, d = _middles(src, dst, weights)
    R = nearest_so((np.sqrt(weights)[:, None] * (dst - d)).T @ (src - c))
    return _pose(R, d - R @ c)


def wrong_not_divided(src, dst, weights):
    """the weighted sum is not divided"""
    c, d = weights @ src, weights @ dst
    R = nearest_so((weights[:, None] * (dst - d)).T @ (src - c))
    return _pose(R, d - R @ c)


def wrong_divided_by_the_count(src, dst, weights):
    """the weighted sum is not divided by the sum of the weights"""
    c, d = (weights[:, None] * src).mean(0), (weights[:, None] * dst).mean(0)
    R = nearest_so((weights[:, None] * (dst - d)).T @ (src - c))
    return _pose(R, d - R @ c)


def wrong_weighed_before_centring(src, dst, weights):
    """the weights multiply the points before the centroid is subtracted"""
    a, b = weights[:, None] * src, weights[:, None] * dst
    R = nearest_so((b - b.mean(0)).T @ (a - a.mean(0)))
    return _finished(R, src, dst, weights)


def wrong_not_centred(src, dst, weights):
    """the centroids are not subtracted before R is computed"""
    R = nearest_so(dst.T @ (weights[:, None] * src))
    return _finished(R, src, dst, weights)


def wrong_one_number_for_the_middle(src, dst, weights):
    """one number stands for the centroid"""
    c, d = np.mean(src) * np.ones(3), np.mean(dst) * np.ones(3)
    R = nearest_so((dst - d).T @ (weights[:, None] * (src - c)))
    return _pose(R, d - R @ c)


def wrong_dst_to_src(src, dst, weights):
    """T takes dst to src"""
    return right_kabsch(dst, src, weights)


def wrong_difference_of_the_middles(src, dst, weights):
    """p is the difference of the centroids, without R"""
    c, d = _middles(src, dst, weights)
    return _pose(_rotation(src, dst, weights), d - c)


def wrong_sign_of_p(src, dst, weights):
    """p has the wrong sign"""
    c, d = _middles(src, dst, weights)
    R = _rotation(src, dst, weights)
    return _pose(R, R @ c - d)


def wrong_p_by_rows(src, dst, weights):
    """p is made with R^T"""
    c, d = _middles(src, dst, weights)
    R = _rotation(src, dst, weights)
    return _pose(R, d - c @ R)


def wrong_p_of_the_other_way(src, dst, weights):
    """p is made with src and dst swapped"""
    c, d = _middles(src, dst, weights)
    R = _rotation(src, dst, weights)
    return _pose(R, c - R @ d)


def wrong_R_of_the_difference(src, dst, weights):
    """p is R times the difference"""
    c, d = _middles(src, dst, weights)
    R = _rotation(src, dst, weights)
    return _pose(R, R @ (d - c))


def wrong_middle_of_dst(src, dst, weights):
    """p is the centroid of dst alone"""
    c, d = _middles(src, dst, weights)
    return _pose(_rotation(src, dst, weights), d)


def wrong_only_shifted(src, dst, weights):
    """the rotation is left out"""
    c, d = _middles(src, dst, weights)
    return _pose(np.eye(3), d - c)


def wrong_with_a_scale(src, dst, weights):
    """a scale is fitted too"""
    c, d = _middles(src, dst, weights)
    U, S, Vt = np.linalg.svd((dst - d).T @ (weights[:, None] * (src - c)))
    signs = np.array([1, 1, np.linalg.det(U @ Vt)])
    scale = (S @ signs) / (weights @ ((src - c) ** 2).sum(1))
    R = scale * (U * signs) @ Vt
    return _pose(R, d - R @ c)


def wrong_linear_map(src, dst, weights):
    """any linear map is allowed"""
    c, d = _middles(src, dst, weights)
    root = np.sqrt(weights)[:, None]
    A = np.linalg.lstsq(root * (src - c), root * (dst - d), rcond=None)[0].T
    return _pose(A, d - A @ c)


def wrong_linear_map_mended(src, dst, weights):
    """the best linear map is turned into a rotation afterwards"""
    c, d = _middles(src, dst, weights)
    root = np.sqrt(weights)[:, None]
    R = nearest_so((np.linalg.pinv(root * (src - c)) @ (root * (dst - d))).T)
    return _pose(R, d - R @ c)


def wrong_frames_of_three_points(src, dst, weights):
    """only three of the points are used"""

    def frame(p):
        x = p[1] - p[0]
        z = np.cross(x, p[2] - p[0])
        y = np.cross(z, x)
        return np.array([v / np.linalg.norm(v) for v in (x, y, z)]).T

    R = frame(dst) @ frame(src).T
    return _pose(R, dst[0] - R @ src[0])


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


def wrong_whole_numbers(src, dst, weights):
    """digits after the point are cut off"""
    c, d = _middles(src, dst, weights)
    a, b = np.zeros_like(src), np.zeros_like(dst)
    for i in range(len(src)):
        a[i], b[i] = src[i] - c, dst[i] - d
    R = nearest_so((weights[:, None] * b).T @ a)
    return _pose(R, d - R @ c)


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
