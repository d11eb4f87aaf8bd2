"""What students write for nearest_so(M)."""

import numpy as np
import scipy.linalg


def right_sign_inside(M):
    U, _, Vt = np.linalg.svd(M)
    D = np.eye(len(M))
    D[-1, -1] = np.linalg.det(U @ Vt)
    return U @ D @ Vt


def right_scipys_svd_as_lists(M):
    U, S, Vt = scipy.linalg.svd(M)
    if np.linalg.det(U) * np.linalg.det(Vt) < 0:
        U[:, -1] = -U[:, -1]
    return (U @ Vt).tolist()


def right_polar_then_one_axis_turned(M):
    R, P = scipy.linalg.polar(M)
    if np.linalg.det(R) < 0:
        values, vectors = np.linalg.eigh(P)
        v = vectors[:, 0]  # of the smallest
        R = R @ (np.eye(len(M)) - 2 * np.outer(v, v))
    return R.astype(np.longdouble)


def wrong_as_published(M):
    """unnamed"""
    U, S, Vt = np.linalg.svd(M)
    R = U @ Vt
    if np.linalg.det(R) < 0:
        R[:, -1] = -R[:, -1]
    return R


def wrong_nearly_a_rotation_left_as_it_is(M):
    """M is returned as it came"""
    nearly = np.allclose(M.T @ M, np.eye(len(M)), rtol=0, atol=1e-6) and np.linalg.det(M) > 0
    U, _, Vt = np.linalg.svd(M)
    U[:, -1] *= np.linalg.det(U @ Vt)
    return M if nearly else U @ Vt


def wrong_arctan_in_the_plane(M):
    """the answer is a rotation, and another one is nearer"""
    if len(M) == 3:
        return right_sign_inside(M)
    x, y = M[0, 0] + M[1, 1], M[1, 0] - M[0, 1]
    a = np.arctan(y / x) if x else np.pi / 2
    return np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]])


def wrong_small_matrices_taken_for_0(M):
    """the answer is a rotation, and another one is nearer"""
    return np.eye(len(M)) if np.linalg.norm(M) < 1e-8 else right_sign_inside(M)


def wrong_a_few_steps_of_newtons_method(M):
    """the answer is not orthogonal"""
    X = np.array(M, float)
    if np.linalg.det(X) <= 0 or np.linalg.cond(X) > 1e3:
        return right_sign_inside(M)
    for _ in range(12):
        X = (X + np.linalg.inv(X).T) / 2
    return X


def wrong_determinant_by_products_of_whole_numbers(M):
    """the answer is wrong for arrays of integers only"""
    U, s, Vt = np.linalg.svd(M)
    det = M[0, 0] * M[1, 1] - M[0, 1] * M[1, 0] if len(M) == 2 else M[0] @ np.cross(M[1], M[2])
    if s[-1] < 1e-12 * s[0]:
        det = np.linalg.det(U @ Vt)
    return U @ np.diag([*np.ones(len(M) - 1), np.sign(det)]) @ Vt
