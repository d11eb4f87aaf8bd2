"""What students write for screw_axes(omega, points)."""

import numpy as np

from course_lib.arms import SerialArm


def right_side_by_side(omega, points):
    return np.hstack([omega, -np.cross(omega, points)])


def right_row_by_row_as_lists(omega, points):
    rows = []
    for (a, b, c), (x, y, z) in zip(omega, points):
        rows.append([a, b, c, y * c - z * b, z * a - x * c, x * b - y * a])
    return rows


def right_by_matrices(omega, points):
    S = np.zeros((len(omega), 6))
    for i in range(len(omega)):
        x, y, z = omega[i]
        W = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
        S[i, :3] = omega[i]
        S[i, 3:] = -W @ points[i]
    return S


def right_by_einsum(omega, points):
    epsilon = np.zeros((3, 3, 3))
    for i, j, k in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        epsilon[i, j, k], epsilon[i, k, j] = 1, -1
    return np.concatenate((omega, np.einsum("ijk,nj,nk->ni", epsilon, points, omega)), axis=1)


def right_from_the_foot_of_the_perpendicular(omega, points):
    feet = points - (omega * points).sum(1, keepdims=True) * omega
    return tuple(np.r_[w, np.cross(foot, w)] for w, foot in zip(omega, feet))


def wrong_sign(omega, points):
    """v has its sign changed: it is omega x p"""
    return np.hstack([omega, np.cross(omega, points)])


def wrong_transposed(omega, points):
    """rows and columns are swapped"""
    return np.vstack([omega.T, np.cross(points, omega).T])


def wrong_v_alone(omega, points):
    """only one half of each axis"""
    return np.cross(points, omega)


def wrong_below_each_other(omega, points):
    """do not stand side by side"""
    return np.vstack([omega, np.cross(points, omega)])


def wrong_two_arrays(omega, points):
    """do not stand side by side"""
    return omega, -np.cross(omega, points)


def wrong_in_one_long_row(omega, points):
    """rows of their own"""
    return np.append(omega, np.cross(points, omega))


def wrong_last_axis_only(omega, points):
    """rows of their own"""
    for w, p in zip(omega, points):
        S = np.concatenate([w, np.cross(p, w)])
    return S


def wrong_v_divided_by_zero(omega, points):
    """v is scaled to length one"""
    v = np.cross(points, omega)
    return np.hstack([omega, v / np.linalg.norm(v, axis=1, keepdims=True)])


def wrong_points_changed(omega, points):
    """points is changed in place"""
    points *= -1
    return np.hstack([omega, np.cross(omega, points)])


def wrong_two_components_swapped(omega, points):
    """unnamed"""
    v = np.cross(points, omega)
    return np.hstack([omega, v[:, [1, 0, 2]]])


def wrong_return_missing(omega, points):
    """a return is missing"""
    np.hstack([omega, np.cross(points, omega)])


def wrong_the_librarys(omega, points):
    """course_lib.arms.SerialArm is called"""
    return SerialArm.from_screws(omega, points, np.eye(4)).screw_axes


def wrong_dot_product(omega, points):
    """a dot product stands for the cross product"""
    return np.hstack([omega, (omega * points).sum(axis=1, keepdims=True) * omega])
