"""The poses of an arm's solid bodies."""

import numpy as np

from course_lib import rigid


def link_poses(arm, q):
    """Return the poses of an arm's bodies at joint angles, relative to those at q = 0.

    The base does not move; each joint's body moves by the product of exponentials up to it.

    Parameters
    ----------
    arm : SerialArm
    q : array_like, shape (..., n)
        Joint angles, in radians.

    Returns
    -------
    ndarray, shape (..., n + 1, 4, 4)
    """
    return body_poses(arm, arm.frames(q)[..., :-1, :, :])


def body_poses(arm, frames, base=(0, 0, 0)):
    """Return those poses in a world in which the arm's base stands at a point.

    Parameters
    ----------
    arm : SerialArm
    frames : ndarray, shape (..., n, 4, 4)
        The frames of the arm's joints in that world.
    base : array_like, shape (3,), optional
        In metres.

    Returns
    -------
    ndarray, shape (..., n + 1, 4, 4)
    """
    moved = frames @ rigid.inverse(arm.home[:-1])
    stands = np.broadcast_to(rigid.transform(np.eye(3), base), (*moved.shape[:-3], 1, 4, 4))
    return np.concatenate([stands, moved], -3)
