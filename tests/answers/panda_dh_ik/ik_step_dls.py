"""What students write for ik_step_dls(q, J, e, eps)."""

import numpy as np

from course_lib import ik
from course_lib.arms import panda


def right_solved_for_the_errors(q, J, e, eps):
    return q + J.T @ np.linalg.solve(J @ J.T + eps * np.eye(len(e)), e)


def right_solved_for_the_joints(q, J, e, eps):
    return q + np.linalg.solve(J.T @ J + eps * np.eye(len(q)), J.T @ e)


def right_inverted_as_a_list(q, J, e, eps):
    n = J.shape[1]
    return list(q + np.linalg.inv(J.T @ J + eps * np.identity(n)) @ J.T @ e)


def right_inverted_as_a_column(q, J, e, eps):
    damped = J.T @ np.linalg.inv(J @ J.T + eps * np.eye(J.shape[0]))
    return q[:, None] + damped @ e[:, None]


def right_singular_values(q, J, e, eps):
    U, s, Vt = np.linalg.svd(J, full_matrices=False)
    return q + Vt.T @ np.diag(s / (s**2 + eps)) @ U.T @ e


def right_least_squares_and_wrapped(q, J, e, eps):
    n = len(q)
    A = np.vstack([J, np.sqrt(eps) * np.eye(n)])
    dq = np.linalg.lstsq(A, np.concatenate([e, np.zeros(n)]), rcond=None)[0]
    return (q + dq + np.pi) % (2 * np.pi) - np.pi


def right_cholesky_and_loops(q, J, e, eps):
    m, n = J.shape
    M = np.zeros((m, m))
    for i in range(m):
        for k in range(m):
            M[i, k] = sum(J[i, j] * J[k, j] for j in range(n)) + (eps if i == k else 0)
    L = np.linalg.cholesky(M)
    x = np.linalg.solve(L.T, np.linalg.solve(L, e))
    return tuple(q[j] + sum(J[i, j] * x[i] for i in range(m)) for j in range(n))


def right_diagonal_filled_in(q, J, e, eps):
    M = (J @ J.T).astype(float)
    M[np.diag_indices(len(M))] += eps
    return q + np.linalg.solve(M, J).T @ e


def wrong_eps_missing(q, J, e, eps):
    """Singular matrix"""
    return q + np.linalg.inv(J.T @ J) @ J.T @ e


def wrong_inverse_of_J(q, J, e, eps):
    """LinAlgError"""
    return q + np.linalg.inv(J) @ e


def wrong_eps_to_every_entry_and_solved(q, J, e, eps):
    """eps is added to every entry"""
    return q + np.linalg.pinv(J.T @ J + eps) @ J.T @ e


def wrong_size_of_the_unit_matrix(q, J, e, eps):
    """ValueError"""
    return q + J.T @ np.linalg.solve(J @ J.T + eps * np.eye(len(q)), e)


def wrong_unit_matrix_of_size_six(q, J, e, eps):
    """ValueError"""
    return q + J.T @ np.linalg.solve(J @ J.T + eps * np.eye(6), e)


def wrong_transpose_on_the_other_side(q, J, e, eps):
    """ValueError"""
    return q + np.linalg.solve(J @ J.T + eps * np.eye(len(e)), J.T @ e)


def wrong_transpose_missing(q, J, e, eps):
    """ValueError"""
    return q + J @ np.linalg.solve(J @ J.T + eps * np.eye(len(e)), e)


def wrong_inverted_entry_by_entry(q, J, e, eps):
    """divided by zero"""
    return q + (J.T @ J + eps * np.eye(len(q))) ** -1 @ J.T @ e


def wrong_sugiharas_damping(q, J, e, eps):
    """unnamed"""
    return q + J.T @ np.linalg.solve(J @ J.T + (eps * (e @ e) + 1e-12) * np.eye(len(e)), e)


def wrong_in_place(q, J, e, eps):
    """UFuncTypeError"""
    q += J.T @ np.linalg.solve(J @ J.T + eps * np.eye(len(e)), e)
    return q


def wrong_in_place_with_any_kind_of_numbers(q, J, e, eps):
    """q is changed in place"""
    q[:] = q + J.T @ np.linalg.solve(J @ J.T + eps * np.eye(len(e)), e)
    return q


def wrong_column_of_errors(q, J, e, eps):
    """differ in shape"""
    return q + J.T @ np.linalg.solve(J @ J.T + eps * np.eye(len(e)), e[:, None])


def wrong_library(q, J, e, eps):
    """course_lib.ik.damped_path is called"""
    return ik.damped_path(panda(), q, e[:3], 1.0, eps, 1)[-1]


def wrong_rounded(q, J, e, eps):
    """first digits only"""
    return np.round(q + J.T @ np.linalg.solve(J @ J.T + eps * np.eye(len(e)), e), 4)


def wrong_only_half_of_the_step(q, J, e, eps):
    """a wrong length"""
    return q + 0.5 * J.T @ np.linalg.solve(J @ J.T + eps * np.eye(len(e)), e)
