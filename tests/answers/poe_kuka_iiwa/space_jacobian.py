"""What students write for space_jacobian(screws, q)."""

import numpy as np

from course_lib.arms import SerialArm
from course_lib.rigid import adjoint, exp_se3, hat_se3, inverse
from course_lib.rotations import exp_so3, hat


def right_column_by_column(screws, q):
    T, columns = np.eye(4), []
    for S, angle in zip(screws, q):
        columns.append(adjoint(T) @ S)
        T = T @ exp_se3(S * angle)
    return np.column_stack(columns)


def right_with_its_own_exponential_as_lists(screws, q):
    J, T = np.zeros((6, len(q))), np.eye(4)
    for i in range(len(q)):
        T = T @ exp_se3(screws[i] * q[i])
        J[:, i] = adjoint(T) @ screws[i]
    return J.tolist()


def right_by_conjugation(screws, q):
    T, J = np.eye(4), []
    for S, angle in zip(screws, q):
        V = T @ hat_se3(S) @ np.linalg.inv(T)
        J.append((V[2, 1], V[0, 2], V[1, 0], *V[:3, 3]))
        T = T @ exp_se3(S * angle)
    return list(zip(*J))


def right_points_and_directions(screws, q):
    omega, points = screws[:, :3].astype(float), np.cross(screws[:, :3], screws[:, 3:]).astype(float)
    for i in range(len(q)):
        R = exp_so3(omega[i] * q[i])
        omega[i + 1 :] = omega[i + 1 :] @ R.T
        points[i + 1 :] = points[i] + (points[i + 1 :] - points[i]) @ R.T
    return np.vstack([omega.T, np.cross(points, omega).T])


def right_from_the_last_joint_backwards(screws, q):
    J = np.zeros((6, 0))
    for S, angle in zip(screws[::-1], q[::-1]):
        J = np.column_stack([S, adjoint(exp_se3(S * angle)) @ J])
    return J


def right_derivative_by_complex_numbers(screws, q):
    """exp([S] q) by Rodrigues' formula, with an imaginary step in one angle."""

    def product(angles):
        T = np.eye(4, dtype=complex)
        for S, angle in zip(screws, angles):
            H = hat_se3(S)
            T = T @ (np.eye(4) + np.sin(angle) * H + (1 - np.cos(angle)) * H @ H)
        return T

    J = np.zeros((6, len(q)))
    T = product(q)
    for i in range(len(q)):
        step = np.zeros(len(q), dtype=complex)
        step[i] = 1e-30j
        V = (product(q + step).imag / 1e-30) @ np.linalg.inv(T).real
        J[:, i] = V[2, 1], V[0, 2], V[1, 0], V[0, 3], V[1, 3], V[2, 3]
    return J


def _with_adjoint(ad):
    def jacobian(screws, q):
        T, columns = np.eye(4), []
        for S, angle in zip(screws, q):
            columns.append(ad(T) @ S)
            T = T @ exp_se3(S * angle)
        return np.column_stack(columns)

    return jacobian


def wrong_joints_behind(screws, q):
    """by the joints behind it"""
    columns, T = [], np.eye(4)
    for S, angle in list(zip(screws, q))[::-1]:
        columns.insert(0, adjoint(T) @ S)
        T = exp_se3(S * angle) @ T
    return np.array(columns).T


def wrong_transposed(screws, q):
    """rows and columns are swapped"""
    T, rows = np.eye(4), []
    for S, angle in zip(screws, q):
        rows.append(adjoint(T) @ S)
        T = T @ exp_se3(S * angle)
    return np.array(rows)


def wrong_last_column_only(screws, q):
    """only one column is returned"""
    T = np.eye(4)
    for S, angle in zip(screws, q):
        J = adjoint(T) @ S
        T = T @ exp_se3(S * angle)
    return J


def wrong_screws_changed(screws, q):
    """screws is changed in place"""
    T = np.eye(4)
    for i in range(len(q)):
        turn = exp_se3(screws[i] * q[i])
        screws[i] = adjoint(T) @ screws[i]
        T = T @ turn
    return screws.T


def wrong_columns_kept_between_calls(screws, q, columns=[]):
    """another form"""
    T = np.eye(4)
    for S, angle in zip(screws, q):
        columns.append(adjoint(T) @ S)
        T = T @ exp_se3(S * angle)
    return np.column_stack(columns)


def wrong_columns_backwards(screws, q):
    """unnamed"""
    return right_column_by_column(screws, q)[:, ::-1]


def wrong_coarse_difference(screws, q):
    """first digits only"""

    def product(angles):
        T = np.eye(4)
        for S, angle in zip(screws, angles):
            T = T @ exp_se3(S * angle)
        return T

    J = np.zeros((6, len(q)))
    for i, step in enumerate(1e-3 * np.eye(len(q))):
        V = (product(q + step) - product(q)) / 1e-3 @ inverse(product(q))
        J[:, i] = V[2, 1], V[0, 2], V[1, 0], V[0, 3], V[1, 3], V[2, 3]
    return J


def wrong_the_librarys(screws, q):
    """course_lib.arms.SerialArm is called"""
    return SerialArm(screws, np.eye(4)[None], None).space_jacobian(q)
