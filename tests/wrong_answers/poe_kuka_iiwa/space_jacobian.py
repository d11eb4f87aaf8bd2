"""What students write for space_jacobian(screws, theta)."""

import numpy as np

from course_lib.arms import SerialArm
from course_lib.rigid import adjoint, exp_se3, hat_se3, inverse
from course_lib.rotations import exp_so3, hat


def right_column_by_column(screws, theta):
    T, columns = np.eye(4), []
    for S, angle in zip(screws, theta):
        columns.append(adjoint(T) @ S)
        T = T @ exp_se3(S * angle)
    return np.column_stack(columns)


def right_with_its_own_exponential_as_lists(screws, theta):
    J, T = np.zeros((6, len(theta))), np.eye(4)
    for i in range(len(theta)):
        T = T @ exp_se3(screws[i] * theta[i])
        J[:, i] = adjoint(T) @ screws[i]
    return J.tolist()


def right_by_conjugation(screws, theta):
    T, J = np.eye(4), []
    for S, angle in zip(screws, theta):
        V = T @ hat_se3(S) @ np.linalg.inv(T)
        J.append((V[2, 1], V[0, 2], V[1, 0], *V[:3, 3]))
        T = T @ exp_se3(S * angle)
    return list(zip(*J))


def right_points_and_directions(screws, theta):
    omega, points = screws[:, :3].astype(float), np.cross(screws[:, :3], screws[:, 3:]).astype(float)
    for i in range(len(theta)):
        R = exp_so3(omega[i] * theta[i])
        omega[i + 1 :] = omega[i + 1 :] @ R.T
        points[i + 1 :] = points[i] + (points[i + 1 :] - points[i]) @ R.T
    return np.vstack([omega.T, np.cross(points, omega).T])


def right_from_the_last_joint_backwards(screws, theta):
    J = np.zeros((6, 0))
    for S, angle in zip(screws[::-1], theta[::-1]):
        J = np.column_stack([S, adjoint(exp_se3(S * angle)) @ J])
    return J


def right_derivative_by_complex_numbers(screws, theta):
    """exp([S] theta) by Rodrigues' formula, with an imaginary step in one angle."""

    def product(angles):
        T = np.eye(4, dtype=complex)
        for S, angle in zip(screws, angles):
            H = hat_se3(S)
            T = T @ (np.eye(4) + np.sin(angle) * H + (1 - np.cos(angle)) * H @ H)
        return T

    J = np.zeros((6, len(theta)))
    T = product(theta)
    for i in range(len(theta)):
        step = np.zeros(len(theta), dtype=complex)
        step[i] = 1e-30j
        V = (product(theta + step).imag / 1e-30) @ np.linalg.inv(T).real
        J[:, i] = V[2, 1], V[0, 2], V[1, 0], V[0, 3], V[1, 3], V[2, 3]
    return J


def _with_adjoint(ad):
    def jacobian(screws, theta):
        T, columns = np.eye(4), []
        for S, angle in zip(screws, theta):
            columns.append(ad(T) @ S)
            T = T @ exp_se3(S * angle)
        return np.column_stack(columns)

    return jacobian


def wrong_joints_behind(screws, theta):
    """by the joints behind it"""
    columns, T = [], np.eye(4)
    for S, angle in list(zip(screws, theta))[::-1]:
        columns.insert(0, adjoint(T) @ S)
        T = exp_se3(S * angle) @ T
    return np.array(columns).T


def wrong_transposed(screws, theta):
    """rows and columns are swapped"""
    T, rows = np.eye(4), []
    for S, angle in zip(screws, theta):
        rows.append(adjoint(T) @ S)
        T = T @ exp_se3(S * angle)
    return np.array(rows)


def wrong_last_column_only(screws, theta):
    """only one column is returned"""
    T = np.eye(4)
    for S, angle in zip(screws, theta):
        J = adjoint(T) @ S
        T = T @ exp_se3(S * angle)
    return J


def wrong_screws_changed(screws, theta):
    """screws is changed in place"""
    T = np.eye(4)
    for i in range(len(theta)):
        turn = exp_se3(screws[i] * theta[i])
        screws[i] = adjoint(T) @ screws[i]
        T = T @ turn
    return screws.T


def wrong_columns_kept_between_calls(screws, theta, columns=[]):
    """another form"""
    T = np.eye(4)
    for S, angle in zip(screws, theta):
        columns.append(adjoint(T) @ S)
        T = T @ exp_se3(S * angle)
    return np.column_stack(columns)


def wrong_columns_backwards(screws, theta):
    """unnamed"""
    return right_column_by_column(screws, theta)[:, ::-1]


def wrong_coarse_difference(screws, theta):
    """first digits only"""

    def product(angles):
        T = np.eye(4)
        for S, angle in zip(screws, angles):
            T = T @ exp_se3(S * angle)
        return T

    J = np.zeros((6, len(theta)))
    for i, step in enumerate(1e-3 * np.eye(len(theta))):
        V = (product(theta + step) - product(theta)) / 1e-3 @ inverse(product(theta))
        J[:, i] = V[2, 1], V[0, 2], V[1, 0], V[0, 3], V[1, 3], V[2, 3]
    return J


def wrong_the_librarys(screws, theta):
    """course_lib.arms.SerialArm is called"""
    return SerialArm(screws, np.eye(4)[None], None).space_jacobian(theta)
