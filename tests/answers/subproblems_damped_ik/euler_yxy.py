"""What students write for euler_yxy(R)."""

import itertools
import math

import numpy as np
from scipy.spatial.transform import Rotation

from course_lib import subproblems
from course_lib.rotations import rot_x, rot_y


def rest(b1, b2, R):
    """b3, from the rest of R."""
    left = rot_x(-b2) @ rot_y(-b1) @ R
    return np.arctan2(left[0, 2], left[0, 0])


def right_by_entries(R):
    sine = np.hypot(R[0, 1], R[2, 1])
    if sine < 1e-9:
        b2 = 0.0 if R[1, 1] > 0 else np.pi
        return np.array([[0.0, b2, rest(0.0, b2, R)]] * 2)
    b1, b2, b3 = np.arctan2(R[0, 1], R[2, 1]), np.arctan2(sine, R[1, 1]), np.arctan2(R[1, 0], -R[1, 2])
    return np.array([[b1, b2, b3], [b1 + np.pi, -b2, b3 + np.pi]])


def right_both_signs_of_arccos(R):
    triples = []
    for b2 in (-math.acos(min(1, max(-1, R[1, 1]))), math.acos(min(1, max(-1, R[1, 1])))):
        s = 1 if b2 >= 0 else -1
        free = math.hypot(R[0, 1], R[2, 1]) < 1e-7
        b1 = 0.0 if free else math.atan2(s * R[0, 1], s * R[2, 1])
        triples.append((b1, b2, float(rest(b1, b2, R))))
    return triples


def right_by_the_librarys_subproblems(R):
    ex, ey, ez = np.eye(3)
    onto = subproblems.subproblem2(ex, ey, ey, R @ ey).theta
    found = []
    for b2, back in onto:
        left = rot_x(-b2) @ rot_y(back) @ R
        found.append([-back, b2, float(subproblems.subproblem1(ey, ez, left @ ez).theta)])
    return np.array(found)


def right_b1_of_its_own_choice_where_it_is_free(R):
    sine = np.sqrt(R[1, 0] ** 2 + R[1, 2] ** 2)
    if sine < 1e-8:
        triples = [(b1, 0.0 if R[1, 1] > 0 else np.pi) for b1 in (1.0, 2.0)]
        return [[b1, b2, rest(b1, b2, R)] for b1, b2 in triples]
    found = []
    for s in (1, -1):
        b3 = np.arctan2(s * R[1, 0], -s * R[1, 2])
        b2 = np.arctan2(s * sine, R[1, 1])
        left = R @ rot_y(-b3) @ rot_x(-b2)
        found.append([np.arctan2(left[0, 2], left[2, 2]) + 2 * np.pi, b2 - 2 * np.pi, b3])
    return found


def right_as_zyz_in_other_axes(R):
    """y takes the place of z, and x that of y."""
    P = np.array([[0, 1, 0], [0, 0, 1], [1, 0, 0.0]])
    Z = P.T @ R @ P
    sine = np.hypot(Z[2, 0], Z[2, 1])
    if sine < 1e-10:
        sign = np.sign(Z[2, 2])
        return np.array([[np.arctan2(sign * Z[1, 0], sign * Z[0, 0]), np.arccos(sign), 0]] * 2)
    a, b, c = np.arctan2(Z[1, 2], Z[0, 2]), np.arctan2(sine, Z[2, 2]), np.arctan2(Z[2, 1], -Z[2, 0])
    return np.array([[a - np.pi, -b, c + np.pi], [a, b, c]])


def right_one_triple_where_all_are_one(R):
    found = right_by_entries(R)
    return found[:1] if np.allclose(found[0], found[1]) else found


def wrong_only_one(R):
    """only one triple"""
    return right_by_entries(R)[0]


def wrong_the_same_twice(R):
    """only one triple"""
    return right_by_entries(R)[[0, 0]]


def wrong_sign_of_b1(R):
    """b1 has the other sign"""
    ex, ey, ez = np.eye(3)
    onto = subproblems.subproblem2(ex, ey, ey, R @ ey).theta
    return np.array([[back, b2, rest(-back, b2, R)] for b2, back in onto])


def wrong_b3_of_the_wrong_rest(R):
    """unnamed"""
    ex, ey, ez = np.eye(3)
    onto = subproblems.subproblem2(ex, ey, ey, R @ ey).theta
    return np.array([[-back, b2, rest(back, b2, R)] for b2, back in onto])


