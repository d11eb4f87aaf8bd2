"""Format numbers for the messages of checks."""

import numpy as np

ORDINALS = "first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth"


def format_tuple(numbers):
    """Return numbers in the form of a tuple, and a single number without brackets; rounding errors
    are written as 0.

    Parameters
    ----------
    numbers : array_like

    Returns
    -------
    str

    Examples
    --------
    >>> format_tuple([0.1, -2, 1e-17]), format_tuple(1 / 3)
    ('(0.1, -2, 0)', '0.3333')
    """
    if np.size(numbers) == 1:
        return _with_four_digits(np.ravel(numbers)[0])
    return f"({', '.join(_with_four_digits(number) for number in np.ravel(numbers))})"


def _with_four_digits(number):
    return "0" if abs(number) <= 1e-12 else f"{number:.4g}"


def format_array(numbers, digits=4):
    """Return an array in numpy's form on one line.

    Parameters
    ----------
    numbers : array_like
    digits : int, optional
        The largest number of decimals.

    Returns
    -------
    str

    Examples
    --------
    >>> format_array([0.1, -2, 1 / 3], digits=2)
    '[ 0.1  -2.    0.33]'
    """
    array = np.asarray(numbers) + 0.0  # no -0
    return np.array2string(array, precision=digits, suppress_small=True).replace("\n", "")
