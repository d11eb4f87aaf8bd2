"""What students write for holding_torques(screws, M, q, mass, center)."""

import numpy as np

from course_lib.rigid import adjoint, exp_se3, inverse

G = 9.81


def _arm(screws, M, q):
    T, J = np.eye(4), []
    for S, angle in zip(screws, q):
        J.append(adjoint(T) @ S)
        T = T @ exp_se3(S * angle)
    return T @ M, np.array(J).T


def right_in_the_base_frame(screws, M, q, mass, center):
    T, J = _arm(screws, M, q)
    f = np.array([0, 0, -mass * G])
    p = T[:3, :3] @ center + T[:3, 3]
    return -J.T @ np.append(np.cross(p, f), f)


def right_in_the_tool_frame(screws, M, q, mass, center):
    T, J = _arm(screws, M, q)
    f = T[:3, :3].T @ [0, 0, -mass * G]
    F_b = np.append(np.cross(center, f), f)
    return (-(adjoint(inverse(T)) @ J).T @ F_b).tolist()


def right_power_joint_by_joint(screws, M, q, mass, center):
    T, J = _arm(screws, M, q)
    p = (T @ [*center, 1])[:3]
    return [mass * G * (column[3:] + np.cross(column[:3], p))[2] for column in J.T]


def wrong_pseudo_inverse(screws, M, q, mass, center):
    """an inverse of the Jacobian"""
    T, J = _arm(screws, M, q)
    f = np.array([0, 0, mass * G])
    p = (T @ [*center, 1])[:3]
    return np.linalg.pinv(J) @ np.append(np.cross(p, f), f)


def wrong_light_load_taken_for_none(screws, M, q, mass, center):
    """the answers to some inputs only are wrong"""
    return right_in_the_base_frame(screws, M, q, mass if mass > 1e-3 else 0.0, center)