def wrong_b3_turned_back(R):
    """b3 has the other sign"""
    return right_by_entries(R) * [1, 1, -1]


def wrong_swapped(R):
    """b1 and b3 are swapped"""
    return right_by_entries(R)[:, ::-1]


def wrong_transposed(R):
    """the triples are those of R^T"""
    return right_by_entries(R.T)


def wrong_xyx(R):
    """the angles are those about x, y and x"""
    sine = np.hypot(R[0, 1], R[0, 2])
    if sine < 1e-9:
        b2 = 0.0 if R[0, 0] > 0 else np.pi
        left = rot_y(-b2) @ R
        return np.array([[0.0, b2, np.arctan2(left[2, 1], left[1, 1])]] * 2)
    b1, b2, b3 = np.arctan2(R[1, 0], -R[2, 0]), np.arctan2(sine, R[0, 0]), np.arctan2(R[0, 1], R[0, 2])
    return np.array([[b1, b2, b3], [b1 + np.pi, -b2, b3 + np.pi]])


def wrong_zxz(R):
    """the angles are those about other axes"""
    sine = np.hypot(R[0, 2], R[1, 2])
    if sine < 1e-9:
        b2 = 0.0 if R[2, 2] > 0 else np.pi
        left = rot_x(-b2) @ R
        return np.array([[0.0, b2, np.arctan2(left[1, 0], left[0, 0])]] * 2)
    b1, b2, b3 = np.arctan2(R[0, 2], -R[1, 2]), np.arctan2(sine, R[2, 2]), np.arctan2(R[2, 0], R[2, 1])
    return np.array([[b1, b2, b3], [b1 + np.pi, -b2, b3 + np.pi]])


def wrong_second_by_half_a_turn(R):
    """the second triple is made by b2 + pi"""
    b1, b2, b3 = right_by_entries(R)[0]
    return [[b1, b2, b3], [b1, b2 + np.pi, b3]]


def wrong_second_all_half_a_turn(R):
    """the second triple is made by b2 + pi"""
    first = right_by_entries(R)[0]
    return np.array([first, first + np.pi])


def wrong_second_with_b2_alone(R):
    """the second triple is not made of the first as it should be"""
    b1, b2, b3 = right_by_entries(R)[0]
    return [(b1, b2, b3), (b1, -b2, b3)]


def wrong_second_negative(R):
    """the second triple is not made of the first as it should be"""
    first = right_by_entries(R)[0]
    return np.array([first, -first])


def wrong_free_angle_not_asked(R):
    """b1 and b3 are read off by themselves"""
    b1, b3 = np.arctan2(R[0, 1], R[2, 1]), np.arctan2(R[1, 0], -R[1, 2])
    b2 = np.arccos(np.clip(R[1, 1], -1, 1))
    return np.array([[b1, b2, b3], [b1 + np.pi, -b2, b3 + np.pi]])


def wrong_sine_compared_with_zero(R):
    """b1 and b3 are read off by themselves"""
    if R[0, 1] == 0 and R[2, 1] == 0:
        return right_by_entries(R)
    b1, b2, b3 = (
        np.arctan2(R[0, 1], R[2, 1]),
        np.arctan2(np.hypot(R[0, 1], R[2, 1]), R[1, 1]),
        np.arctan2(R[1, 0], -R[1, 2]),
    )
    return np.array([[b1, b2, b3], [b1 + np.pi, -b2, b3 + np.pi]])


def wrong_half_turn_forgotten(R):
    """b1 and b3 are read off by themselves"""
    if R[1, 1] > 1 - 1e-12:
        return right_by_entries(R)
    return wrong_free_angle_not_asked(R)


def wrong_sum_for_both_ends(R):
    """b1 and b3 are read off by themselves"""
    if abs(R[1, 1]) > 1 - 1e-12:
        return np.array([[0.0, np.arccos(np.round(R[1, 1])), np.arctan2(R[0, 2], R[2, 2])]] * 2)
    return right_by_entries(R)


