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
    path = []
    for share in s:
        T = np.eye(4)
        T[:3, :3] = A[:3, :3] @ rotations.exp_so3(share * phi)
        T[:3, 3] = (1 - share) * A[:3, 3] + share * B[:3, 3]
        path.append(T)
    return path


def right_by_slerp(A, B, s):
    T = np.tile(np.eye(4), (len(s), 1, 1))
    T[:, :3, :3] = Slerp([0, 1], Rotation.from_matrix([A[:3, :3], B[:3, :3]]))(s).as_matrix()
    T[:, :3, 3] = A[:3, 3] + s[:, None] * (B - A)[:3, 3]
    return T


def wrong_entries(A, B, s):
    """the entries of the matrices are interpolated"""
    return [(1 - share) * A + share * B for share in s]


def wrong_screw(A, B, s):
    """a screw motion"""
    twist = rigid.log_se3(rigid.inverse(A) @ B)
    return [A @ rigid.exp_se3(share * twist) for share in s]


def wrong_side(A, B, s):
    """the wrong side"""
    phi = rotations.log_so3(A[:3, :3].T @ B[:3, :3])
    R = rotations.exp_so3(np.outer(s, phi)) @ A[:3, :3]
    return rigid.transform(R, A[:3, 3] + np.outer(s, B[:3, 3] - A[:3, 3]))


def wrong_quaternions_in_a_straight_line(A, B, s):
    """unnamed"""
    a, b = (rotations.matrix_to_quaternion(T[:3, :3]) for T in (A, B))
    b = b if a @ b >= 0 else -b
    R = rotations.quaternion_to_matrix(rotations.nearest_quaternion((1 - s)[:, None] * a + s[:, None] * b))
    return rigid.transform(R, A[:3, 3] + np.outer(s, B[:3, 3] - A[:3, 3]))


def wrong_rotation_only(A, B, s):
    """only positions or only rotations are returned"""
    return right_in_a_batch(A, B, s)[:, :3, :3]


def wrong_last_pose(A, B, s):
    """only one pose is returned"""
    return right_in_a_batch(A, B, s)[-1]


def wrong_rotation_kept(A, B, s):
    """the rotation does not change"""
    return rigid.transform(A[:3, :3], A[:3, 3] + np.outer(s, B[:3, 3] - A[:3, 3]))


def wrong_number_of_poses(A, B, s):
    """s is not used"""
    return right_in_a_batch(A, B, np.linspace(0, 1, len(s)))
