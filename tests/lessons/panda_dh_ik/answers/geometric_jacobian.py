"""What students write for geometric_jacobian(frames)."""

import numpy as np

from course_lib.rigid import adjoint, inverse, transform


def right_all_joints_at_once(frames):
    z, o, p = frames[:-1, :3, 2], frames[:-1, :3, 3], frames[-1, :3, 3]
    return np.vstack([np.cross(z, p - o).T, z.T])


def right_from_the_space_jacobian(frames):
    z, o = frames[:-1, :3, 2], frames[:-1, :3, 3]
    space = np.hstack([z, np.cross(o, z)]).T
    return np.roll(adjoint(transform(np.eye(3), -frames[-1, :3, 3])) @ space, 3, axis=0).tolist()


def right_seen_from_each_joint(frames):
    """The joint's own frame sees the flange at r: there the velocity is (-r_y, r_x, 0)."""
    J = np.empty((6, len(frames) - 1))
    for i, frame in enumerate(frames[:-1]):
        r = inverse(frame) @ frames[-1] @ [0, 0, 0, 1]
        J[:3, i] = frame[:3, :3] @ [-r[1], r[0], 0]
        J[3:, i] = frame[:3, 2]
    return J


def wrong_flange_counted(frames):
    """the flange's frame is counted as the frame of a joint"""
    z, o, p = frames[:, :3, 2], frames[:, :3, 3], frames[-1, :3, 3]
    return np.vstack([np.cross(z, p - o).T, z.T])


def wrong_list_kept_between_calls(frames, columns=[]):
    """something is kept from one call to the next"""
    for frame in frames[:-1]:
        columns.append(
            np.r_[np.cross(frame[:3, 2], frames[-1, :3, 3] - frame[:3, 3]), frame[:3, 2]]
        )
    return np.array(columns).T


def wrong_seven_joints_only(frames):
    """index 7 is out of bounds"""
    return np.array(
        [np.r_[np.cross(frames[i, :3, 2], frames[7, :3, 3]), frames[i, :3, 2]] for i in range(7)]
    ).T


def wrong_columns_in_the_cross_product(frames):
    """incompatible dimensions for cross product"""
    p, J = frames[-1, :3, 3:], np.zeros((6, len(frames) - 1))
    for i, frame in enumerate(frames[:-1]):
        J[:3, i] = np.cross(frame[:3, 2:3], p - frame[:3, 3:])
        J[3:, i] = frame[:3, 2]
    return J


def wrong_more_than_seven_joints_left_out(frames):
    """the arm is taken to have seven joints"""
    return right_all_joints_at_once(frames)[:, :7]


def wrong_no_column_for_a_joint_at_the_flange(frames):
    """the answers to some inputs only are wrong"""
    at_flange = np.linalg.norm(frames[:-1, :3, 3] - frames[-1, :3, 3], axis=1) < 1e-12
    return right_all_joints_at_once(frames) * ~at_flange
