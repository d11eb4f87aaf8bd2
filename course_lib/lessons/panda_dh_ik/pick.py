"""What a motion of the Panda with its gripper may do.

The arm must stay clear of the worktop, of the mug and of itself. The motion must keep the bounds of
the motors.

The moving links and the gripper are approximated by balls, which leave out no more than 2 cm of a
bulge. The mug is approximated by a cylinder, and its handle by a ball. All poses are seen from the
world, where the arm stands on a worktop.

Source of the bounds: Franka Emika, Franka Control Interface documentation, limits for the Panda.
"""

import numpy as np

from course_lib.arguments import read_only, real_array
from course_lib.arms import panda
from course_lib.rigid import checked_pose, transform
from course_lib.rotations import rot_x, rot_z

# The largest speeds and accelerations of the seven joints, in rad/s and rad/s^2.
MAX_SPEEDS = np.array([2.175, 2.175, 2.175, 2.175, 2.61, 2.61, 2.61])
MAX_ACCELERATIONS = np.array([15, 7.5, 10, 12.5, 15, 20, 20.0])
# The pose of the arm's base in the world.
BASE = read_only(transform(np.eye(3), [-0.2, 0.13, 0.6]))
# The pose of the gripper's frame, between its fingertips.
IN_FLANGE = read_only(transform(rot_z(-np.pi / 4), [0, 0, 0.1034]))
# The pose of the gripper when it grasps from above.
IN_MUG = read_only(transform(rot_x(np.pi), [0, 0, 0.06]))
# These are in metres: the height of the worktop, the cylinder of the mug, and the ball of its
# handle (centre x, y, z and radius).
_WORKTOP = 0.6
_MUG_RADIUS = 0.035
_MUG_HEIGHT = 0.09
_HANDLE = (0.05, 0, 0.05, 0.02)
# Between two rows a trajectory is examined in steps of _STEP radians, but in at most _MAX_STEPS.
_STEP = 0.02
_MAX_STEPS = 50
# Rows of balls along the links: the number of a frame of arms.panda().frames, the first and last
# centre in it and the radius in metres, and the number of balls.
_ROWS = [
    (0, (0, 0, -0.28), (0, 0, 0), 0.075, 4),
    (1, (0, 0, -0.06), (0, 0, 0.06), 0.075, 3),
    (2, (0, 0, -0.3), (0, 0, 0), 0.075, 6),
    (3, (0, 0, -0.06), (0, 0, 0.06), 0.075, 3),
    (4, (0, 0, -0.38), (0, 0.02, 0), 0.068, 7),
    (5, (0, 0, -0.04), (0, 0, 0.04), 0.07, 3),
    (6, (0, 0, 0), (0, 0, 0.08), 0.055, 3),
]
# Rows of balls on the gripper, open by 8 cm: y and z of the first and last centre in the gripper's
# frame, the radius, and the number of balls.
_GRIPPER = [((-0.065, -0.07), (0.065, -0.07), 0.035, 3)]
_GRIPPER += [((0.048 * side, -0.035), (0.048 * side, -0.005), 0.008, 3) for side in (-1, 1)]


_FLANGE = 7  # the number of the flange's frame


def _balls():
    """Return the frame (m,), the centre in it (m, 3) and the radius (m,) of each ball."""
    rows = [(frame, np.linspace(a, b, n), r) for frame, a, b, r, n in _ROWS]
    for (y, z), (y1, z1), r, n in _GRIPPER:
        in_gripper = np.linspace([0, y, z], [0, y1, z1], n)
        in_flange = in_gripper @ IN_FLANGE[:3, :3].T + IN_FLANGE[:3, 3]
        rows.append((_FLANGE, in_flange, r))
    frames, centres, radii = zip(*rows, strict=True)
    counts = [len(row) for row in centres]
    return np.repeat(frames, counts), np.concatenate(centres), np.repeat(radii, counts)


_FRAME, _CENTRE, _RADIUS = _balls()
# The balls of the gripper must stay apart from those of links 0 to 4, and the balls of links 5
# and 6 from those of links 0 to 2. Neighbouring links always touch.
_GRIPPER_AND_ARM = (_FRAME[:, None] == _FLANGE) & (_FRAME <= 4)
_WRIST_AND_SHOULDER = (_FRAME[:, None] >= 5) & (_FRAME <= 2)
_SEPARATE = np.argwhere(_GRIPPER_AND_ARM | _WRIST_AND_SHOULDER)


