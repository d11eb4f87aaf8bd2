"""What students write for fit_rotation(src, dst), after they have looked for the bug."""

import numpy as np
from scipy.spatial.transform import Rotation

from course_lib.registration import register_points


def centred(src, dst):
    return src - src.mean(0), dst - dst.mean(0)


def right_sign_inside(src, dst):
    a, b = centred(src, dst)
    U, _, Vt = np.linalg.svd(b.T @ a)
    return U @ np.diag([1, 1, np.linalg.det(U @ Vt)]) @ Vt


def right_last_column_of_U(src, dst):
    a, b = centred(src, dst)
    U, _, Vt = np.linalg.svd(b.T @ a)
    if np.linalg.det(U @ Vt) < 0:
        U[:, -1] *= -1
    return (U @ Vt).tolist()


def right_by_scipy(src, dst):
    return Rotation.align_vectors(*centred(dst, src))[0].as_matrix()


def right_from_the_other_product(src, dst):
    a, b = centred(src, dst)
    V, _, Ut = np.linalg.svd(a.T @ b)
    signs = np.array([1, 1, np.sign(np.linalg.det(V @ Ut))])
    return Ut.T * signs @ V.T


def wrong_test_removed(src, dst):
    """a reflection"""
    a, b = centred(src, dst)
    U, _, Vt = np.linalg.svd(b.T @ a)
    return U @ Vt


def wrong_all_of_it_negated(src, dst):
    """the finished product is changed"""
    a, b = centred(src, dst)
    U, _, Vt = np.linalg.svd(b.T @ a)
    R = U @ Vt
    return R * np.sign(np.linalg.det(R))


def wrong_another_column(src, dst):
    """the finished product is changed"""
    a, b = centred(src, dst)
    U, _, Vt = np.linalg.svd(b.T @ a)
    R = U @ Vt
    if np.linalg.det(R) < 0:
        R[:, 0] *= -1
    return R


def wrong_a_row(src, dst):
    """the finished product is changed"""
    a, b = centred(src, dst)
    U, _, Vt = np.linalg.svd(b.T @ a)
    R = U @ Vt
    if np.linalg.det(R) < 0:
        R[2] *= -1
    return R


def wrong_first_column_of_U(src, dst):
    """another singular value than the smallest"""
    a, b = centred(src, dst)
    U, _, Vt = np.linalg.svd(b.T @ a)
    if np.linalg.det(U @ Vt) < 0:
        U[:, 0] *= -1
    return U @ Vt


def wrong_column_of_Vt(src, dst):
    """unnamed"""
    a, b = centred(src, dst)
    U, _, Vt = np.linalg.svd(b.T @ a)
    if np.linalg.det(U @ Vt) < 0:
        Vt[:, 2] *= -1
    return U @ Vt


def wrong_sign_always(src, dst):
    """the sign is always changed"""
    a, b = centred(src, dst)
    U, _, Vt = np.linalg.svd(b.T @ a)
    U[:, 2] *= -1
    return U @ Vt


def wrong_way_round(src, dst):
    """from dst to src"""
    return right_sign_inside(dst, src)


def wrong_not_centred(src, dst):
    """the centroids are not subtracted"""
    U, _, Vt = np.linalg.svd(dst.T @ src)
    return U @ np.diag([1, 1, np.linalg.det(U @ Vt)]) @ Vt


def wrong_identity_for_reflections(src, dst):
    """the identity stands for it"""
    R = wrong_test_removed(src, dst)
    return R if np.linalg.det(R) > 0 else np.eye(3)


def wrong_library(src, dst):
    """course_lib.registration.register_points is called"""
    return register_points(src, dst)[:3, :3]


def wrong_whole_pose(src, dst):
    """the whole pose"""
    T = np.eye(4)
    T[:3, :3] = right_sign_inside(src, dst)
    return T


def wrong_vectors_transposed(src, dst):
    """unnamed"""
    a, b = centred(src, dst)
    U, _, Vt = np.linalg.svd(b.T @ a)
    return U @ np.diag([1, 1, np.linalg.det(U @ Vt)]) @ Vt.T
