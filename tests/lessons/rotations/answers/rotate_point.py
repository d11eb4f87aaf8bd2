"""What students write for rotate_point(p, a)."""

import numpy as np

from course_lib.rotations import rot_z


def right_matrix(p, a):
    return np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]]) @ p


def right_complex_number(p, a):
    z = complex(*p) * np.exp(1j * a)
    return [z.real, z.imag]


def right_block_of_rot_z(p, a):
    return (rot_z(a)[:2, :2] @ p[:, None]).astype(np.float64)


def wrong_angle_of_arctan(p, a):
    """the answers to some inputs only are wrong"""
    r, phi = np.linalg.norm(p), np.arctan(p[1] / (p[0] or 1))
    return np.array([r * np.cos(phi + a), r * np.sin(phi + a)])


def wrong_small_angles_taken_for_none(p, a):
    """p is returned as it came"""
    if abs(a) < 1e-6:
        return np.array(p, float)
    return np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]]) @ p


def wrong_straight_up_if_x_is_0(p, a):
    """the direction of p comes from arctan or arccos, which know half of the circle only"""
    if p[0] == 0:
        phi = np.pi / 2
    else:
        phi = np.arctan(p[1] / p[0]) + (np.pi if p[0] < 0 else 0)
    r = np.linalg.norm(p)
    return np.array([r * np.cos(phi + a), r * np.sin(phi + a)])
