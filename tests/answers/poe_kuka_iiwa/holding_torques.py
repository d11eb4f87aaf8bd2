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


def right_by_the_adjoint_s_transpose(screws, M, q, mass, center):
    T, J = _arm(screws, M, q)
    at_load = np.eye(4)
    at_load[:3, 3] = (T @ [*center, 1])[:3]
    F = adjoint(inverse(at_load)).T @ [0, 0, 0, 0, 0, mass * G]
    return J.T @ F


def right_power_joint_by_joint(screws, M, q, mass, center):
    T, J = _arm(screws, M, q)
    p = (T @ [*center, 1])[:3]
    return [mass * G * (column[3:] + np.cross(column[:3], p))[2] for column in J.T]


def wrong_sign(screws, M, q, mass, center):
    """their sign changed"""
    T, J = _arm(screws, M, q)
    f = np.array([0, 0, -mass * G])
    p = T[:3, :3] @ center + T[:3, 3]
    return J.T @ np.append(np.cross(p, f), f)


def wrong_center_ignored(screws, M, q, mass, center):
    """the weight acts at the end-effector's origin"""
    T, J = _arm(screws, M, q)
    f = np.array([0, 0, mass * G])
    return J.T @ np.append(np.cross(T[:3, 3], f), f)


def wrong_center_in_the_base_frame(screws, M, q, mass, center):
    """taken for a position in the base frame"""
    _, J = _arm(screws, M, q)
    f = np.array([0, 0, mass * G])
    return J.T @ np.append(np.cross(center, f), f)


def wrong_center_added(screws, M, q, mass, center):
    """without rotating it"""
    T, J = _arm(screws, M, q)
    f = np.array([0, 0, mass * G])
    return J.T @ np.append(np.cross(T[:3, 3] + center, f), f)


def wrong_moment_forgotten(screws, M, q, mass, center):
    """the moment of the weight is left out"""
    _, J = _arm(screws, M, q)
    return J.T @ [0, 0, 0, 0, 0, mass * G]


def wrong_force_first(screws, M, q, mass, center):
    """the force stands before the moment"""
    T, J = _arm(screws, M, q)
    f = np.array([0, 0, mass * G])
    p = (T @ [*center, 1])[:3]
    return J.T @ np.append(f, np.cross(p, f))


def wrong_mass_for_weight(screws, M, q, mass, center):
    """gravity is missing"""
    return np.array(right_in_the_base_frame(screws, M, q, mass, center)) / G


def wrong_body_jacobian_with_a_space_wrench(screws, M, q, mass, center):
    """the body Jacobian"""
    T, J = _arm(screws, M, q)
    f = np.array([0, 0, mass * G])
    p = (T @ [*center, 1])[:3]
    return (adjoint(inverse(T)) @ J).T @ np.append(np.cross(p, f), f)


def wrong_gravity_along_the_tool(screws, M, q, mass, center):
    """along the end-effector's z axis"""
    T, J = _arm(screws, M, q)
    f = np.array([0, 0, mass * G])
    return (adjoint(inverse(T)) @ J).T @ np.append(np.cross(center, f), f)


def wrong_pseudo_inverse(screws, M, q, mass, center):
    """unnamed"""
    T, J = _arm(screws, M, q)
    f = np.array([0, 0, mass * G])
    p = (T @ [*center, 1])[:3]
    return np.linalg.pinv(J) @ np.append(np.cross(p, f), f)


def wrong_times_the_angles(screws, M, q, mass, center):
    """multiplied by the angles"""
    return np.array(right_in_the_base_frame(screws, M, q, mass, center)) * q


def wrong_wrench(screws, M, q, mass, center):
    """a wrench is returned"""
    T, _ = _arm(screws, M, q)
    f = np.array([0, 0, mass * G])
    return np.append(np.cross((T @ [*center, 1])[:3], f), f)


def wrong_axes_at_home(screws, M, q, mass, center):
    """the screw axes are left as they are at home"""
    T, _ = _arm(screws, M, q)
    f = np.array([0, 0, mass * G])
    return screws @ np.append(np.cross((T @ [*center, 1])[:3], f), f)
