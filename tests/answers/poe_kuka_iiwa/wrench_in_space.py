"""What students write for wrench_in_space(F_b, T)."""

import numpy as np

from course_lib.rigid import adjoint, inverse


def right_by_the_adjoint(F_b, T):
    return adjoint(inverse(T)).T @ F_b


def right_by_hand(F_b, T):
    R, p = T[:3, :3], T[:3, 3]
    f = R @ F_b[3:]
    return np.append(R @ F_b[:3] + np.cross(p, f), f)


def right_solved_as_list(F_b, T):
    return np.linalg.solve(adjoint(T).T, F_b).tolist()


def right_by_power(F_b, T):
    return [F_b @ (adjoint(inverse(T)) @ V_s) for V_s in np.eye(6)]


def wrong_as_a_twist(F_b, T):
    """as if it were a twist"""
    return adjoint(T) @ F_b


def wrong_transpose_of_AdT(F_b, T):
    """takes wrenches from s to b"""
    return adjoint(T).T @ F_b


def wrong_inverse_without_transpose(F_b, T):
    """as if it were a twist"""
    return adjoint(inverse(T)) @ F_b


def wrong_rotated_only(F_b, T):
    """the moment of the force about the base's origin is left out"""
    R = T[:3, :3]
    return np.concatenate([R @ F_b[:3], R @ F_b[3:]])


def wrong_force_first(F_b, T):
    """F_b is taken for (f, m)"""
    R, p = T[:3, :3], T[:3, 3]
    f, m = F_b[:3], F_b[3:]
    return np.append(R @ m + np.cross(p, R @ f), R @ f)


def wrong_cross_product_reversed(F_b, T):
    """the moment of the force has its sign changed"""
    R, p = T[:3, :3], T[:3, 3]
    m, f = R @ F_b[:3], R @ F_b[3:]
    return np.append(m + np.cross(f, p), f)


def wrong_p_crossed_before_rotating(F_b, T):
    """p and f are of two frames"""
    R, p = T[:3, :3], T[:3, 3]
    return np.append(R @ (F_b[:3] + np.cross(p, F_b[3:])), R @ F_b[3:])


def wrong_own_moment_forgotten(F_b, T):
    """the moment that F_b has already"""
    R, p = T[:3, :3], T[:3, 3]
    return np.append(np.cross(p, R @ F_b[3:]), R @ F_b[3:])


def wrong_as_a_point(F_b, T):
    """unnamed"""
    m = T @ np.append(F_b[:3], 1)
    f = T @ np.append(F_b[3:], 1)
    return np.append(m[:3], f[:3])


def wrong_force_translated_too(F_b, T):
    """unnamed"""
    R, p = T[:3, :3], T[:3, 3]
    f = R @ F_b[3:] + p
    return np.append(R @ F_b[:3] + np.cross(p, f), f)


def wrong_matrix(F_b, T):
    """a matrix is returned"""
    return adjoint(inverse(T)).T * F_b


def wrong_whole_numbers(F_b, T):
    """digits after the point"""
    F = np.zeros_like(F_b)
    F[:] = adjoint(inverse(T)).T @ F_b
    return F