def wrong_arccos_not_clipped(R):
    """a hair beyond 1"""
    b2 = np.arccos(R[1, 1])
    if np.sin(b2) < 1e-9:
        return [[0.0, b2, rest(0.0, b2, R)]] * 2
    return np.array([[t[0], s, t[2]] for t, s in zip(right_by_entries(R), (b2, -b2))])


def wrong_divided_by_the_sine(R):
    """a hair beyond 1"""
    sine = np.hypot(R[0, 1], R[2, 1])
    b1, b3 = np.arctan2(R[0, 1] / sine, R[2, 1] / sine), np.arctan2(R[1, 0] / sine, -R[1, 2] / sine)
    b2 = np.arctan2(sine, R[1, 1])
    return np.array([[b1, b2, b3], [b1 + np.pi, -b2, b3 + np.pi]])


def wrong_empty_where_b1_is_free(R):
    """nothing is found where sin(b2) = 0"""
    return right_by_entries(R) if np.hypot(R[0, 1], R[2, 1]) > 1e-9 else []


def wrong_arcsin(R):
    """b2 is wrong beyond 90 degrees"""
    sine = np.hypot(R[0, 1], R[2, 1])
    if sine < 1e-9:
        return right_by_entries(R)
    b1, b2, b3 = np.arctan2(R[0, 1], R[2, 1]), np.arcsin(min(sine, 1)), np.arctan2(R[1, 0], -R[1, 2])
    return np.array([[b1, b2, b3], [b1 + np.pi, -b2, b3 + np.pi]])


def wrong_arctan(R):
    """off by pi"""
    sine = np.hypot(R[0, 1], R[2, 1])
    if sine < 1e-9:
        return right_by_entries(R)
    b1, b2, b3 = np.arctan(R[0, 1] / R[2, 1]), np.arctan2(sine, R[1, 1]), np.arctan(-R[1, 0] / R[1, 2])
    return np.array([[b1, b2, b3], [b1 + np.pi, -b2, b3 + np.pi]])


def wrong_sign_of_an_entry(R):
    """unnamed"""
    sine = np.hypot(R[0, 1], R[2, 1])
    if sine < 1e-9:
        return right_by_entries(R)
    b1, b2, b3 = np.arctan2(R[0, 1], R[2, 1]), np.arctan2(sine, R[1, 1]), np.arctan2(R[1, 0], R[1, 2])
    return np.array([[b1, b2, b3], [b1 + np.pi, -b2, b3 + np.pi]])


def wrong_small_b2_cut(R):
    """b2 near 0 or pi is treated as if it were"""
    if np.hypot(R[0, 1], R[2, 1]) > 0.01:
        return right_by_entries(R)
    b2 = 0.0 if R[1, 1] > 0 else np.pi
    return np.array([[0.0, b2, rest(0.0, b2, R)]] * 2)


def wrong_b2_negated(R):
    """b2 has the other sign"""
    return right_by_entries(R)[::-1] * [1, -1, 1]


def wrong_degrees(R):
    """degrees"""
    return np.degrees(right_by_entries(R))


def wrong_angles_in_columns(R):
    """another form"""
    return right_by_entries(R).T


def wrong_all_combinations(R):
    """combined in all ways"""
    (a, b, c), (d, e, f) = right_by_entries(R)
    return np.array(list(itertools.product((a, d), (b, e), (c, f))))


def wrong_mixed(R):
    """angles of one triple stand in the other"""
    found = right_by_entries(R)
    if np.hypot(R[0, 1], R[2, 1]) > 1e-9:
        found[:, 0] = found[::-1, 0]
    return found


def wrong_first_index_swapped(R):
    """the triples are those of R^T"""
    sine = np.hypot(R[1, 0], R[1, 2])
    if sine < 1e-9:
        return right_by_entries(R.T)
    b1, b2, b3 = np.arctan2(R[1, 0], R[1, 2]), np.arctan2(sine, R[1, 1]), np.arctan2(R[0, 1], -R[2, 1])
    return np.array([[b1, b2, b3], [b1 + np.pi, -b2, b3 + np.pi]])


def wrong_scipy(R):
    """scipy.spatial.transform.Rotation is called"""
    first = Rotation.from_matrix(R).as_euler("YXY")
    return np.array([first, first * [1, -1, 1] + [np.pi, 0, np.pi]])


def wrong_the_librarys(R):
    """course_lib.subproblems.euler_yxy is called"""
    return subproblems.euler_yxy(R).theta
