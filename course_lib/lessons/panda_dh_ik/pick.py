"""What a motion of the Panda with its gripper may do: stay clear of table, mug and itself, within bounds of its motors.

The moving links and the gripper are approximated by balls, which leave out no more than 2 cm of a
bulge; the mug by a cylinder and a ball for the handle. All poses are seen from the world, where the
arm stands on a table.

Source of the bounds: Franka Emika, Franka Control Interface documentation, limits for the Panda.
"""

import numpy as np

from course_lib.arguments import read_only, real_array
from course_lib.arms import panda
from course_lib.rigid import checked_pose, transform
from course_lib.rotations import rot_x, rot_z

FASTEST = np.array([2.175, 2.175, 2.175, 2.175, 2.61, 2.61, 2.61])  # rad/s
HARDEST = np.array([15, 7.5, 10, 12.5, 15, 20, 20.0])  # rad/s^2
BASE = read_only(transform(np.eye(3), [-0.2, 0.13, 0.6]))  # of the arm, in the world
# the gripper's frame, between its fingertips
IN_FLANGE = read_only(transform(rot_z(-np.pi / 4), [0, 0, 0.1034]))
IN_MUG = read_only(transform(rot_x(np.pi), [0, 0, 0.06]))  # the gripper when it grasps, from above
_TABLE, _MUG_RADIUS, _MUG_HEIGHT, _HANDLE = 0.6, 0.035, 0.09, (0.05, 0, 0.05, 0.02)
_STEP, _MOST_STEPS = 0.02, 50  # radians
_ROWS = [  # a row of balls: frame of arms.panda().frames, first and last centre, radius, how many
    (0, (0, 0, -0.28), (0, 0, 0), 0.075, 4),
    (1, (0, 0, -0.06), (0, 0, 0.06), 0.075, 3),
    (2, (0, 0, -0.3), (0, 0, 0), 0.075, 6),
    (3, (0, 0, -0.06), (0, 0, 0.06), 0.075, 3),
    (4, (0, 0, -0.38), (0, 0.02, 0), 0.068, 7),
    (5, (0, 0, -0.04), (0, 0, 0.04), 0.07, 3),
    (6, (0, 0, 0), (0, 0, 0.08), 0.055, 3),
]
# y and z in the gripper's frame, open by 8 cm
_GRIPPER = [((-0.065, -0.07), (0.065, -0.07), 0.035, 3)]
_GRIPPER += [((0.048 * side, -0.035), (0.048 * side, -0.005), 0.008, 3) for side in (-1, 1)]


def _balls():
    """Return the frame (m,), the centre in it (m, 3) and the radius (m,) of each ball."""
    rows = [(frame, np.linspace(a, b, n), r) for frame, a, b, r, n in _ROWS]
    for (y, z), (y1, z1), r, n in _GRIPPER:
        rows.append(
            (7, np.linspace([0, y, z], [0, y1, z1], n) @ IN_FLANGE[:3, :3].T + IN_FLANGE[:3, 3], r)
        )
    frames, centres, radii = zip(*rows, strict=True)
    counts = [len(each) for each in centres]
    return np.repeat(frames, counts), np.concatenate(centres), np.repeat(radii, counts)


_FRAME, _CENTRE, _RADIUS = _balls()
_APART = [
    (i, j)
    for i, f in enumerate(_FRAME)
    for j, g in enumerate(_FRAME)
    if (f == 7 and g <= 4) or (f >= 5 and g <= 2)
]


def between(trajectory):
    """Return the times and joint angles of a trajectory, and of steps of 0.02 rad between its rows, at most 50 of them.

    Parameters
    ----------
    trajectory : array_like (n, 8)
        In each row the time in seconds and the joint angles in radians.

    Returns
    -------
    times : array (m,)
    joints : array (m, 7)

    Examples
    --------
    >>> between([[0] * 8, [1, 0.04] + [0] * 6])[0]
    array([0. , 0.5, 1. ])
    """
    trajectory = real_array(trajectory, "trajectory", ("n", 8), batched=False)
    n = np.clip(
        np.ceil(np.abs(np.diff(trajectory[:, 1:], axis=0)).max(1) / _STEP), 1, _MOST_STEPS
    ).astype(int)
    start = np.repeat(np.arange(len(n)), n)
    part = (np.arange(n.sum()) - np.repeat(np.cumsum(n) - n, n)) / n[start]
    steps = trajectory[start] + part[:, None] * (trajectory[start + 1] - trajectory[start])
    steps = np.concatenate([steps, trajectory[-1:]])
    return steps[:, 0], steps[:, 1:]


