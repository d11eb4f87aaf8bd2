"""What students write for quaternion_to_matrix(q)."""

import numpy as np

import course_lib.rotations as r
from course_lib.rotations import hat, rot_x


def right_entry_by_entry(q):
    w, x, y, z = q
    return [
        [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
        [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
        [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
    ]


def right_with_hat(q):
    w, V = q[0], hat(q[1:])
    return np.eye(3) + 2 * w * V + 2 * V @ V


def right_squares_on_the_diagonal(q):
    q0, q1, q2, q3 = q / np.linalg.norm(q)
    R = np.empty((3, 3))
    R[0] = q0**2 + q1**2 - q2**2 - q3**2, 2 * (q1 * q2 - q0 * q3), 2 * (q0 * q2 + q1 * q3)
    R[1] = 2 * (q1 * q2 + q0 * q3), q0**2 - q1**2 + q2**2 - q3**2, 2 * (q2 * q3 - q0 * q1)
    R[2] = 2 * (q1 * q3 - q0 * q2), 2 * (q0 * q1 + q2 * q3), q0**2 - q1**2 - q2**2 + q3**2
    return R


def _product(p, q):
    scalar = p[0] * q[0] - p[1:] @ q[1:]
    return np.array([scalar, *(p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:]))])


def right_sandwich(q):
    conjugate = q * np.array([1, -1, -1, -1])
    columns = [_product(_product(q, np.array([0, *e])), conjugate)[1:] for e in np.eye(3)]
    return np.stack(columns, axis=1)


def right_product_of_left_and_right_matrices(q):
    w, x, y, z = q
    left = np.array([[w, -x, -y, -z], [x, w, -z, y], [y, z, w, -x], [z, -y, x, w]])
    right = np.array([[w, x, y, z], [-x, w, -z, y], [-y, z, w, -x], [-z, -y, x, w]])
    return np.einsum("ij,jk->ik", left, right)[1:, 1:].astype(complex)


def right_axis_and_angle(q):
    sine = np.linalg.norm(q[1:])
    if sine < 1e-12:
        return np.eye(3, dtype=int)
    n, a = q[1:] / sine, 2 * np.arctan2(sine, q[0])
    return np.cos(a) * np.eye(3) + np.sin(a) * hat(n) + (1 - np.cos(a)) * np.outer(n, n)


def wrong_scalar_last(q):
    """(x, y, z, w)"""
    x, y, z, w = q
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def wrong_sign_on_the_diagonal(q):
    """the squares on the diagonal are the wrong ones, or have the wrong sign"""
    w, x, y, z = q
    return np.array(
        [
            [1 + 2 * x * x, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 + 2 * y * y, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 + 2 * z * z],
        ]
    )


def wrong_own_square_on_the_diagonal(q):
    """the squares on the diagonal are the wrong ones, or have the wrong sign"""
    w, x, y, z = q
    return np.array(
        [
            [1 - 2 * x * x, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * y * y, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * z * z],
        ]
    )


def wrong_one_sign_off_the_diagonal(q):
    """the term with w has the wrong sign in one entry"""
    w, x, y, z = q
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
        ]
    )


def wrong_division_by_zero(q):
    """ValueError"""
    n, a = q[1:] / np.sqrt(1 - q[0] ** 2), 2 * np.arccos(q[0])
    return np.eye(3) + np.sin(a) * hat(n) + (1 - np.cos(a)) * hat(n) @ hat(n)


def wrong_four_by_four(q):
    """another form"""
    w, x, y, z = q
    left = np.array([[w, -x, -y, -z], [x, w, -z, y], [y, z, w, -x], [z, -y, x, w]])
    right = np.array([[w, x, y, z], [-x, w, -z, y], [-y, z, w, -x], [-z, -y, x, w]])
    return left @ right


def wrong_right_about_x_only(q):
    """unnamed"""
    return rot_x(2 * np.arctan2(q[1], q[0]))


def wrong_printed(q):
    """a return is missing"""
    w, V = q[0], hat(q[1:])
    print(np.eye(3) + 2 * w * V + 2 * V @ V)


def wrong_name(q):
    """NameError"""
    return np.eye(3) + 2 * w * hat(v) + 2 * hat(v) @ hat(v)


def wrong_the_librarys(q):
    """course_lib.rotations.quaternion_to_matrix is called"""
    return r.quaternion_to_matrix(q)


def wrong_brackets_missing(q):
    """a factor 2 is missing"""
    w, x, y, z = q
    return np.array(
        [
            [1 - 2 * (y * y + z * z), 2 * x * y - w * z, 2 * x * z + w * y],
            [2 * x * y + w * z, 1 - 2 * (x * x + z * z), 2 * y * z - w * x],
            [2 * x * z - w * y, 2 * y * z + w * x, 1 - 2 * (x * x + y * y)],
        ]
    )


def wrong_square_of_w(q):
    """w is missing, or squared"""
    V = hat(q[1:])
    return np.eye(3) + 2 * q[0] ** 2 * V + 2 * V @ V


def wrong_elementwise_square(q):
    """entry by entry"""
    V = hat(q[1:])
    return np.eye(3) + 2 * q[0] * V + 2 * V**2


def wrong_y_and_z_swapped(q):
    """two of x, y, z are swapped"""
    w, x, z, y = q
    V = hat([x, y, z])
    return np.eye(3) + 2 * w * V + 2 * V @ V


def wrong_whole_q_in_hat(q):
    """ValueError"""
    V = hat(q)
    return np.eye(3) + 2 * q[0] * V + 2 * V @ V


def wrong_sign_of_the_square(q):
    """the squares on the diagonal"""
    V = hat(q[1:])
    return np.eye(3) + 2 * q[0] * V - 2 * V @ V


def wrong_no_identity(q):
    """the identity is missing"""
    V = hat(q[1:])
    return 2 * q[0] * V + 2 * V @ V
