"""How many digits a stored figure and its words have: those that its axis shows, so that every
processor stores the same ones."""

import math

import numpy as np

# A number half-way between two stored ones, as 0.5 m is in steps of 1 m, would be rounded up on one
# processor and down on another. Shifted by this part of a step beforehand, it is rounded up on all.
_OFF_TIES = 1e-4
# Nobody sees less: a hundred-thousandth of an axis is a hundredth of a pixel.
DIGITS = 5


def decimals_for(span):
    """Return how many decimals (int) leave DIGITS digits of a number as large as `span`."""
    if not math.isfinite(span) or span == 0:
        return DIGITS
    # An axis up to 1 may end at 0.9999999999999999 on another processor.
    return DIGITS - 1 - math.floor(math.log10(abs(span)) + 1e-9)


def rounded(number, decimals):
    """Return a number with these decimals; 0 for -0, and None for NaN and infinities.

    Parameters
    ----------
    number : float
    decimals : int

    Returns
    -------
    float or None

    Examples
    --------
    >>> rounded(2.5 - 4e-16, 0), rounded(2.5 + 4e-16, 0), rounded(-0.0, 3)
    (3.0, 3.0, 0.0)
    """
    if not math.isfinite(number):
        return None
    if decimals > 300:  # 10 ** -decimals would be 0
        return 0.0
    return round(number + _OFF_TIES * 10.0**-decimals, decimals) + 0.0


def rounded_array(values, decimals):
    """Return an array of floats with these decimals, 0 for -0; `rounded` for a whole array."""
    values = np.asarray(values, float)
    return np.round(values + _OFF_TIES * 10.0**-decimals, decimals) + 0.0


def fixed(number, decimals):
    """Return a number in words, with these decimals, and without a sign if it is shown as 0.

    Parameters
    ----------
    number : float
    decimals : int

    Returns
    -------
    str

    Examples
    --------
    >>> fixed(1.875 - 4e-16, 2), fixed(1.875 + 4e-16, 2), fixed(-0.001, 2)
    ('1.88', '1.88', '0.00')
    """
    return f"{number + _OFF_TIES * 10.0**-decimals:z.{decimals}f}"
