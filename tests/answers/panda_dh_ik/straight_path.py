"""What students write for straight_path(A, B, s)."""

import numpy as np
from scipy.spatial.transform import Rotation, Slerp

from course_lib import rigid, rotations


def right_in_a_batch(A, B, s):
    phi = rotations.log_so3(B[:3, :3] @ A[:3, :3].T)
    R = rotations.exp_so3(np.outer(s, phi)) @ A[:3, :3]
    return rigid.transform(R, A[:3, 3] + np.outer(s, B[:3, 3] - A[:3, 3]))


def right_one_after_the_other(A, B, s):
    phi = rotations.log_so3(A[:3, :3].T @ B[:3, :3])
    R = [A[:3, :3] @ rotations.exp_so3(share * phi) for share in s]
    return [rigid.transform(Q, (1 - share) * A[:3, 3] + share * B[:3, 3]) for Q, share in zip(R, s)]


def right_by_slerp(A, B, s):
    T = np.tile(np.eye(4), (len(s), 1, 1))
    T[:, :3, :3] = Slerp([0, 1], Rotation.from_matrix([A[:3, :3], B[:3, :3]]))(s).as_matrix()
    T[:, :3, 3] = A[:3, 3] + s[:, None] * (B - A)[:3, 3]
    return T


def wrong_quaternions_in_a_straight_line(A, B, s):
    """unnamed"""
    a, b = (rotations.matrix_to_quaternion(T[:3, :3]) for T in (A, B))
    b = b if a @ b >= 0 else -b
    R = rotations.quaternion_to_matrix(rotations.nearest_quaternion((1 - s)[:, None] * a + s[:, None] * b))
    return rigid.transform(R, A[:3, 3] + np.outer(s, B[:3, 3] - A[:3, 3]))


def wrong_rotation_only(A, B, s):
    """only positions or only rotations are returned"""
    return right_in_a_batch(A, B, s)[:, :3, :3]
