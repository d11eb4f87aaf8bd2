"""What students write for log_so3(R)."""

import numpy as np
import scipy.linalg

from course_lib import rotations as rot


def right_three_branches(R):
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    if angle < 1e-6:
        return np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2
    if angle > np.pi - 1e-6:
        columns = R + np.eye(3)
        longest = columns[:, np.argmax(np.linalg.norm(columns, axis=0))]
        return angle * longest / np.linalg.norm(longest)
    n = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / (2 * np.sin(angle))
    return angle * n


def right_by_arctan2_as_a_column(R):
    across = np.array([[R[2, 1] - R[1, 2]], [R[0, 2] - R[2, 0]], [R[1, 0] - R[0, 1]]]) / 2
    sine, cosine = np.linalg.norm(across), (np.trace(R) - 1) / 2
    angle = np.arctan2(sine, cosine)
    if sine > 1e-7:
        return across / sine * angle
    if cosine > 0:
        return across
    outer = (R + np.eye(3)) / 2
    k = np.argmax(np.diag(outer))
    return np.pi * outer[:, [k]] / np.sqrt(outer[k, k])


def right_by_quaternion(R):
    K = np.array(
        [
            [R[0, 0] - R[1, 1] - R[2, 2], 0, 0, 0],
            [R[1, 0] + R[0, 1], R[1, 1] - R[0, 0] - R[2, 2], 0, 0],
            [R[2, 0] + R[0, 2], R[2, 1] + R[1, 2], R[2, 2] - R[0, 0] - R[1, 1], 0],
            [R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1], np.trace(R)],
        ]
    )
    values, vectors = np.linalg.eigh(K)  # reads the lower triangle
    x, y, z, w = vectors[:, -1] * (1 if vectors[3, -1] >= 0 else -1)
    sine = np.sqrt(x * x + y * y + z * z)
    if sine == 0:
        return (0, 0, 0)
    angle = 2 * np.arctan2(sine, w)
    return (angle * x / sine, angle * y / sine, angle * z / sine)


def right_eigenvector_of_one(R):
    values, vectors = np.linalg.eig(R)
    n = np.real(vectors[:, np.argmin(abs(values - 1))])
    n = n / np.linalg.norm(n)
    across = np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])
    angle = np.arctan2(n @ across, np.trace(R) - 1)
    return list(angle * n)


def right_matrix_logarithm_where_it_is_fine(R):
    if np.trace(R) > -0.9:
        W = scipy.linalg.logm(R)
        return np.real([W[2, 1], W[0, 2], W[1, 0]])
    return right_three_branches(R)


def _vee_of_difference(R):
    return np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]])


def _at_half_turn(R):
    columns = R + np.eye(3)
    longest = columns[:, np.argmax(np.linalg.norm(columns, axis=0))]
    return np.pi * longest / np.linalg.norm(longest)


def wrong_half_turn_taken_for_none(R):
    """small angles are cut off to zero"""
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    if np.sin(angle) < 1e-6:
        return np.zeros(3)
    return angle * _vee_of_difference(R) / (2 * np.sin(angle))


def wrong_divided_by_the_sine_of_pi(R):
    """small angles are cut off to zero"""
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    if angle == 0:
        return np.zeros(3)
    return angle * _vee_of_difference(R) / (2 * np.sin(angle))


def wrong_signs_at_half_turn(R):
    """the signs of the axis's entries do not fit together"""
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    if angle < 1e-6:
        return _vee_of_difference(R) / 2
    if angle > np.pi - 1e-6:
        return np.pi * np.sqrt(np.maximum((np.diag(R) + 1) / 2, 0))
    return angle * _vee_of_difference(R) / (2 * np.sin(angle))


def wrong_first_column_at_half_turn(R):
    """divided by zero"""
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    if angle < 1e-6:
        return _vee_of_difference(R) / 2
    if angle > np.pi - 1e-6:
        return np.pi * (R + np.eye(3))[:, 0] / np.linalg.norm((R + np.eye(3))[:, 0])
    return angle * _vee_of_difference(R) / (2 * np.sin(angle))


def wrong_axis_not_normalised_at_half_turn(R):
    """at 180 degrees the answer is not pi times the unit axis"""
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    if angle < 1e-6:
        return _vee_of_difference(R) / 2
    if angle > np.pi - 1e-6:
        return np.pi * (R + np.eye(3))[:, np.argmax(np.diag(R))]
    return angle * _vee_of_difference(R) / (2 * np.sin(angle))


def wrong_arccos_outside_its_domain(R):
    """arccos"""
    angle = np.arccos((np.trace(R) - 1) / 2)
    if angle < 1e-6:
        return _vee_of_difference(R) / 2
    if angle > np.pi - 1e-6:
        return _at_half_turn(R)
    return angle * _vee_of_difference(R) / (2 * np.sin(angle))


def wrong_arccos_of_half_the_trace(R):
    """the angle is computed from the trace with a wrong constant"""
    angle = np.arccos(np.clip(np.trace(R) / 2 - 1, -1, 1))
    if angle < 1e-6:
        return _vee_of_difference(R) / 2
    return angle * _vee_of_difference(R) / max(np.linalg.norm(_vee_of_difference(R)), 1e-12)


