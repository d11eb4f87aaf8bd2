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


def wrong_base_left_out(q):
    """the base is left out"""
    return _chain(q, base=np.eye(4))


def wrong_base_on_the_right(q):
    """the base is the right factor"""
    return _chain(q, base=np.eye(4)) @ BASE


def wrong_base_for_the_flange_only(q):
    """the base is the left factor of some poses only"""
    T = _chain(q, base=np.eye(4))
    T[-1] = BASE @ T[-1]
    return T


def wrong_base_with_every_step(q):
    """the base comes in with every step"""
    return _chain(q, base=np.eye(4), step=lambda *row: BASE @ _modified(*row))


def wrong_base_inverted(q):
    """the inverse of the base's pose is taken"""
    return _chain(q, base=np.linalg.inv(BASE))


def wrong_base_without_its_sign(q):
    """the base has a wrong coordinate"""
    return _chain(q, base=rigid.transform(np.eye(3), [0.2, 0.13, 0.6]))


def wrong_flange_left_out(q):
    """one of the eight is left out"""
    return _chain(q)[:7]


def wrong_flange_where_frame_7_is(q):
    """the flange is left where frame 7 is"""
    return _chain(q, flange=np.eye(4))


def wrong_flange_along_the_worlds_z(q):
    """the flange is moved along the world's z"""
    frames = _chain(q, flange=np.eye(4))
    frames[-1, 2, 3] += 0.107
    return frames


def wrong_flange_twice(q):
    """the flange comes in twice"""
    table = TABLE.copy()
    table[6, 2] = 0.107
    return _chain(q, table)


def wrong_flange_in_the_last_row(q):
    """the flange is put into frame 7 already"""
    table = TABLE.copy()
    table[6, 2] = 0.107
    return _chain(q, table, flange=np.eye(4))


def wrong_report_0136(q):
    """0.136 stands for 0.316"""
    table = TABLE.copy()
    table[2, 2] = 0.136
    return _chain(q, table)


def wrong_report_0109(q):
    """0.109 stands for 0.107"""
    return _chain(q, flange=rigid.transform(np.eye(3), [0, 0, 0.109]))


def wrong_standard_convention(q):
    """the standard convention is taken with the modified table"""
    return _chain(q, step=_standard)


def wrong_standard_table(q):
    """the standard table is taken with the modified convention"""
    return _chain(q, np.column_stack([np.vstack([TABLE[1:, :2], [0, 0]]), TABLE[:, 2]]))


def wrong_frames_of_the_standard_convention(q):
    """these are the frames of the standard convention"""
    return _chain(q, np.column_stack([np.vstack([TABLE[1:, :2], [0, 0]]), TABLE[:, 2]]), _standard)


def wrong_the_reports_table(q):
    """the report's printed table is taken"""
    alpha = np.array([-1, 1, -1, 1, -1, -1, 0]) * QUARTER
    a = [0, 0, 0.0825, -0.0825, 0, 0.088, 0]
    d = [0.333, 0, 0.136, 0, 0.384, 0, 0.109]
    return _chain(q, np.column_stack([a, alpha, d]), _standard, flange=np.eye(4))


def wrong_not_multiplied_up(q):
    """not multiplied up"""
    steps = [_modified(*row, theta) for row, theta in zip(TABLE, q)]
    return np.array([*steps, FLANGE])


def wrong_not_multiplied_up_each_on_the_base(q):
    """not multiplied up"""
    return BASE @ np.array([*(_modified(*row, theta) for row, theta in zip(TABLE, q)), FLANGE])


def wrong_reverse_order(q):
    """in the reverse order"""
    T, frames = BASE, []
    for row, theta in zip(TABLE, q):
        T = _modified(*row, theta) @ T
        frames.append(T)
    return np.array([*frames, FLANGE @ T])


def wrong_one_matrix_in_the_list(q):
    """one and the same matrix"""
    T, frames = BASE.copy(), []
    for row, theta in zip(TABLE, q):
        T[:] = T @ _modified(*row, theta)
        frames.append(T)
    return np.array([*frames, T @ FLANGE])


def wrong_joints_4_and_6(q):
    """joints 4 and 6 rotate the other way, as in the report's table"""
    return _chain(np.array([1, 1, 1, -1, 1, -1, 1]) * q)


def wrong_signs_of_a(q):
    """the signs of a in rows 4 and 5"""
    return _chain(q, TABLE * np.array([[1, 1, 1]] * 3 + [[-1, 1, 1]] * 2 + [[1, 1, 1]] * 2))


def wrong_sign_of_alpha_5(q):
    """alpha has the wrong sign in some row"""
    table = TABLE.copy()
    table[4, 1] *= -1
    return _chain(q, table)


def wrong_entry_left_out(q):
    """an entry of the table is left out"""
    table = TABLE.copy()
    table[6, 0] = 0
    return _chain(q, table)


def wrong_columns_mixed_up(q):
    """the columns of the table are mixed up"""
    return _chain(q, TABLE[:, [2, 1, 0]])


def wrong_turn_of_the_hand(q):
    """the last frame or the flange is rotated by pi/4, as the gripper is"""
    return _chain(q + np.array([0, 0, 0, 0, 0, 0, -np.pi / 4]))


def wrong_turn_of_the_hand_in_the_flange(q):
    """the last frame or the flange is rotated by pi/4, as the gripper is"""
    return _chain(q, flange=_z(0.107, -np.pi / 4))


def wrong_flange_only(q):
    """only one pose is returned"""
    return _chain(q)[-1]


def wrong_places_only(q):
    """only the positions are returned"""
    return _chain(q)[:, :3, 3]


def wrong_base_too(q):
    """one pose too many"""
    return [BASE, *_chain(q)]


def wrong_base_for_the_flange(q):
    """the base is the first pose and the flange is left out"""
    return [BASE, *_chain(q)[:7]]


def wrong_joined_into_one_tall_matrix(q):
    """the poses are joined into one large matrix"""
    return np.vstack(list(_chain(q)))


def wrong_degrees(q):
    """degrees"""
    return _chain(np.deg2rad(q))


def wrong_angles_one_joint_off(q):
    """the angles go with the wrong joints"""
    return _chain(np.roll(q, 1))


def wrong_angles_backwards(q):
    """the angles go with the wrong joints"""
    return _chain(q[::-1])


def wrong_entry_by_entry(q):
    """entry by entry"""
    T, frames = BASE, []
    for row, theta in zip(TABLE, q):
        T = T * _modified(*row, theta)
        frames.append(T)
    return np.array([*frames, T * FLANGE])


def wrong_inverses(q):
    """the inverse is returned"""
    return np.linalg.inv(_chain(q))


def wrong_transposed(q):
    """the poses are transposed"""
    return _chain(q).swapaxes(1, 2)


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


def wrong_both_misprints_of_the_report(q):
    """0.136 stands for 0.316"""
    table = TABLE.copy()
    table[2, 2] = 0.136
    return _chain(q, table, flange=rigid.transform(np.eye(3), [0, 0, 0.109]))


def wrong_joint_4_alone(q):
    """some joint rotates the other way"""
    return _chain(q * [1, 1, 1, -1, 1, 1, 1])


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
