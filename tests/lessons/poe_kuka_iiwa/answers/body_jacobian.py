"""What students write for body_jacobian(screws, M, q)."""

import numpy as np

from course_lib.rigid import adjoint, exp_se3, hat_se3, inverse


def _space(screws, q):
    T, columns = np.eye(4), []
    for S, angle in zip(screws, q):
        columns.append(adjoint(T) @ S)
        T = T @ exp_se3(S * angle)
    return np.column_stack(columns), T


def right_from_the_space_jacobian(screws, M, q):
    J, T = _space(screws, q)
    return adjoint(inverse(T @ M)) @ J


def right_from_the_hand_backwards(screws, M, q):
    T, columns = inverse(M), []
    for S, angle in list(zip(screws, q))[::-1]:
        columns.insert(0, adjoint(T) @ S)
        T = T @ exp_se3(-S * angle)
    return np.column_stack(columns)


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


def wrong_one_joint_ahead(screws, M, q):
    """the last column is not B_n"""
    return np.roll(right_from_the_space_jacobian(screws, M, q), 1, axis=0)
