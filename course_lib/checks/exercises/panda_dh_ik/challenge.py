"""The mugs of notebook 5: their key points, what a camera sees of them, and what counts as picked."""

import numpy as np

from course_lib.arms import panda
from course_lib.checks.exercises.panda_dh_ik.shared import T_W0
from course_lib.rigid import inverse, transform
from course_lib.rotations import rot_z

# Key points of the template in metres, in the mug's frame: z up from the middle of its foot, the handle along x.
TEMPLATE = np.array(
    [
        [0.035, 0, 0.09],
        [-0.035, 0, 0.09],
        [0, 0.035, 0.09],
        [0.065, 0, 0.05],
        [0.035, 0, 0.025],
        [-0.035, 0, 0],
        [0, -0.035, 0],
    ]
)
_TABLE = 0.6  # height of its top in the world, metres


def mug_scene(rng):
    """Return the pose (4, 4) of a mug somewhere on the table, and its key points (7, 3) as seen, in the world.

    The mug stands 25 to 65 cm from the axis of joint 1, up to 115 degrees to the left or right of straight ahead, where
    the arm can grasp it from above. The points have 1 mm of noise. Up to three of them are wrong: some centimetres off,
    in nearly the same direction.
    """
    radius, bearing = rng.uniform(0.25, 0.65), rng.uniform(-2, 2)
    x, y = T_W0[:2, 3] + radius * np.array([np.cos(bearing), np.sin(bearing)])
    T = transform(rot_z(rng.uniform(-np.pi, np.pi)), [x, y, _TABLE])
    points = TEMPLATE @ T[:3, :3].T + T[:3, 3] + 0.001 * rng.normal(size=TEMPLATE.shape)
    wrong = rng.choice(7, rng.integers(0, 4), replace=False)
    points[wrong] += 0.06 * rng.normal(size=3) + 0.01 * rng.normal(size=(len(wrong), 3))
    return T, points


def picked(T_mug, joints, T_fg):
    """Return whether joint angles, from 15 cm above the mug down to the grasp, pick it.

    Parameters
    ----------
    T_mug : array_like, shape (4, 4)
        The mug's true pose in the world.
    joints : array_like, shape (n, 7)
        The configurations of the approach in radians.
    T_fg : array_like, shape (4, 4)
        The gripper's pose in the flange's frame.

    Returns
    -------
    bool
        At the end the gripper is within 5 mm of the mug's axis, within 10 degrees of the vertical and 3 to 8 cm above
        the table; at the beginning it is 15 cm above that; all angles are within the limits, and no joint moves by more
        than 0.4 rad in a step.
    """
    joints, arm = np.asarray(joints, float), panda()
    low, high = arm.limits.T
    if not np.isfinite(joints).all() or (joints < low - 1e-9).any() or (joints > high + 1e-9).any():
        return False
    T = inverse(T_mug) @ T_W0 @ arm.fk(joints) @ T_fg
    straight_down = T[-1, 2, 2] < -np.cos(np.deg2rad(10))
    centred = np.linalg.norm(T[-1, :2, 3]) < 0.005 and 0.03 < T[-1, 2, 3] < 0.08
    above = np.abs(T[0, :3, 3] - T[-1, :3, 3] - [0, 0, 0.15]).max() < 0.01
    smooth = len(joints) > 1 and np.abs(np.diff(joints, axis=0)).max() < 0.4
    return bool(straight_down and centred and above and smooth)


def score(plan, T_fg):
    """Return how many of thirty mugs a plan picks.

    Parameters
    ----------
    plan : callable
        plan(points) are joint angles (n, 7) for the key points (7, 3) of one mug, as seen.
    T_fg : array_like, shape (4, 4)
        The gripper's pose in the flange's frame.

    Returns
    -------
    int
        From 0 to 30; the mugs are the same each time.

    Examples
    --------
    >>> score(lambda points: [[np.nan] * 7], np.eye(4))
    0
    """
    random = np.random.default_rng(11)
    scenes = [mug_scene(random) for _ in range(30)]
    return sum(picked(T, plan(points), T_fg) for T, points in scenes)
