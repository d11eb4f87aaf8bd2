"""What students write for rate_matrix(b)."""

import math

import numpy as np
from scipy.spatial.transform import Rotation

from course_lib.rotations import hat, rot_x, rot_y, vee


def right_by_the_formula(b):
    c1, s1 = np.cos(b[0]), np.sin(b[0])
    c2, s2 = np.cos(b[1]), np.sin(b[1])
    return np.array([[0, c1, s1 * s2], [1, 0, c2], [0, -s1, c1 * s2]])


def right_axes_as_columns(b):
    ex, ey, _ = np.eye(3)
    return np.column_stack([ey, rot_y(b[0]) @ ex, rot_y(b[0]) @ rot_x(b[1]) @ ey])


def right_lists(b):
    b1, b2, _ = (float(angle) for angle in b)
    return [
        [0, math.cos(b1), math.sin(b1) * math.sin(b2)],
        [1, 0, math.cos(b2)],
        [0, -math.sin(b1), math.cos(b1) * math.sin(b2)],
    ]


def right_product_rule(b):
    e = [np.array([0.0, 1, 0]), np.array([1.0, 0, 0]), np.array([0.0, 1, 0])]
    factors = [rot_y(b[0]), rot_x(b[1]), rot_y(b[2])]
    R = factors[0] @ factors[1] @ factors[2]
    columns = []
    for j in range(3):
        parts = [hat(e[i]) @ factors[i] if i == j else factors[i] for i in range(3)]
        W = parts[0] @ parts[1] @ parts[2] @ R.T
        columns.append([W[2, 1], W[0, 2], W[1, 0]])
    return np.transpose(columns)


def right_from_the_hand_s_own(b):
    c2, s2, c3, s3 = np.cos(b[1]), np.sin(b[1]), np.cos(b[2]), np.sin(b[2])
    own = np.array([[s2 * s3, c3, 0], [c2, 0, 1], [-s2 * c3, s3, 0]])
    return rot_y(b[0]) @ rot_x(b[1]) @ rot_y(b[2]) @ own


def right_central_differences(b):
    def R(b):
        return rot_y(b[0]) @ rot_x(b[1]) @ rot_y(b[2])

    h = 1e-5
    A = np.zeros((3, 3))
    for j, e in enumerate(np.eye(3)):
        W = (R(b + h * e) - R(b - h * e)) / (2 * h) @ R(b).T
        A[:, j] = vee((W - W.T) / 2)
    return A


def right_rotation_vectors_of_scipy(b):
    first = Rotation.from_euler("y", b[0])
    both = first * Rotation.from_euler("x", b[1])
    return np.array([[0, 1, 0], first.apply([1, 0, 0]), both.apply([0, 1, 0])]).T.astype(complex)


def _parts(b):
    return np.cos(b[0]), np.sin(b[0]), np.cos(b[1]), np.sin(b[1])


def wrong_seen_from_the_hand(b):
    """seen from the rotating end-effector"""
    c2, s2, c3, s3 = np.cos(b[1]), np.sin(b[1]), np.cos(b[2]), np.sin(b[2])
    return np.array([[s2 * s3, c3, 0], [c2, 0, 1], [-s2 * c3, s3, 0]])


def wrong_fixed_axes(b):
    """no axis is carried along"""
    return np.array([[0, 1, 0], [1, 0, 1], [0, 0, 0]])


def wrong_third_axis_not_turned_by_b1(b):
    """the third axis is not rotated by b1"""
    c1, s1, c2, s2 = _parts(b)
    return np.array([[0, c1, 0], [1, 0, c2], [0, -s1, s2]])


def wrong_third_axis_not_turned_by_b2(b):
    """the third axis is not rotated by b2"""
    c1, s1, _, _ = _parts(b)
    return np.array([[0, c1, 0], [1, 0, 1], [0, -s1, 0]])


def wrong_second_axis_not_turned(b):
    """the second axis is not rotated by b1"""
    c1, s1, c2, s2 = _parts(b)
    return np.array([[0, 1, s1 * s2], [1, 0, c2], [0, 0, c1 * s2]])


def wrong_columns_reversed(b):
    """the columns stand in another order"""
    c1, s1, c2, s2 = _parts(b)
    return np.array([[s1 * s2, c1, 0], [c2, 0, 1], [c1 * s2, -s1, 0]])


def wrong_columns_of_b1_and_b2_swapped(b):
    """the columns stand in another order"""
    c1, s1, c2, s2 = _parts(b)
    return np.array([[c1, 0, s1 * s2], [0, 1, c2], [-s1, 0, c1 * s2]])


def wrong_rows_reversed(b):
    """the rows stand in another order"""
    c1, s1, c2, s2 = _parts(b)
    return np.array([[0, -s1, c1 * s2], [1, 0, c2], [0, c1, s1 * s2]])


def wrong_rows_x_and_y_swapped(b):
    """the rows stand in another order"""
    c1, s1, c2, s2 = _parts(b)
    return np.array([[1, 0, c2], [0, c1, s1 * s2], [0, -s1, c1 * s2]])


def wrong_transposed(b):
    """the transposed matrix"""
    c1, s1, c2, s2 = _parts(b)
    return np.array([[0, 1, 0], [c1, 0, -s1], [s1 * s2, c2, c1 * s2]])


def wrong_axes_as_rows(b):
    """the transposed matrix"""
    ex, ey, _ = np.eye(3)
    return np.array([ey, rot_y(b[0]) @ ex, rot_y(b[0]) @ rot_x(b[1]) @ ey])


