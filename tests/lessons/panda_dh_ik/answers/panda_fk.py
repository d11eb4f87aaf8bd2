"""What students write for panda_fk(q)."""

import numpy as np

from course_lib import arms, rigid
from course_lib.arguments import read_only
from course_lib.lessons.panda_dh_ik.exercises.shared import TABLE
from course_lib.rotations import rot_x, rot_z

KEPT = read_only(rigid.transform(np.eye(3), [-0.2, 0.13, 0.6]))  # as in the notebook
FLANGE = rigid.transform(np.eye(3), [0, 0, 0.107])


def step(a, alpha, d, theta):
    return rigid.transform(rot_x(alpha), [a, 0, 0]) @ rigid.transform(rot_z(theta), [0, 0, d])


def right_step_by_step(q):
    T, frames = rigid.transform(np.eye(3), [-0.2, 0.13, 0.6]), []
    for row, theta in zip(TABLE, q):
        T = T @ step(*row, theta)
        frames.append(T)
    return np.array([*frames, T @ FLANGE])


def right_base_added_at_last_as_lists(q):
    frames, T, rows = np.zeros((8, 4, 4)), np.eye(4), [*TABLE, [0, 0, 0.107]]
    for i, theta in enumerate([*q, 0]):
        T = T @ step(*rows[i], theta)
        frames[i] = T
    frames[:, :3, 3] += [-0.2, 0.13, 0.6]
    return frames.tolist()


def right_by_screws(q):
    home, T, frames = right_step_by_step(np.zeros(7)), np.eye(4), []
    for i in range(7):
        z, o = home[i, :3, 2], home[i, :3, 3]
        T = T @ rigid.exp_se3(np.concatenate([z, np.cross(o, z)]) * q[i])
        frames.append(T @ home[i])
    return np.stack([*frames, T @ home[7]])


def wrong_base_too(q):
    """one pose too many"""
    return [KEPT, *right_step_by_step(q)]


def wrong_base_changed_in_place(q, T=KEPT.copy()):
    """kept from one call to the next"""
    frames = []
    for row, theta in zip(TABLE, q):
        T[:] = T @ step(*row, theta)
        frames.append(T.copy())
    return np.array([*frames, T @ FLANGE])


def wrong_base_multiplied_in_place(q):
    """read-only"""
    T, frames = KEPT, []
    for row, theta in zip(TABLE, q):
        T @= step(*row, theta)
        frames.append(T.copy())
    return np.array([*frames, T @ FLANGE])


def wrong_the_librarys_table(q):
    """course_lib.arms.SerialArm is called"""
    return KEPT @ arms.SerialArm.from_dh([arms.DHRow(*row) for row in TABLE], end=FLANGE).frames(q)


def wrong_without_the_flange(q):
    """there is one pose too few"""
    return right_step_by_step(q)[:-1]
