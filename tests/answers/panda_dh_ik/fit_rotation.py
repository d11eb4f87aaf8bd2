"""What students write for fit_rotation(src, dst), after they have looked for the bug."""

import numpy as np
from scipy.spatial.transform import Rotation

from course_lib.registration import register_points


def right_sign_inside(src, dst):
    U, _, Vt = np.linalg.svd((dst - dst.mean(0)).T @ (src - src.mean(0)))
    return U @ np.diag([1, 1, np.linalg.det(U @ Vt)]) @ Vt


def right_from_the_other_product_as_lists(src, dst):
    V, _, Ut = np.linalg.svd((src - src.mean(0)).T @ (dst - dst.mean(0)))
    if np.linalg.det(V @ Ut) < 0:
        V[:, -1] *= -1
    return (Ut.T @ V.T).tolist()


def right_by_scipy(src, dst):
    return Rotation.align_vectors(dst - dst.mean(0), src - src.mean(0))[0].as_matrix()


def wrong_whole_pose(src, dst):
    """the whole pose"""
    return np.block([[right_sign_inside(src, dst), dst[:1].T], [np.zeros(3), 1]])


def wrong_column_of_Vt(src, dst):
    """unnamed"""
    U, _, Vt = np.linalg.svd((dst - dst.mean(0)).T @ (src - src.mean(0)))
    if np.linalg.det(U @ Vt) < 0:
        U[2] *= -1
        Vt[:, 1] *= -1
        U[:, 2] *= -1
    return U @ Vt


def wrong_library(src, dst):
    """course_lib.registration.register_points is called"""
    return register_points(src, dst)[:3, :3]
