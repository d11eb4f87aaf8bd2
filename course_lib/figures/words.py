"""Words for numbers in captions and alternative texts."""

import numpy as np

from course_lib.figures.digits import fixed


def interval(values, digits=2):
    """Return the smallest and the largest of some values in words, or one number if both print
    alike.

    Parameters
    ----------
    values : array_like
        Of any shape, not empty.
    digits : int, optional
        Behind the point.

    Returns
    -------
    str

    Examples
    --------
    >>> interval([0.7, 1.36])
    '0.70 to 1.36'
    >>> interval([0.851, 0.853])
    '0.85'
    """
    low, high = (fixed(extreme, digits) for extreme in (np.min(values), np.max(values)))
    return low if low == high else f"{low} to {high}"
