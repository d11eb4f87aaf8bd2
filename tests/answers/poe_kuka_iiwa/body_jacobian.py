"""What students write for body_jacobian(screws, M, q)."""

import numpy as np
import scipy.linalg

from course_lib.arms import SerialArm
from course_lib.rigid import adjoint, exp_se3, hat_se3, inverse
from course_lib.rotations import hat


def _space(screws, q, ad=adjoint):
    T, columns = np.eye(4), []
    for S, angle in zip(screws, q):
        columns.append(ad(T) @ S)
        T = T @ exp_se3(S * angle)
    return np.column_stack(columns), T


def right_from_the_space_jacobian(screws, M, q):
    J, T = _space(screws, q)
    return adjoint(inverse(T @ M)) @ J


def right_solved_as_lists(screws, M, q):
    J, T = _space(screws, q)
    return np.linalg.solve(adjoint(T @ M), J).tolist()


def right_from_the_hand_backwards(screws, M, q):
    T, columns = inverse(M), []
    for S, angle in list(zip(screws, q))[::-1]:
        columns.insert(0, adjoint(T) @ S)
        T = T @ exp_se3(-S * angle)
    return np.column_stack(columns)


def right_with_the_hands_axes(screws, M, q):
    B = [adjoint(inverse(M)) @ S for S in screws]
    J = np.zeros((6, len(B)))
    for i in range(len(B)):
        J[:, i] = B[i]
        for k in range(i + 1, len(B)):
            J[:, i] = scipy.linalg.inv(adjoint(exp_se3(B[k] * q[k]))) @ J[:, i]
    return J


def right_by_directions_and_points(screws, M, q):
    J, T = _space(screws, q)
    R, p = (T @ M)[:3, :3], (T @ M)[:3, 3]
    omega = [R.T @ column[:3] for column in J.T]
    v = [R.T @ (column[3:] + np.cross(column[:3], p)) for column in J.T]
    return np.vstack([np.transpose(omega), np.transpose(v)])


def right_by_conjugation(screws, M, q):
    turns = [exp_se3(S * angle) for S, angle in zip(screws, q)]
    columns = []
    for i, S in enumerate(screws):
        after = M
        for turn in turns[i + 1 :][::-1]:
            after = turn @ after
        V = np.linalg.inv(after) @ hat_se3(S) @ after
        columns.append([V[2, 1], V[0, 2], V[1, 0], V[0, 3], V[1, 3], V[2, 3]])
    return [list(row) for row in zip(*columns)]


def wrong_transposed(screws, M, q):
    """rows and columns are swapped"""
    J, T = _space(screws, q)
    return [adjoint(inverse(T @ M)) @ column for column in J.T]


def wrong_only_rotated(screws, M, q):
    """only rotated"""
    J, T = _space(screws, q)
    R = (T @ M)[:3, :3]
    return np.vstack([R.T @ J[:3], R.T @ J[3:]])


def wrong_adjoint_transposed(screws, M, q):
    """transposed where it is to be inverted"""
    J, T = _space(screws, q)
    return adjoint(T @ M).T @ J


def _reports_adjoint(T):
    R, p = T[:3, :3], T[:3, 3]
    return np.block([[R.T, np.zeros((3, 3))], [hat(p) @ R, R]])


def wrong_reports_adjoint(screws, M, q):
    """the upper left block of the adjoint is R^-1"""
    J, T = _space(screws, q, _reports_adjoint)
    return _reports_adjoint(inverse(T @ M)) @ J


def wrong_M_changed(screws, M, q):
    """M is changed in place"""
    J, T = _space(screws, q)
    M[:] = T @ M
    return adjoint(inverse(M)) @ J


def wrong_matrix_inverse_of_the_jacobian(screws, M, q):
    """LinAlgError"""
    J, T = _space(screws, q)
    return np.linalg.inv(J) @ adjoint(T @ M)


def wrong_columns_backwards(screws, M, q):
    """the columns stand in the reverse order"""
    return right_from_the_space_jacobian(screws, M, q)[:, ::-1]


def wrong_the_librarys(screws, M, q):
    """course_lib.arms.SerialArm is called"""
    return SerialArm(screws, np.stack([M] * (len(screws) + 1)), None).body_jacobian(q)
