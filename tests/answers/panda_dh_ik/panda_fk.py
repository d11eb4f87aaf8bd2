"""What students write for panda_fk(q)."""

import numpy as np

from course_lib import arms, rigid
from course_lib.rotations import rot_x, rot_z

QUARTER = np.pi / 2
TABLE = np.array(
    [
        [0, 0, 0.333],
        [0, -QUARTER, 0],
        [0, QUARTER, 0.316],
        [0.0825, QUARTER, 0],
        [-0.0825, -QUARTER, 0.384],
        [0, QUARTER, 0],
        [0.088, QUARTER, 0],
    ]
)
BASE = rigid.transform(np.eye(3), [-0.2, 0.13, 0.6])
FLANGE = rigid.transform(np.eye(3), [0, 0, 0.107])


def _x(a, alpha):
    return rigid.transform(rot_x(alpha), [a, 0, 0])


def _z(d, theta):
    return rigid.transform(rot_z(theta), [0, 0, d])


def _modified(a, alpha, d, theta):
    return _x(a, alpha) @ _z(d, theta)


def _standard(a, alpha, d, theta):
    return _z(d, theta) @ _x(a, alpha)


def _chain(q, table=TABLE, step=_modified, base=BASE, flange=FLANGE):
    T, frames = base, []
    for (a, alpha, d), theta in zip(table, q):
        T = T @ step(a, alpha, d, theta)
        frames.append(T)
    return np.array([*frames, T @ flange])


def right_step_by_step(q):
    T = rigid.transform(np.eye(3), [-0.2, 0.13, 0.6])
    frames = []
    for (a, alpha, d), theta in zip(TABLE, q):
        T = T @ _x(a, alpha) @ _z(d, theta)
        frames.append(T)
    frames.append(T @ rigid.transform(np.eye(3), [0, 0, 0.107]))
    return np.array(frames)


def right_base_put_in_front_at_last_as_lists(q):
    frames, T = np.zeros((8, 4, 4)), np.eye(4)
    rows = [*TABLE, [0, 0, 0.107]]
    for i, theta in enumerate([*q, 0]):
        T = T @ _modified(*rows[i], theta)
        frames[i] = T
    frames[:, :3, 3] += [-0.2, 0.13, 0.6]
    return frames.tolist()


def right_rotation_and_place_apart(q):
    R, p, frames = np.eye(3), np.array([-0.2, 0.13, 0.6]), []
    for (a, alpha, d), theta in zip(TABLE, q):
        p = p + a * R[:, 0]
        R = R @ rot_x(alpha)
        p = p + d * R[:, 2]
        R = R @ rot_z(theta)
        frames.append(np.vstack([np.column_stack([R, p]), [0, 0, 0, 1]]))
    frames.append(np.vstack([np.column_stack([R, p + 0.107 * R[:, 2]]), [0, 0, 0, 1]]))
    return frames


def right_by_screws(q):
    home, T, frames = _chain(np.zeros(7)), np.eye(4), []
    for i in range(7):
        z, o = home[i, :3, 2], home[i, :3, 3]
        T = T @ rigid.exp_se3(np.concatenate([z, np.cross(o, z)]) * q[i])
        frames.append(T @ home[i])
    return np.stack([*frames, T @ home[7]])


def right_by_the_standard_table(q):
    """The same chain with its brackets set otherwise: what is left of each step is taken off again."""
    up = np.vstack([TABLE[1:, :2], [0, 0]])
    T, frames = BASE, []
    for (a, alpha), d, theta in zip(up, TABLE[:, 2], q):
        frames.append(T @ _z(d, theta))
        T = T @ _standard(a, alpha, d, theta)
    return np.array([*frames, T @ FLANGE])


def right_one_whole_turn_further(q):
    return _chain(np.asarray(q) + 2 * np.pi)


def wrong_flange_left_out(q):
    """one of the eight is left out"""
    return _chain(q)[:7]


def wrong_flange_only(q):
    """only one pose is returned"""
    return _chain(q)[-1]


def wrong_places_only(q):
    """only the positions are returned"""
    return _chain(q)[:, :3, 3]


def wrong_base_too(q):
    """one pose too many"""
    return [BASE, *_chain(q)]


def wrong_joined_into_one_tall_matrix(q):
    """the poses are joined into one large matrix"""
    return np.vstack(list(_chain(q)))


def wrong_rounded(q):
    """first digits only"""
    return np.round(_chain(q), 6)


def wrong_pi_by_hand(q):
    """first digits only"""
    return _chain(q, TABLE * [1, 3.1416 / np.pi, 1])


def wrong_whole_numbers(q):
    """digits after the point are cut off"""
    return _chain(q).astype(int)


KEPT = BASE.copy()


def wrong_base_changed_in_place(q):
    """kept from one call to the next"""
    T, frames = KEPT, []
    for row, theta in zip(TABLE, q):
        T[:] = T @ _modified(*row, theta)
        frames.append(T.copy())
    return np.array([*frames, T @ FLANGE])


def wrong_list_kept_between_calls(q, frames=[BASE]):
    """kept from one call to the next"""
    for row, theta in zip(TABLE, q):
        frames.append(frames[-1] @ _modified(*row, theta))
    frames.append(frames[-1] @ FLANGE)
    return np.array(frames[1:])


def wrong_angles_changed_in_place(q):
    """q is changed in place"""
    q[6] += np.pi / 4
    return _chain(q)


def wrong_one_row_too_many(q):
    """IndexError"""
    return np.array([_modified(*TABLE[i], q[i]) for i in range(8)])


def wrong_limits_clipped(q):
    """unnamed"""
    return _chain(np.clip(q, -1.5, 1.5))


def wrong_angles_made_positive(q):
    """unnamed"""
    return _chain(np.abs(q))


def wrong_the_librarys(q):
    """course_lib.arms.panda is called"""
    return BASE @ arms.panda().frames(q)


def wrong_the_librarys_table(q):
    """course_lib.arms.SerialArm is called"""
    arm = arms.SerialArm.from_dh([arms.DHRow(*row) for row in TABLE], end=FLANGE)
    return BASE @ arm.frames(q)
