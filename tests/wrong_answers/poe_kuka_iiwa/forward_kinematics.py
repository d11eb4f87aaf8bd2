"""What students write for forward_kinematics(screws, M, theta)."""

from functools import reduce

import numpy as np
import scipy.linalg

from course_lib.arms import SerialArm
from course_lib.rigid import exp_se3, hat_se3, inverse


def right_loop(screws, M, theta):
    T = np.eye(4)
    for S, angle in zip(screws, theta):
        T = T @ exp_se3(S * angle)
    return T @ M


def right_from_the_hand_backwards_as_lists(screws, M, theta):
    T = M
    for i in range(len(theta) - 1, -1, -1):
        T = exp_se3(screws[i] * theta[i]) @ T
    return T.tolist()


def right_by_series_of_matrices(screws, M, theta):
    return reduce(np.matmul, [scipy.linalg.expm(hat_se3(S) * angle) for S, angle in zip(screws, theta)] + [M])


def right_with_the_hands_axes(screws, M, theta):
    T = np.array(M, dtype=float)
    for S, angle in zip(screws, theta):
        B = inverse(M) @ hat_se3(S) @ M
        T @= np.eye(4) + np.sin(angle) * B + (1 - np.cos(angle)) * B @ B
    return T


def right_points_and_rotations_apart(screws, M, theta):
    R, p = M[:3, :3], M[:3, 3]
    for S, angle in list(zip(screws, theta))[::-1]:
        w, v = S[:3], S[3:]
        q = np.cross(w, v)
        turn = lambda x: np.cos(angle) * x + np.sin(angle) * np.cross(w, x) + (1 - np.cos(angle)) * (w @ x) * w
        R, p = np.column_stack([turn(column) for column in R.T]), q + turn(p - q)
    return [[*R[0], p[0]], [*R[1], p[1]], [*R[2], p[2]], [0, 0, 0, 1]]


def right_pops_from_a_list_of_its_own(screws, M, theta):
    axes, angles, T = list(screws), list(theta % (2 * np.pi)), M
    while axes:
        T = exp_se3(axes.pop() * angles.pop()) @ T
    return T


def wrong_M_changed(screws, M, theta):
    """M is changed in place"""
    for S, angle in zip(screws[::-1], theta[::-1]):
        M[:] = exp_se3(S * angle) @ M
    return M


def wrong_screws_changed(screws, M, theta):
    """UFuncTypeError"""
    T = np.eye(4)
    for i in range(len(theta)):
        screws[i] *= theta[i]
        T = T @ exp_se3(screws[i])
    return T @ M


def wrong_position_only(screws, M, theta):
    """only a part of the pose"""
    return right_loop(screws, M, theta)[:3, 3]


def wrong_one_matrix_a_joint(screws, M, theta):
    """a matrix for each joint"""
    return [exp_se3(S * angle) @ M for S, angle in zip(screws, theta)]


def wrong_list_shared_by_all_calls(screws, M, theta, turns=[]):
    """something is kept from one call to the next"""
    for S, angle in zip(screws, theta):
        turns.append(exp_se3(S * angle))
    return reduce(np.matmul, turns) @ M


class _Arm:
    axes = [np.array([0, 0, 1.0, 0, 0, 0])] * 7


def wrong_pops_from_a_list_of_the_class(screws, M, theta):
    """IndexError"""
    T = M
    for angle in theta[::-1]:
        T = exp_se3(_Arm.axes.pop(-1) * angle) @ T
    return T


def wrong_pops_from_an_array(screws, M, theta):
    """AttributeError"""
    T = M
    for angle in theta[::-1]:
        T = exp_se3(screws.pop() * angle) @ T
    return T


def wrong_joints_out_of_order(screws, M, theta):
    """unnamed"""
    T = np.eye(4)
    for i in [*range(0, len(theta), 2), *range(1, len(theta), 2)]:
        T = T @ exp_se3(screws[i] * theta[i])
    return T @ M


def wrong_rounded(screws, M, theta):
    """first digits only"""
    return np.round(right_loop(screws, M, theta), 6)


def wrong_one_joint_too_many(screws, M, theta):
    """IndexError"""
    T = np.eye(4)
    for i in range(len(theta)):
        T = T @ exp_se3(screws[i + 1] * theta[i])
    return T @ M


def wrong_the_librarys(screws, M, theta):
    """course_lib.arms.SerialArm is called"""
    return SerialArm(screws, np.stack([M] * (len(screws) + 1)), None).fk(theta)
