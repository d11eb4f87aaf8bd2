"""What the checks of notebook 6 share: the arm with two links of 1 m, and the terms 1, x, y of positions."""

import numpy as np


def position(q):
    """Return the tip's position (..., 2), for joint angles (..., 2)."""
    q = np.asarray(q, float)
    first, second = q[..., 0], q[..., 0] + q[..., 1]
    return np.stack([np.cos(first) + np.cos(second), np.sin(first) + np.sin(second)], -1)


def solutions(xy):
    """Return the two pairs of joint angles (..., 2, 2) for positions (..., 2) in reach: q2 > 0 first."""
    bend = 2 * np.arccos(np.clip(np.linalg.norm(xy, axis=-1) / 2, -1, 1))
    middle = np.arctan2(xy[..., 1], xy[..., 0])
    return np.stack([np.stack([middle - side * bend / 2, side * bend], -1) for side in (1, -1)], -2)


def with_one(xy):
    """Return the rows (m, 3) 1, x, y of positions (m, 2)."""
    return np.column_stack([np.ones(len(xy)), xy])
