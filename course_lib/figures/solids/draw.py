"""The poses of an arm's solid bodies."""

import numpy as np

from course_lib import rigid


def link_poses(arm, q):
    """Return the poses (..., n + 1, 4, 4) of an arm's bodies at joint angles (..., n), relative to those at q = 0.

    The base does not move; each joint's body moves by the product of exponentials up to it.
    """
    return body_poses(arm, arm.frames(q)[..., :-1, :, :])


def body_poses(arm, frames, base=(0, 0, 0)):
    """Return those poses in a world in which the arm stands at a point (3,) and has its frames (..., n, 4, 4)."""
    moved = frames @ rigid.inverse(arm.home[:-1])
    stands = np.broadcast_to(rigid.transform(np.eye(3), base), (*moved.shape[:-3], 1, 4, 4))
    return np.concatenate([stands, moved], -3)
