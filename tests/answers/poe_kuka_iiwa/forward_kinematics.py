"""What students write for forward_kinematics(screws, M, q)."""

from functools import reduce

import numpy as np
import scipy.linalg

from course_lib.arms import SerialArm
from course_lib.rigid import exp_se3, hat_se3, inverse


def right_loop(screws, M, q):
    T = np.eye(4)
    for S, angle in zip(screws, q):
        T = T @ exp_se3(S * angle)
    return T @ M


def right_from_the_hand_backwards_as_lists(screws, M, q):
    T = M
    for i in range(len(q) - 1, -1, -1):
        T = exp_se3(screws[i] * q[i]) @ T
    return T.tolist()


def right_by_series_of_matrices(screws, M, q):
    return reduce(np.matmul, [scipy.linalg.expm(hat_se3(S) * angle) for S, angle in zip(screws, q)] + [M])


def right_with_the_hands_axes(screws, M, q):
    T = np.array(M, dtype=float)
    for S, angle in zip(screws, q):
        B = inverse(M) @ hat_se3(S) @ M
        T @= np.eye(4) + np.sin(angle) * B + (1 - np.cos(angle)) * B @ B
    return T


def right_points_and_rotations_apart(screws, M, q):
    R, p = M[:3, :3], M[:3, 3]
    for S, angle in list(zip(screws, q))[::-1]:
        w, v = S[:3], S[3:]
        q = np.cross(w, v)
        turn = lambda x: np.cos(angle) * x + np.sin(angle) * np.cross(w, x) + (1 - np.cos(angle)) * (w @ x) * w
        R, p = np.column_stack([turn(column) for column in R.T]), q + turn(p - q)
    return [[*R[0], p[0]], [*R[1], p[1]], [*R[2], p[2]], [0, 0, 0, 1]]


def right_pops_from_a_list_of_its_own(screws, M, q):
    axes, angles, T = list(screws), list(q % (2 * np.pi)), M
    while axes:
        T = exp_se3(axes.pop() * angles.pop()) @ T
    return T


def wrong_M_changed(screws, M, q):
    """M is changed in place"""
    for S, angle in zip(screws[::-1], q[::-1]):
        M[:] = exp_se3(S * angle) @ M
    return M


def wrong_screws_changed(screws, M, q):
    """UFuncTypeError"""
    T = np.eye(4)
    for i in range(len(q)):
        screws[i] *= q[i]
        T = T @ exp_se3(screws[i])
    return T @ M


def wrong_position_only(screws, M, q):
    """only a part of the pose"""
    return right_loop(screws, M, q)[:3, 3]


def wrong_one_matrix_a_joint(screws, M, q):
    """a matrix for each joint"""
    return [exp_se3(S * angle) @ M for S, angle in zip(screws, q)]


def wrong_list_shared_by_all_calls(screws, M, q, turns=[]):
    """something is kept from one call to the next"""
    for S, angle in zip(screws, q):
        turns.append(exp_se3(S * angle))
    return reduce(np.matmul, turns) @ M


def wrong_pops_from_an_array(screws, M, q):
    """AttributeError"""
    T = M
    for angle in q[::-1]:
        T = exp_se3(screws.pop() * angle) @ T
    return T


def wrong_joints_out_of_order(screws, M, q):
    """unnamed"""
    T = np.eye(4)
    for i in [*range(0, len(q), 2), *range(1, len(q), 2)]:
        T = T @ exp_se3(screws[i] * q[i])
    return T @ M


def wrong_rounded(screws, M, q):
    """first digits only"""
    return np.round(right_loop(screws, M, q), 6)


def wrong_one_joint_too_many(screws, M, q):
    """IndexError"""
    T = np.eye(4)
    for i in range(len(q)):
        T = T @ exp_se3(screws[i + 1] * q[i])
    return T @ M


def wrong_the_librarys(screws, M, q):
    """course_lib.arms.SerialArm is called"""
    return SerialArm(screws, np.stack([M] * (len(screws) + 1)), None).fk(q)
