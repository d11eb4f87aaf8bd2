"""Mistakes that show in the shape of an answer."""

import numpy as np

from course_lib.checks.exercise import Unreadable


def with_shapes(reader, known):
    """Return the reader, naming the mistake of an answer that it refuses: known(shape, *arguments), or None."""

    def reading(value, *case):
        try:
            return reader(value, *case)
        except Unreadable as wrong:
            try:
                mistake = known(np.shape(value), *case)
            except ValueError:  # lists of lists of different lengths have no shape
                mistake = None
            if mistake is None:
                raise
            raise Unreadable(str(wrong), mistake) from None

    return reading
