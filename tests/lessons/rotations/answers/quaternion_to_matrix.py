"""What students write for quaternion_to_matrix(q)."""

import numpy as np

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


def _product(p, q):
    scalar = p[0] * q[0] - p[1:] @ q[1:]
    return np.array([scalar, *(p[0] * q[1:] + q[0] * p[1:] + np.cross(p[1:], q[1:]))])


def right_sandwich(q):
    conjugate = q * np.array([1, -1, -1, -1])
    columns = [_product(_product(q, np.array([0, *e])), conjugate)[1:] for e in np.eye(3)]
    return np.stack(columns, axis=1)


def wrong_angle_by_arccos(q):
    """the answers to some inputs only are wrong"""
    half = np.arccos(np.clip(q[0], -1, 1))
    sine = np.linalg.norm(q[1:])
    axis = q[1:] / sine if sine > 0 else np.zeros(3)
    x, y, z = axis
    N = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    return np.eye(3) + np.sin(2 * half) * N + (1 - np.cos(2 * half)) * N @ N


def wrong_w_as_a_root(q):
    """the sign of w is lost"""
    v = np.array(q[1:], float)
    w = np.sqrt(max(0.0, 1 - v @ v))
    V = hat(v)
    return np.eye(3) + 2 * w * V + 2 * V @ V


def wrong_arccos_of_w(q):
    """the answers to some inputs only are wrong"""
    a, size = 2 * np.arccos(np.clip(q[0], -1, 1)), np.linalg.norm(q[1:])
    if size == 0:
        return np.eye(3)
    N = hat(q[1:] / size)
    return np.eye(3) + np.sin(a) * N + (1 - np.cos(a)) * N @ N