def wrong_signs_of_vee(b):
    """the whole matrix has the wrong sign"""
    c1, s1, c2, s2 = _parts(b)
    return -np.array([[0, c1, s1 * s2], [1, 0, c2], [0, -s1, c1 * s2]])


def wrong_rot_y_turned_the_other_way(b):
    """b1 is taken with the other sign"""
    c1, s1, c2, s2 = _parts(b)
    return np.array([[0, c1, -s1 * s2], [1, 0, c2], [0, s1, c1 * s2]])


def wrong_rot_x_turned_the_other_way(b):
    """b2 is taken with the other sign"""
    c1, s1, c2, s2 = _parts(b)
    return np.array([[0, c1, -s1 * s2], [1, 0, c2], [0, -s1, -c1 * s2]])


def wrong_sign_of_the_sine(b):
    """sin b1 has the wrong sign in one place"""
    c1, s1, c2, s2 = _parts(b)
    return np.array([[0, c1, s1 * s2], [1, 0, c2], [0, s1, c1 * s2]])


def wrong_sign_in_column_3(b):
    """column 3 has the wrong sign"""
    c1, s1, c2, s2 = _parts(b)
    return np.array([[0, c1, s1 * s2], [1, 0, -c2], [0, -s1, c1 * s2]])


def wrong_b3_for_b1(b):
    """b3 stands where b1 belongs"""
    c3, s3, c2, s2 = np.cos(b[2]), np.sin(b[2]), np.cos(b[1]), np.sin(b[1])
    return np.array([[0, c3, s3 * s2], [1, 0, c2], [0, -s3, c3 * s2]])


def wrong_b1_and_b2_swapped(b):
    """b1 and b2 are swapped"""
    c2, s2, c1, s1 = _parts(b)
    return np.array([[0, c1, s1 * s2], [1, 0, c2], [0, -s1, c1 * s2]])


def wrong_degrees(b):
    """degrees"""
    c1, s1, c2, s2 = _parts(np.radians(b))
    return np.array([[0, c1, s1 * s2], [1, 0, c2], [0, -s1, c1 * s2]])


def wrong_sine_of_b2_missing(b):
    """a factor sin b2 is missing"""
    c1, s1, c2, _ = _parts(b)
    return np.array([[0, c1, s1], [1, 0, c2], [0, -s1, c1]])


def wrong_sine_of_b2_missing_in_one_row(b):
    """a factor sin b2 is missing"""
    c1, s1, c2, s2 = _parts(b)
    return np.array([[0, c1, s1 * s2], [1, 0, c2], [0, -s1, c1]])


def wrong_cosine_of_b2_missing(b):
    """cos b2 is missing"""
    c1, s1, _, s2 = _parts(b)
    return np.array([[0, c1, s1 * s2], [1, 0, 1], [0, -s1, c1 * s2]])


def wrong_sine_and_cosine_of_b2_swapped(b):
    """sine and cosine are swapped"""
    c1, s1, c2, s2 = _parts(b)
    return np.array([[0, c1, s1 * c2], [1, 0, s2], [0, -s1, c1 * c2]])


def wrong_sine_and_cosine_in_column_2(b):
    """sine and cosine are swapped"""
    c1, s1, c2, s2 = _parts(b)
    return np.array([[0, s1, s1 * s2], [1, 0, c2], [0, -c1, c1 * s2]])


def wrong_identity(b):
    """the identity"""
    return np.eye(3)


def wrong_the_rotation(b):
    """R itself"""
    return rot_y(b[0]) @ rot_x(b[1]) @ rot_y(b[2])


def wrong_about_x_y_and_x(b):
    """other axes than y, x and y"""
    c1, s1, c2, s2 = _parts(b)
    return np.array([[1, 0, c2], [0, c1, s1 * s2], [0, s1, -c1 * s2]])


def wrong_coarse_differences(b):
    """lose too many digits"""

    def R(b):
        return rot_y(b[0]) @ rot_x(b[1]) @ rot_y(b[2])

    h, columns = 1e-4, []
    for e in np.eye(3):
        W = (R(b + h * e) - R(b)) / h @ R(b).T
        columns.append([W[2, 1], W[0, 2], W[1, 0]])
    return np.array(columns).T


def wrong_multiplied_by_the_rates_already(b):
    """another form"""
    c1, s1, c2, s2 = _parts(b)
    return np.array([[0, c1, s1 * s2], [1, 0, c2], [0, -s1, c1 * s2]]) @ b


def wrong_cut_to_whole_numbers(b):
    """unnamed"""
    A = np.zeros((3, 3), int)
    c1, s1, c2, s2 = _parts(b)
    A[:] = np.array([[0, c1, s1 * s2], [1, 0, c2], [0, -s1, c1 * s2]])
    return A


def wrong_b_changed_in_place(b):
    """b is changed in place"""
    b %= 3
    c1, s1, c2, s2 = _parts(b)
    return np.array([[0, c1, s1 * s2], [1, 0, c2], [0, -s1, c1 * s2]])


def wrong_third_angle_used_too(b):
    """unnamed"""
    c1, s1, c3, s3 = np.cos(b[0]), np.sin(b[0]), np.cos(b[2]), np.sin(b[2])
    return np.array([[0, c1, s1 * s3], [1, 0, c3], [0, -s1, c1 * s3]])


def wrong_both_signs(b):
    """both angles are taken with the other sign"""
    c1, s1, c2, s2 = np.cos(b[0]), -np.sin(b[0]), np.cos(b[1]), -np.sin(b[1])
    return np.array([[0, c1, s1 * s2], [1, 0, c2], [0, -s1, c1 * s2]])
