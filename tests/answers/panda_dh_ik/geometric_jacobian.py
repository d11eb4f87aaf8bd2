"""What students write for geometric_jacobian(frames)."""

import numpy as np

from course_lib import arms
from course_lib.rigid import adjoint, exp_se3, inverse, transform
from course_lib.rotations import hat, log_so3


def right_all_joints_at_once(frames):
    z = frames[:-1, :3, 2]
    o = frames[:-1, :3, 3]
    p = frames[-1, :3, 3]
    return np.vstack([np.cross(z, p - o).T, z.T])


def right_in_a_loop_by_components(frames):
    n = len(frames) - 1
    J = np.zeros((6, n))
    x, y, z = frames[n][0][3], frames[n][1][3], frames[n][2][3]
    for i in range(n):
        a, b, c = frames[i][0][2], frames[i][1][2], frames[i][2][2]
        u, v, w = x - frames[i][0][3], y - frames[i][1][3], z - frames[i][2][3]
        J[:, i] = b * w - c * v, c * u - a * w, a * v - b * u, a, b, c
    return J


def right_lists_of_rows(frames):
    columns = []
    for frame in frames[:-1]:
        axis = frame[:3, :3] @ np.array([0, 0, 1])
        columns.append([*(hat(axis) @ (frames[-1, :3, 3] - frame[:3, 3])), *axis])
    return [list(row) for row in zip(*columns)]


def right_from_the_space_jacobian(frames):
    """Screw axes first, then moved to the flange's origin; at last the halves are swapped."""
    z, o = frames[:-1, :3, 2], frames[:-1, :3, 3]
    space = np.hstack([z, np.cross(o, z)]).T
    J = adjoint(transform(np.eye(3), -frames[-1, :3, 3])) @ space
    return np.roll(J, 3, axis=0)


def right_seen_from_each_joint(frames):
    """The joint's own frame sees the flange at r: there the velocity is (-r_y, r_x, 0)."""
    J = np.empty((6, len(frames) - 1))
    for i, frame in enumerate(frames[:-1]):
        r = inverse(frame) @ frames[-1] @ [0, 0, 0, 1]
        J[:3, i] = frame[:3, :3] @ [-r[1], r[0], 0]
        J[3:, i] = frame[:3, 2]
    return J


def right_by_half_turns_there_and_back(frames):
    """Central differences over a quarter of a circle, which are exact."""
    columns = []
    for frame in frames[:-1]:
        z, o = frame[:3, 2], frame[:3, 3]
        phi = exp_se3(np.concatenate([z, np.cross(o, z)]) * np.pi / 2)
        v = (phi @ frames[-1] - inverse(phi) @ frames[-1])[:3, 3] / 2
        columns.append(np.concatenate([v, log_so3(phi[:3, :3]) / (np.pi / 2)]))
    return np.column_stack(columns)


def _parts(frames):
    return frames[:-1, :3, 2], frames[:-1, :3, 3], frames[-1, :3, 3]


def _joined(v, omega):
    return np.vstack([np.transpose(v), np.transpose(omega)])


def wrong_transposed(frames):
    """rows and columns are swapped"""
    z, o, p = _parts(frames)
    return np.hstack([np.cross(z, p - o), z])


def wrong_body_jacobian_omega_first(frames):
    """unnamed"""
    z, o, p = _parts(frames)
    return adjoint(inverse(frames[-1])) @ _joined(z, np.cross(o, z))


def wrong_flange_counted(frames):
    """the flange's frame is counted as a joint's"""
    z, o, p = frames[:, :3, 2], frames[:, :3, 3], frames[-1, :3, 3]
    return _joined(np.cross(z, p - o), z)


def wrong_position_half_only(frames):
    """only one half of the Jacobian"""
    z, o, p = _parts(frames)
    return np.cross(z, p - o).T


def wrong_halves_in_a_pair(frames):
    """v and omega are not in one column"""
    z, o, p = _parts(frames)
    return np.cross(z, p - o).T, z.T


def wrong_large_step(frames):
    """first digits only"""
    columns, h = [], 1e-3
    for frame in frames[:-1]:
        z, o = frame[:3, 2], frame[:3, 3]
        phi = exp_se3(np.concatenate([z, np.cross(o, z)]) * h)
        columns.append([*((phi @ frames[-1] - frames[-1])[:3, 3] / h), *z])
    return np.array(columns).T


def wrong_changed_in_place(frames):
    """frames is changed in place"""
    frames[:, :3, 3] -= frames[-1, :3, 3].copy()
    return _joined(np.cross(frames[:-1, :3, 3], frames[:-1, :3, 2]), frames[:-1, :3, 2])


def wrong_list_kept_between_calls(frames, columns=[]):
    """something is kept from one call to the next"""
    for frame in frames[:-1]:
        columns.append(np.r_[np.cross(frame[:3, 2], frames[-1, :3, 3] - frame[:3, 3]), frame[:3, 2]])
    return np.array(columns).T


def wrong_seven_joints_only(frames):
    """index 7 is out of bounds"""
    columns = []
    for i in range(7):
        z, o = frames[i, :3, 2], frames[i, :3, 3]
        columns.append(np.concatenate([np.cross(z, frames[7, :3, 3] - o), z]))
    return np.column_stack(columns)


def wrong_absolute_velocity(frames):
    """unnamed"""
    z, o, p = _parts(frames)
    return _joined(np.abs(np.cross(z, p - o)), z)


def wrong_the_librarys(frames):
    """course_lib.arms.SerialArm is called"""
    arm = arms.SerialArm.from_screws(frames[:-1, :3, 2], frames[:-1, :3, 3], frames[-1])
    return np.roll(arm.geometric_jacobian(np.zeros(arm.n)), 3, axis=0)