def between(trajectory):
    """Return the times and joint angles of a trajectory, and of steps between its rows.

    The steps are of 0.02 rad, and at most 50 between two rows.

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
    largest_change = np.abs(np.diff(trajectory[:, 1:], axis=0)).max(1)
    n = np.clip(np.ceil(largest_change / _STEP), 1, _MAX_STEPS).astype(int)
    start = np.repeat(np.arange(len(n)), n)
    # For n = [2, 3] this is [0, 1, 0, 1, 2], each divided by its n.
    part = (np.arange(n.sum()) - np.repeat(np.cumsum(n) - n, n)) / n[start]
    steps = trajectory[start] + part[:, None] * (trajectory[start + 1] - trajectory[start])
    steps = np.concatenate([steps, trajectory[-1:]])
    return steps[:, 0], steps[:, 1:]


def clearances(joints, T_mug):
    """Return the distances of the arm and its open gripper from the worktop, the mug and itself.

    A distance is negative if they touch.

    Parameters
    ----------
    joints : array_like (..., 7)
        Joint angles in radians.
    T_mug : array_like (4, 4)
        The mug's pose in the world: z up from the middle of its foot, the handle along x.

    Returns
    -------
    dict
        The distances (...) in metres for "worktop", "mug" and "itself".

    Examples
    --------
    >>> mug = transform(np.eye(3), [0.3, 0, 0.6])
    >>> distances = clearances([0, -0.8, 0, -2.4, 0, 1.6, 0.8], mug)
    >>> {name: float(distance.round(2)) for name, distance in distances.items()}
    {'worktop': 0.26, 'mug': 0.41, 'itself': 0.06}
    """
    joints, T_mug = real_array(joints, "joints", (7,)), checked_pose(T_mug, "T_mug", (4, 4))
    frames = (BASE @ panda().frames(joints))[..., _FRAME, :, :]
    centres = (frames[..., :3, :3] @ _CENTRE[..., None])[..., 0] + frames[..., :3, 3]
    # These coordinates are in the mug's frame. The distance of a centre from the cylinder follows
    # from how far it is beyond the side and beyond the ends. Inside the cylinder it is 0.
    x, y, z = np.moveaxis((centres - T_mug[:3, 3]) @ T_mug[:3, :3], -1, 0)
    beyond_side = np.hypot(x, y) - _MUG_RADIUS
    beyond_end = np.abs(z - _MUG_HEIGHT / 2) - _MUG_HEIGHT / 2
    cup = np.hypot(np.maximum(beyond_side, 0), np.maximum(beyond_end, 0))
    handle = np.sqrt((x - _HANDLE[0]) ** 2 + y**2 + (z - _HANDLE[2]) ** 2) - _HANDLE[3]
    one, other = _SEPARATE.T
    between_centres = np.linalg.norm(centres[..., one, :] - centres[..., other, :], axis=-1)
    gaps = between_centres - _RADIUS[one] - _RADIUS[other]
    moving = _FRAME > 0  # the base stands on the worktop
    return {
        "worktop": (centres[..., moving, 2] - _WORKTOP - _RADIUS[moving]).min(-1),
        "mug": (np.minimum(cup, handle) - _RADIUS).min(-1),
        "itself": gaps.min(-1),
    }


def shares(trajectory):
    """Return what share of the motors' bounds a trajectory uses at each row.

    A share of 1 is the most that the motors allow.

    Parameters
    ----------
    trajectory : array_like (n, 8)
        As for `between`. The arm is at rest before and after the trajectory.

    Returns
    -------
    speed, acceleration : array (n,)
        The shares of the joint nearest to its bound. A speed is taken between each row and the
        next, and an acceleration is the change of speed at a row.

    Examples
    --------
    >>> trajectory = [[t, q] + [0] * 6 for t, q in [(0, 0), (1, 1), (2, 1)]]
    >>> [share.round(2).tolist() for share in shares(trajectory)]
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
    speed = (np.abs(speeds[1:]) / MAX_SPEEDS).max(-1)
    acceleration = (np.abs(accelerations) / MAX_ACCELERATIONS).max(-1)
    return speed, acceleration
