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


def wrong_force_rotated_twice(F_b, T):
    """unnamed"""
    R = np.kron(np.eye(2), T[:3, :3])
    return R @ right_by_the_adjoint(F_b, T)
