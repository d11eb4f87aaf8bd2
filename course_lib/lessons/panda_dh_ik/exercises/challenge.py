"""The mugs of notebook 5: their key points, what a camera sees of them, and what counts as
picked."""

import numpy as np

from course_lib.arms import panda
from course_lib.lessons.panda_dh_ik.exercises.shared import READY, T_W0
from course_lib.lessons.panda_dh_ik.pick import IN_FLANGE, between, clearances, shares
from course_lib.rigid import inverse, transform
from course_lib.rotations import rot_z

# Key points of the template in metres, in the mug's frame: z up from the middle of its foot, the
# handle along x.
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
_LONGEST = 2.0  # seconds for a pick that counts


def mug_scene(rng):
    """Return the pose (4, 4) of a mug somewhere on the table, and its key points (7, 3) as seen, in
    the world.

    The mug stands 30 to 65 cm from the axis of joint 1, up to 115 degrees to the left or right of
    straight ahead, where the arm can grasp it from above. The points have 1 mm of noise. Up to
    three of them are wrong: some centimetres off, in nearly the same direction.
    """
    radius, bearing = rng.uniform(0.3, 0.65), rng.uniform(-2, 2)
    x, y = T_W0[:2, 3] + radius * np.array([np.cos(bearing), np.sin(bearing)])
    T = transform(rot_z(rng.uniform(-np.pi, np.pi)), [x, y, _TABLE])
    points = TEMPLATE @ T[:3, :3].T + T[:3, 3] + 0.001 * rng.normal(size=TEMPLATE.shape)
    wrong = rng.choice(7, rng.integers(0, 4), replace=False)
    points[wrong] += 0.06 * rng.normal(size=3) + 0.01 * rng.normal(size=(len(wrong), 3))
    return T, points


def picked(T_mug, trajectory):
    """Return whether a trajectory picks a mug.

    Parameters
    ----------
    T_mug : array_like, shape (4, 4)
        The mug's true pose in the world.
    trajectory : array_like, shape (n, 8)
        In each row the time in seconds and the joint angles in radians.

    Returns
    -------
    bool
        It begins in the ready configuration. Nothing touches anything, all angles are within the
        limits, speeds and accelerations within their bounds. At the end the gripper is within 5 mm
        of the mug's axis, within 10 degrees of the vertical and 3 to 8 cm above the table. It takes
        at most 2 s.
    """
    trajectory, low_high = np.asarray(trajectory, float), panda().limits.T
    rows = trajectory.ndim == 2 and trajectory.shape[1:] == (8,) and len(trajectory) > 1
    if not rows or not np.isfinite(trajectory).all() or np.diff(trajectory[:, 0]).min() <= 0:
        return False
    joints = trajectory[:, 1:]
    begins = (
        np.abs(joints[0] - READY).max() < 1e-6 and trajectory[-1, 0] - trajectory[0, 0] <= _LONGEST
    )
    inside = np.abs(joints - np.clip(joints, *low_high)).max() < 1e-9
    bounded = max(share.max() for share in shares(trajectory)) < 1.01
    clear = min(gap.min() for gap in clearances(between(trajectory)[1], T_mug).values()) > 0
    T = inverse(T_mug) @ T_W0 @ panda().fk(joints[-1]) @ IN_FLANGE
    straight_down = T[2, 2] < -np.cos(np.deg2rad(10))
    centred = np.linalg.norm(T[:2, 3]) < 0.005 and 0.03 < T[2, 3] < 0.08
    return bool(begins and inside and bounded and clear and straight_down and centred)


def score(plan):
    """Return how many of thirty mugs a plan picks, and how long a pick takes on average.

    Parameters
    ----------
    plan : callable
        plan(points) is a trajectory (n, 8) for the key points (7, 3) of one mug, as seen.

    Returns
    -------
    picks : int
        From 0 to 30; the mugs are the same each time.
    seconds : float
        The mean duration of those that pick; nan if there is none.

    Examples
    --------
    >>> score(lambda points: np.zeros((2, 8)))
    (0, nan)
    """
    random = np.random.default_rng(11)
    scenes = [mug_scene(random) for _ in range(30)]
    plans = [(T, np.asarray(plan(points), float)) for T, points in scenes]
    durations = [
        trajectory[-1, 0] - trajectory[0, 0] for T, trajectory in plans if picked(T, trajectory)
    ]
    return len(durations), float(np.mean(durations)) if durations else float("nan")
