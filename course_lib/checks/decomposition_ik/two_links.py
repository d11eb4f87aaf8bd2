"""What the checks of cells and models share: the arm of two links, samples of it, and answers with nan in them."""

import numpy as np

from course_lib.checks.exercise import Mistake, same


def place(q):
    """Return where the end is, (..., 2), for joint angles (..., 2)."""
    first, second = q[..., 0], q[..., 0] + q[..., 1]
    return np.stack([np.cos(first) + np.cos(second), np.sin(first) + np.sin(second)], -1)


def solutions(xy):
    """Return the two pairs of joint angles (..., 2, 2) for places (..., 2) in reach: q2 > 0 first."""
    bend = 2 * np.arccos(np.clip(np.linalg.norm(xy, axis=-1) / 2, -1, 1))
    middle = np.arctan2(xy[..., 1], xy[..., 0])
    return np.stack([np.stack([middle - side * bend / 2, side * bend], -1) for side in (1, -1)], -2)


def lump(rng, middle, widths, n):
    """Return n points (n, 2) in a box around `middle`, which is exactly their mean."""
    points = rng.uniform(-1, 1, (n, 2))
    return np.array(middle) + (points - points.mean(axis=0)) * np.array(widths)


def same_with_gaps(value, predicted):
    """Return whether two arrays are the same numbers, with nan in the same places."""
    value, predicted = np.asarray(value), np.asarray(predicted)
    gaps = np.isnan(value)
    if value.shape != predicted.shape or (gaps != np.isnan(predicted)).any():
        return False
    return same(np.where(gaps, 0, value), np.where(gaps, 0, predicted))


def like(words, *answers):
    """One mistake, name and hint in `words`, that may be made in more than one way, in answers with nan in them."""
    name, hint = words
    return (Mistake(name, hint, *answers, alike=lambda value, predicted, *case: same_with_gaps(value, predicted)),)


def both_elbows_at(rng, middle, n):
    """Return 2 n joint angles (2 n, 2) that reach positions within 3 cm of `middle`: n with each elbow."""
    found = solutions(np.array(middle) + rng.uniform(-0.03, 0.03, (n, 2)))
    return np.concatenate([found[:, 0], found[:, 1]])
