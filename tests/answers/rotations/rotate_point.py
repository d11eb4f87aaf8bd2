"""What students write for rotate_point(p, a)."""

import math

import numpy as np

from course_lib.rotations import rot_z


def right_matrix(p, a):
    return np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]]) @ p


def right_complex_number(p, a):
    z = complex(*p) * np.exp(1j * a)
    return [z.real, z.imag]


def right_polar(p, a):
    r, phi = math.hypot(*p), math.atan2(p[1], p[0])
    return (r * math.cos(phi + a), r * math.sin(phi + a))


def right_block_of_rot_z(p, a):
    return (rot_z(a)[:2, :2] @ p[:, None]).astype(np.float64)


def wrong_other_way_round(p, a):
    """the point moves clockwise"""
    return p @ np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]])


def wrong_degrees(p, a):
    """degrees"""
    a = math.radians(a)
    return np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]]) @ p


def wrong_star_for_matmul(p, a):
    """another form"""
    return np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]]) * p


def wrong_new_x_used(p, a):
    """the new x is used"""
    x, y = p
    x = x * np.cos(a) - y * np.sin(a)
    y = x * np.sin(a) + y * np.cos(a)
    return np.array([x, y])


def wrong_in_place(p, a):
    """p is changed in place"""
    p[0], p[1] = p[0] * np.cos(a) - p[1] * np.sin(a), p[0] * np.sin(a) + p[1] * np.cos(a)
    return p


def wrong_angle_of_arctan(p, a):
    """unnamed"""
    r, phi = np.linalg.norm(p), np.arctan(p[1] / (p[0] or 1))
    return np.array([r * np.cos(phi + a), r * np.sin(phi + a)])


def wrong_both_signs_plus(p, a):
    """a sign is missing"""
    x, y = p
    return np.array([x * np.cos(a) + y * np.sin(a), x * np.sin(a) + y * np.cos(a)])


def wrong_three_coordinates(p, a):
    """another form"""
    return rot_z(a) @ np.array([*p, 0.0])


def wrong_matrix_returned(p, a):
    """another form"""
    return np.array([[np.cos(a), -np.sin(a)], [np.sin(a), np.cos(a)]])


def wrong_list_times_number(p, a):
    """TypeError"""
    return [p[0] * np.cos(a), p[1]] * np.sin(a)
