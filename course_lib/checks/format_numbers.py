"""Numbers in the sentences of checks."""

import numpy as np


def format_tuple(numbers):
    """Return numbers as a tuple is written: (0.1, -2). Numbers no larger than rounding become 0."""
    return "(" + ", ".join(f"{0 if abs(number) <= 1e-12 else number:.4g}" for number in np.ravel(numbers)) + ")"


def format_array(numbers, digits=4):
    """Return an array as numpy writes it, on one line: [0.1 -2. ], with so many digits after the point."""
    array = np.asarray(numbers) + 0.0  # no -0
    return np.array2string(array, precision=digits, suppress_small=True).replace("\n", "")
