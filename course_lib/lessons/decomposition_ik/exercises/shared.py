"""What the checks of notebook 6 share: the terms 1, x, y, samples that are repeated or of several
revolutions, and arrays with gaps."""

import numpy as np

from course_lib.checks.exercise import Property
from course_lib.checks.tolerances import EXACT


def with_one(xy):
    """Return the rows (m, 3) 1, x, y of positions (m, 2)."""
    return np.column_stack([np.ones(len(xy)), xy])


def some_twice(*samples):
    """Return arrays of samples (m, ...), the first third of which stands there a second time."""
    m = len(samples[0])
    again = np.append(np.arange(m), np.arange(m // 3))
    return tuple(array[again] for array in samples)


def revolved(q):
    """Return joint angles (m, 2) after two revolutions of the first joint, and one back of the
    other."""
    return q + 2 * np.pi * np.array([2, -1])


def no_number(is_wrong, text, right, tell, otherwise=None):
    """Return the Property that no number of an answer is_wrong(numbers, those of right(*case)).

    tell(index, answer, *case) says what is wrong at the first one; otherwise: as of a Property.
    """

    def wrong(answer, *case):
        return np.argwhere(is_wrong(answer, right(*case)))

    def says(*case):
        return tell(wrong(*case)[0], *case)

    return Property(text, lambda *case: not wrong(*case).size, says, otherwise=otherwise)


def first_wrong(answer, right):
    """Return the index of the first number of an answer that is off, or stands for nan; or the
    first nan that stands for a number."""
    return np.argwhere(off(answer, right) | no_gap(answer, right))[0]


def off(answer, right, tolerance=EXACT):
    """Return where an answer is not the number that it should be, relative to numbers above 1."""
    allowed = tolerance * np.maximum(1, np.abs(right))
    return ~np.isnan(right) & ~(np.abs(answer - right) <= allowed)


def no_gap(answer, right):
    """Return where an answer is a number, and should be nan."""
    return np.isnan(right) & ~np.isnan(answer)
