"""What students write for tool_positions(screws, M, angles)."""

import numpy as np
import scipy.linalg

from course_lib.rigid import exp_se3, hat_se3


def right_M_at_the_end(screws, M, angles):
    path = []
    for q in angles:
        T = np.eye(4)
        for S, angle in zip(screws, q):
            T = T @ exp_se3(S * angle)
        path.append((T @ M)[:3, 3])
    return np.array(path)


def right_beginning_with_M(screws, M, angles):
    path = []
    for q in angles:
        x = M[:, 3]
        for i in reversed(range(len(q))):
            x = scipy.linalg.expm(hat_se3(screws[i]) * q[i]) @ x
        path.append(list(x[:3]))
    return path


def right_all_rows_at_once(screws, M, angles):
    x = np.tile(M[:, 3], (len(angles), 1))
    for i in range(len(screws) - 1, -1, -1):
        x = np.einsum("kij,kj->ki", exp_se3(angles[:, i, None] * screws[i]), x)
    return x[:, :3]


def wrong_M_added(screws, M, angles):
    """only the position of M is added"""
    path = []
    for q in angles:
        T = np.eye(4)
        for S, angle in zip(screws, q):
            T = T @ exp_se3(S * angle)
        path.append(T[:3, 3] + M[:3, 3])
    return np.array(path)


def wrong_M_first(screws, M, angles):
    """M stands on the left"""
    path = []
    for q in angles:
        T = M
        for S, angle in zip(screws, q):
            T = T @ exp_se3(S * angle)
        path.append(T[:3, 3])
    return np.array(path)


def wrong_M_carried_over(screws, M, angles):
    """from row to row"""
    path, T = [], np.eye(4)
    for q in angles:
        for S, angle in zip(screws, q):
            T = T @ exp_se3(S * angle)
        path.append((T @ M)[:3, 3])
    return np.array(path)


def wrong_unchanged(screws, M, angles):
    """unnamed"""
    path = []
    for q in angles:
        T = np.eye(4)
        for S, angle in zip(screws, q):
            T = T @ exp_se3(S * angle)
        path.append(T[:3, 3])
    return np.array(path)


def wrong_last_row(screws, M, angles):
    """a row of T is returned"""
    return np.array([_pose(screws, M, q)[3, :3] for q in angles])


def _pose(screws, M, q):
    T = np.eye(4)
    for S, angle in zip(screws, q):
        T = T @ exp_se3(S * angle)
    return T @ M


def wrong_whole_poses(screws, M, angles):
    """whole poses"""
    return [_pose(screws, M, q) for q in angles]


def wrong_returns_in_the_loop(screws, M, angles):
    """only one position"""
    for q in angles:
        return _pose(screws, M, q)[:3, 3]


def wrong_M_times_each(screws, M, angles):
    """once for each joint"""
    path = []
    for q in angles:
        T = np.eye(4)
        for S, angle in zip(screws, q):
            T = T @ exp_se3(S * angle) @ M
        path.append(T[:3, 3])
    return np.array(path)


def wrong_transposed(screws, M, angles):
    """rows and columns are swapped"""
    return right_M_at_the_end(screws, M, angles).T.copy() if len(angles) != 3 else np.zeros((4, 4))


def wrong_M_changed(screws, M, angles):
    """M is changed in place"""
    path = []
    for q in angles:
        M[:] = _pose(screws, M, q)
        path.append(M[:3, 3].copy())
    return path


def wrong_joint_1_first(screws, M, angles):
    """the exponentials are multiplied in the reverse order"""
    positions = []
    for q in angles:
        x = M[:, 3]
        for i in range(len(q)):
            x = exp_se3(screws[i] * q[i]) @ x
        positions.append(x[:3])
    return np.array(positions)


def wrong_joint_1_first_without_M(screws, M, angles):
    """the exponentials are multiplied in the reverse order"""
    positions = []
    for q in angles:
        x = np.array([0, 0, 0, 1.0])
        for S, angle in zip(screws, q, strict=True):
            x = exp_se3(S * angle) @ x
        positions.append(x[:3])
    return positions
