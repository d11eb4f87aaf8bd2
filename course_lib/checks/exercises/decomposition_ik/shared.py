"""What the checks of notebook 6 share: the arm with two links of 1 m, the terms 1, x, y, and arrays with gaps."""

import numpy as np

from course_lib.checks.exercise import Property


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


def no_number(is_wrong, text, right, tell):
    """Return the Property that no number of an answer is_wrong(numbers, those of right(*case)).

    tell(index, answer, *case) says what is wrong at the first one.
    """

    def wrong(answer, *case):
        return np.argwhere(is_wrong(answer, right(*case)))

    return Property(text, lambda *case: not wrong(*case).size, lambda *case: tell(wrong(*case)[0], *case))


def off(answer, right):
    """Return where an answer is not the number that it should be."""
    return ~np.isnan(right) & ~(np.abs(answer - right) <= 1e-9 * np.maximum(1, np.abs(right)))


def no_gap(answer, right):
    """Return where an answer is a number, and should be nan."""
    return np.isnan(right) & ~np.isnan(answer)