def wrong_arcsine(R):
    """beyond 90 degrees"""
    sine = np.linalg.norm(_vee_of_difference(R)) / 2
    if sine < 1e-12:
        return _vee_of_difference(R) / 2 if np.trace(R) > 0 else _at_half_turn(R)
    return np.arcsin(min(sine, 1)) * _vee_of_difference(R) / (2 * sine)


def wrong_long_way_round(R):
    """the longer of the two rotations"""
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    if angle < 1e-6:
        return _vee_of_difference(R) / 2
    if angle > np.pi - 1e-6:
        return _at_half_turn(R)
    return (angle - 2 * np.pi) * _vee_of_difference(R) / (2 * np.sin(angle))


def wrong_axis_for_no_turn(R):
    """digits are lost at small angles"""
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    if angle == 0:
        return [0, 0, 1]
    if angle > np.pi - 1e-6:
        return _at_half_turn(R)
    return angle * _vee_of_difference(R) / (2 * np.sin(angle))


def wrong_rounded_before_arccos(R):
    """digits are lost at small angles"""
    angle = np.arccos(np.round((np.trace(R) - 1) / 2, 10))
    if angle < 1e-6:
        return _vee_of_difference(R) / 2
    if angle > np.pi - 1e-6:
        return _at_half_turn(R)
    return angle * _vee_of_difference(R) / np.linalg.norm(_vee_of_difference(R))


def wrong_branch_for_tiny_angles(R):
    """digits are lost at small angles"""
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    if angle < 1e-6:
        return np.array([R[1, 0], R[0, 2], R[2, 1]])
    if angle > np.pi - 1e-6:
        return _at_half_turn(R)
    return angle * _vee_of_difference(R) / (2 * np.sin(angle))


def wrong_skew_matrix_returned(R):
    """another form"""
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    if angle < 1e-6:
        return (R - R.T) / 2
    return angle * (R - R.T) / (2 * np.sin(angle))


def wrong_axis_and_angle_apart(R):
    """another form"""
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    if angle < 1e-6:
        return np.array([0, 0, 1]), angle
    if angle > np.pi - 1e-6:
        return _at_half_turn(R) / np.pi, angle
    return _vee_of_difference(R) / (2 * np.sin(angle)), angle


def wrong_the_librarys(R):
    """course_lib.rotations.log_so3 is called"""
    return rot.log_so3(R)


def _skew(R):
    return np.array([R[2, 1] - R[1, 2], R[0, 2] - R[2, 0], R[1, 0] - R[0, 1]]) / 2


def _half(R):
    C = R + np.eye(3)
    c = C[:, np.argmax(np.linalg.norm(C, axis=0))]
    return np.pi * c / np.linalg.norm(c)


def wrong_half_turn_formula_from_afar(R):
    """used too soon"""
    a = np.arctan2(np.linalg.norm(_skew(R)), (np.trace(R) - 1) / 2)
    if np.pi - a < 1e-3:
        return _half(R)
    return _skew(R) * (a / np.sin(a) if a > 0 else 1)


def wrong_zeros_below_a_threshold(R):
    """small angles are cut off"""
    s = np.linalg.norm(_skew(R))
    a = np.arctan2(s, (np.trace(R) - 1) / 2)
    if a < 1.2e-4:
        return np.zeros(3)
    return _half(R) if s < 1e-9 else a / s * _skew(R)


def wrong_eigenvector_with_any_sign(R):
    """sign"""
    values, vectors = np.linalg.eig(R)
    n = np.real(vectors[:, np.argmin(abs(values - 1))])
    return np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1)) * n


def wrong_exact_test_of_the_trace(R):
    """180 degrees"""
    s = np.linalg.norm(_skew(R))
    a = np.arctan2(s, (np.trace(R) - 1) / 2)
    if np.trace(R) == -1:
        return _half(R)
    if s == 0:
        return np.zeros(3)
    return a / s * _skew(R)


def wrong_half_turn_for_the_identity_too(R):
    """the identity is given an axis"""
    s = np.linalg.norm(_skew(R))
    if s < 1e-12:
        return _half(R)
    return np.arctan2(s, (np.trace(R) - 1) / 2) / s * _skew(R)


def wrong_columns_of_R_minus_I(R):
    """not pi times the unit axis"""
    s = np.linalg.norm(_skew(R))
    if s < 1e-12 and np.trace(R) < 0:
        C = R - np.eye(3)
        c = C[:, np.argmax(np.linalg.norm(C, axis=0))]
        return np.pi * c / np.linalg.norm(c)
    return np.arctan2(s, (np.trace(R) - 1) / 2) / s * _skew(R) if s > 1e-12 else _skew(R)


def wrong_identity_forgotten_in_the_sum(R):
    """not pi times the unit axis"""
    s = np.linalg.norm(_skew(R))
    if s < 1e-12 and np.trace(R) < 0:
        c = R[:, np.argmax(np.diag(R))]
        return np.pi * c / np.linalg.norm(c)
    return np.arctan2(s, (np.trace(R) - 1) / 2) / s * _skew(R) if s > 1e-12 else _skew(R)


def wrong_arccos_near_pi(R):
    """a rotation by 180 degrees is taken for none"""
    a = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    if a < 1e-6:
        return _skew(R)
    if a == np.pi:
        return _half(R)
    return a / np.sin(a) * _skew(R)
