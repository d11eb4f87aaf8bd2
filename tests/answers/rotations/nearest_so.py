"""What students write for nearest_so(M)."""

import numpy as np
import scipy.linalg

from course_lib.rotations import nearest_so as ready_made


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


def right_sum_of_outer_products(M):
    n = M.shape[0]
    U, S, Vt = np.linalg.svd(M)
    sign = round(np.linalg.det(U) * np.linalg.det(Vt))
    R = np.zeros((n, n))
    for i in range(n):
        R += (sign if i == n - 1 else 1) * np.outer(U[:, i], Vt[i])
    return R


def right_by_the_largest_eigenvalue(M):
    if len(M) == 2:
        a = np.arctan2(M[1, 0] - M[0, 1], M[0, 0] + M[1, 1])
        return [[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]]
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = M
    K = [
        [xx + yy + zz, zy - yz, xz - zx, yx - xy],
        [zy - yz, xx - yy - zz, xy + yx, xz + zx],
        [xz - zx, xy + yx, yy - xx - zz, yz + zy],
        [yx - xy, xz + zx, yz + zy, zz - xx - yy],
    ]
    w, x, y, z = np.linalg.eigh(np.array(K))[1][:, 3]
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]


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


def wrong_two_signs_turned(M):
    """the answer is a reflection"""
    U, S, Vt = np.linalg.svd(M)
    if np.linalg.det(U @ Vt) < 0:
        U[:, -2:] *= -1
    return U @ Vt


def wrong_sign_of_a_negative_det_M(M):
    """the sign comes from det M"""
    U, S, Vt = np.linalg.svd(M)
    if np.linalg.det(M) < 0:
        U[:, -1] *= -1
    return U @ Vt


def wrong_sign_unless_det_M_is_positive(M):
    """the sign comes from det M"""
    U, S, Vt = np.linalg.svd(M)
    if np.linalg.det(M) <= 0:
        Vt[-1] = -Vt[-1]
    return U @ Vt


def wrong_det_M_in_place_of_its_sign(M):
    """the sign comes from det M"""
    U, S, Vt = np.linalg.svd(M)
    D = np.eye(len(M))
    D[-1, -1] = np.linalg.det(M)
    return U @ D @ Vt


def wrong_gram_schmidt(M):
    """Gram-Schmidt"""
    x = M[:, 0] / np.linalg.norm(M[:, 0])
    if len(M) == 2:
        return np.array([[x[0], -x[1]], [x[1], x[0]]])
    y = M[:, 1] - x * (x @ M[:, 1])
    y = y / np.linalg.norm(y)
    return np.column_stack([x, y, np.cross(x, y)])


def wrong_transposed(M):
    """the transpose is returned"""
    U, S, Vt = np.linalg.svd(M)
    D = np.eye(len(M))
    D[-1, -1] = np.linalg.det(U @ Vt)
    return (U @ D @ Vt).T


def wrong_singular_values_kept(M):
    """M is returned as it came"""
    U, S, Vt = np.linalg.svd(M)
    return U @ np.diag(S) @ Vt


def wrong_divided_by_determinant(M):
    """divided by zero"""
    return M / np.cbrt(np.linalg.det(M)) if len(M) == 3 else M / np.sqrt(abs(np.linalg.det(M)))


def wrong_space_only(M):
    """ValueError"""
    U, S, Vt = np.linalg.svd(M)
    return U @ np.diag([1, 1, np.linalg.det(U @ Vt)]) @ Vt


def wrong_all_three_returned(M):
    """another form"""
    U, S, Vt = np.linalg.svd(M)
    U[:, -1] *= np.linalg.det(U @ Vt)
    return U, S, Vt


def wrong_changed_in_place(M):
    """M is changed in place"""
    U, S, Vt = np.linalg.svd(M)
    U[:, -1] *= np.linalg.det(U @ Vt)
    M[:] = U @ Vt
    return M


def wrong_the_librarys(M):
    """course_lib.rotations.nearest_so is called"""
    return ready_made(M)


def wrong_both_corrections(M):
    """the answer is a reflection"""
    U, _, Vt = np.linalg.svd(M)
    if np.linalg.det(U @ Vt) < 0:
        U[:, -1] *= -1
        R = U @ Vt
        R[:, -1] *= -1
        return R
    return U @ Vt


def wrong_column_of_Vt(M):
    """unnamed"""
    U, _, Vt = np.linalg.svd(M)
    if np.linalg.det(U @ Vt) < 0:
        Vt[:, -1] *= -1
    return U @ Vt


def wrong_farthest_of_three(M):
    """the sign is put at the largest singular value"""
    U, _, Vt = np.linalg.svd(M)
    tries = []
    for k in range(len(M)):
        D = np.eye(len(M))
        D[k, k] = np.linalg.det(U @ Vt)
        tries.append(U @ D @ Vt)
    return max(tries, key=lambda R: np.linalg.norm(M - R))


def wrong_iteration_that_keeps_the_handedness(M):
    """U V^T is returned even if it is a reflection"""
    X = np.array(M)
    for _ in range(60):
        X = (X + np.linalg.inv(X).T) / 2
    return X


def wrong_determinant_of_a_rotation_by_division(M):
    """divided by zero"""
    n = len(M)
    d = np.linalg.det(M)
    return M / (abs(d) ** (1 / n)) * (1 if d > 0 else -1)


def wrong_nearest_by_the_angle_in_the_plane_only(M):
    """another form"""
    a = np.arctan2(M[1, 0] - M[0, 1], M[0, 0] + M[1, 1])
    return np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]])
