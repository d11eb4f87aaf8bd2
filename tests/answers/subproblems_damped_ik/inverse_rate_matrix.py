"""What students write for inverse_rate_matrix(b)."""

import math

import numpy as np

from course_lib.rotations import rot_x, rot_y


def rate_matrix(b):
    c1, s1 = np.cos(b[0]), np.sin(b[0])
    c2, s2 = np.cos(b[1]), np.sin(b[1])
    return np.array([[0, c1, s1 * s2], [1, 0, c2], [0, -s1, c1 * s2]])


def inv(A):
    """The inverse by cross products of the columns; inf or nan where there is none."""
    A = np.array(A, float)
    cross = np.array([np.cross(A[:, 1], A[:, 2]), np.cross(A[:, 2], A[:, 0]), np.cross(A[:, 0], A[:, 1])])
    return cross / (A[:, 0] @ cross[0])


def right_inverted(b):
    return inv(rate_matrix(b))


def right_by_the_formula(b):
    b1, b2, _ = (float(angle) for angle in b)
    c, s, sine = math.cos(b1), math.sin(b1), math.sin(b2)
    cot = math.cos(b2) / sine
    return [[-s * cot, 1, -c * cot], [c, 0, -s], [s / sine, 0, c / sine]]


def right_column_by_column(b):
    A = rate_matrix(b)
    columns = [inv(A) @ e for e in np.eye(3)]
    return np.column_stack(columns)


def right_cross_products_of_the_axes(b):
    ex, ey, _ = np.eye(3)
    a1, a2, a3 = ey, rot_y(b[0]) @ ex, rot_y(b[0]) @ rot_x(b[1]) @ ey
    volume = a1 @ np.cross(a2, a3)
    return np.array([np.cross(a2, a3), np.cross(a3, a1), np.cross(a1, a2)]) / volume


def right_pseudoinverse(b):
    return inv(rate_matrix(b)).tolist()


def right_cofactors(b):
    A = rate_matrix(b)
    cofactors = np.zeros((3, 3))
    for i in range(3):
        for j in range(3):
            minor = np.delete(np.delete(A, i, 0), j, 1)
            cofactors[i, j] = (-1) ** (i + j) * (minor[0, 0] * minor[1, 1] - minor[0, 1] * minor[1, 0])
    return cofactors.T / -np.sin(b[1])


def _parts(b):
    return np.cos(b[0]), np.sin(b[0]), np.cos(b[1]), np.sin(b[1])


def wrong_transposed(b):
    """transposed rather than inverted"""
    return rate_matrix(b).T


def wrong_not_inverted(b):
    """A itself is returned"""
    return rate_matrix(b)


def wrong_division_missing(b):
    """the division by sin b2 is missing"""
    c1, s1, c2, _ = _parts(b)
    return np.array([[-s1 * c2, 1, -c1 * c2], [c1, 0, -s1], [s1, 0, c1]])


def wrong_division_missing_in_row_3(b):
    """the division by sin b2 is missing"""
    c1, s1, c2, s2 = _parts(b)
    return np.array([[-s1 * c2 / s2, 1, -c1 * c2 / s2], [c1, 0, -s1], [s1, 0, c1]])


def wrong_adjugate_alone(b):
    """the division by sin b2 is missing"""
    A = rate_matrix(b)
    return np.array([np.cross(A[:, 1], A[:, 2]), np.cross(A[:, 2], A[:, 0]), np.cross(A[:, 0], A[:, 1])])


def wrong_multiplied_by_the_sine(b):
    """multiplied by, not divided by"""
    c1, s1, c2, s2 = _parts(b)
    return np.array([[-s1 * c2 * s2, 1, -c1 * c2 * s2], [c1, 0, -s1], [s1 * s2, 0, c1 * s2]])


def wrong_sign_of_the_determinant(b):
    """the whole inverse has the wrong sign"""
    A = rate_matrix(b)
    rows = [np.cross(A[:, 1], A[:, 2]), np.cross(A[:, 2], A[:, 0]), np.cross(A[:, 0], A[:, 1])]
    return np.array(rows) / np.sin(b[1])


def wrong_sign_of_the_sine_lost(b):
    """the sign of sin b2 is lost"""
    c1, s1, c2, s2 = _parts(b)
    s2 = np.sqrt(1 - c2**2)
    return np.array([[-s1 * c2 / s2, 1, -c1 * c2 / s2], [c1, 0, -s1], [s1 / s2, 0, c1 / s2]])


def wrong_absolute_determinant(b):
    """the sign of sin b2 is lost"""
    A = rate_matrix(b)
    rows = [np.cross(A[:, 1], A[:, 2]), np.cross(A[:, 2], A[:, 0]), np.cross(A[:, 0], A[:, 1])]
    return np.array(rows) / abs(np.linalg.det(A))


def wrong_each_entry_by_itself(b):
    """something is divided by zero"""
    return 1 / rate_matrix(b)


def wrong_power_of_each_entry(b):
    """something is divided by zero"""
    return np.asarray(rate_matrix(b), float) ** -1


def wrong_cofactors_not_transposed(b):
    """the inverse is transposed"""
    return inv(rate_matrix(b)).T


def wrong_sign_in_row_1(b):
    """1/sin b2 has the wrong sign in row 1"""
    c1, s1, c2, s2 = _parts(b)
    return np.array([[s1 * c2 / s2, 1, c1 * c2 / s2], [c1, 0, -s1], [s1 / s2, 0, c1 / s2]])


def wrong_small_sine_cut_off(b):
    """a small sin b2 is treated as if it were zero"""
    A = rate_matrix(b)
    return inv(A) if abs(np.sin(b[1])) > 0.01 else inv(A.T @ A + 1e-4 * np.eye(3)) @ A.T


def wrong_small_sine_gives_zeros(b):
    """a small sin b2 is treated as if it were zero"""
    if np.isclose(np.sin(b[1]), 0, atol=2e-3):
        return np.zeros((3, 3))
    return inv(rate_matrix(b))


def wrong_damped(b):
    """damped"""
    A = rate_matrix(b)
    return inv(A.T @ A + 1e-6 * np.eye(3)) @ A.T


def wrong_sine_missing_before(b):
    """the division by sin b2 is missing"""
    c1, s1, c2, _ = _parts(b)
    return inv([[0, c1, s1], [1, 0, c2], [0, -s1, c1]])


def wrong_fixed_axes_before(b):
    """divided by zero"""
    return inv(np.array([[0, 1, 0], [1, 0, 1], [0, 0, 0]]))


def wrong_tangent_for_cotangent(b):
    """cos b2 / sin b2 is missing in row 1, or upside down"""
    c1, s1, c2, s2 = _parts(b)
    return np.array([[-s1 * s2 / c2, 1, -c1 * s2 / c2], [c1, 0, -s1], [s1 / s2, 0, c1 / s2]])


def wrong_cotangent_forgotten(b):
    """cos b2 / sin b2 is missing"""
    c1, s1, s2 = np.cos(b[0]), np.sin(b[0]), np.sin(b[1])
    return np.array([[0, 1, 0], [c1, 0, -s1], [s1 / s2, 0, c1 / s2]])


def wrong_factor_on_the_left(b):
    """Ry(b1) is on the wrong side"""
    c1, s1, c2, s2 = np.cos(b[0]), np.sin(b[0]), np.cos(b[1]), np.sin(b[1])
    back = np.array([[c1, 0, -s1], [0, 1, 0], [s1, 0, c1]])
    return back @ np.array([[0, 1, -c2 / s2], [1, 0, 0], [0, 0, 1 / s2]])