def clearances(joints, T_mug):
    """Return how far the arm and its open gripper are from table, mug and itself; negative where they touch.

    Parameters
    ----------
    joints : array_like (..., 7)
        Joint angles in radians.
    T_mug : array_like (4, 4)
        The mug's pose in the world: z up from the middle of its foot, the handle along x.

    Returns
    -------
    dict
        The distances (...) in metres for "table", "mug" and "itself".

    Examples
    --------
    >>> mug = transform(np.eye(3), [0.3, 0, 0.6])
    >>> found = clearances([0, -0.8, 0, -2.4, 0, 1.6, 0.8], mug)
    >>> {what: float(distance.round(2)) for what, distance in found.items()}
    {'table': 0.26, 'mug': 0.41, 'itself': 0.06}
    """
    joints, T_mug = real_array(joints, "joints", (7,)), checked_pose(T_mug, "T_mug", (4, 4))
    frames = (BASE @ panda().frames(joints))[..., _FRAME, :, :]
    at = (frames[..., :3, :3] @ _CENTRE[..., None])[..., 0] + frames[..., :3, 3]
    x, y, z = np.moveaxis((at - T_mug[:3, 3]) @ T_mug[:3, :3], -1, 0)
    beside, above = np.hypot(x, y) - _MUG_RADIUS, np.abs(z - _MUG_HEIGHT / 2) - _MUG_HEIGHT / 2
    cup = np.hypot(np.maximum(beside, 0), np.maximum(above, 0))
    handle = np.sqrt((x - _HANDLE[0]) ** 2 + y**2 + (z - _HANDLE[2]) ** 2) - _HANDLE[3]
    one, other = np.transpose(_APART)
    apart = (
        np.linalg.norm(at[..., one, :] - at[..., other, :], axis=-1) - _RADIUS[one] - _RADIUS[other]
    )
    moving = _FRAME > 0
    return {
        "table": (at[..., moving, 2] - _TABLE - _RADIUS[moving]).min(-1),
        "mug": (np.minimum(cup, handle) - _RADIUS).min(-1),
        "itself": apart.min(-1),
    }


def shares(trajectory):
    """Return what share of its bounds a trajectory uses at each row: 1 is the most that the motors allow.

    Parameters
    ----------
    trajectory : array_like (n, 8)
        As for between. The arm is at rest before and after it.

    Returns
    -------
    speed, acceleration : array (n,)
        Of the joint nearest to its bound: speeds between each row and the next, and their changes
        at each row.

    Examples
    --------
    >>> [share.round(2).tolist() for share in shares([[t, q] + [0] * 6 for t, q in [(0, 0), (1, 1), (2, 1)]])]
    [[0.46, 0.0, 0.0], [0.07, 0.07, 0.0]]
    """
    trajectory = real_array(trajectory, "trajectory", ("n", 8), batched=False)
    dt, dq = np.diff(trajectory[:, 0]), np.diff(trajectory[:, 1:], axis=0)
    if not len(dt) or dt.min() <= 0:
        raise ValueError("trajectory must have two rows or more, with times that increase")
    rest = np.zeros((1, 7))
    speeds = np.concatenate([rest, dq / dt[:, None], rest])
    around = np.concatenate([dt[:1], (dt[1:] + dt[:-1]) / 2, dt[-1:]])
    accelerations = np.diff(speeds, axis=0) / around[:, None]
    return (np.abs(speeds[1:]) / FASTEST).max(-1), (np.abs(accelerations) / HARDEST).max(-1)
