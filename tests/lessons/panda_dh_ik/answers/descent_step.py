"""What students write for descent_step(q, J, T, T_target, step), whose cell holds broken code."""

import numpy as np

from course_lib import rigid, rotations


def pose_error(T, T_target):
    phi = rotations.log_so3(T_target[:3, :3] @ T[:3, :3].T)
    return np.concatenate([T_target[:3, 3] - T[:3, 3], phi])


def right_by_pose_error(q, J, T, T_target, step):
    return q + step * J.T @ pose_error(T, T_target)


def right_lines_corrected(q, J, T, T_target, step):
    X = T @ rigid.inverse(T_target)
    e = np.concatenate([T[:3, 3] - T_target[:3, 3], rotations.log_so3(X[:3, :3])])
    return q - step * J.T @ e


def right_by_rows_of_J(q, J, T, T_target, step):
    e = pose_error(T, T_target)
    return [angle + step * sum(J[k, i] * e[k] for k in range(6)) for i, angle in enumerate(q)]
