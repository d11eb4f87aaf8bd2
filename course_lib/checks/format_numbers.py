"""Format numbers for the messages of checks."""

import numpy as np


def format_tuple(numbers):
    """Return numbers in the form of a tuple, such as "(0.1, -2)"; rounding errors are written as 0."""
    return "(" + ", ".join(f"{0 if abs(number) <= 1e-12 else number:.4g}" for number in np.ravel(numbers)) + ")"


def format_array(numbers, digits=4):
    """Return an array in numpy's form on one line, such as "[0.1 -2. ]", with at most `digits` decimals."""
    array = np.asarray(numbers) + 0.0  # no -0
    return np.array2string(array, precision=digits, suppress_small=True).replace("\n", "")
