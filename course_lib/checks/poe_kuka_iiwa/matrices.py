"""Matrices as answers: how they are compared, told of, and looked at block by block."""

import numpy as np

from course_lib.checks.exercise import Mistake, same
from course_lib.checks.format_numbers import format_tuple

FINE = 1e-9  # what a right answer may be off by, relative to its size

BLOCK, COLUMN = (slice(0, 3), slice(0, 3)), (slice(0, 3), 3)  # of a pose or the matrix of a twist


def near(answer, right):
    """Whether an answer is right to FINE of the largest entry, or of 1; an empty one is."""
    return np.abs(answer - right).max(initial=0) <= FINE * max(1, np.abs(right).max(initial=0))


def told(columns, right):
    """Return a `seen` that tells of the worst column. columns(answer), right(*case): the part looked at."""

    def seen(answer, *case):
        part, wanted = columns(answer), right(*case)
        k = np.abs(part - wanted).max(axis=0).argmax()
        which = ("first", "second", "third")[k]
        return f"Its {which} column should be {format_tuple(wanted[:, k])}. Yours is {format_tuple(part[:, k])}."

    return seen


def in_part(where, right):
    """Return a maker of mistakes that show in one part of the answer, whatever the rest of it holds.

    where: an index of the part. right(*case): what belongs there.
    """

    def mistake(words, *predictions):
        name, hint = words

        def seen(answer, *case):
            part = answer[where]
            if near(part, right(*case)):
                return False
            found = (prediction(*case) for prediction in predictions)
            return any(guess is not None and same(part, guess) for guess in found)

        return Mistake(name, hint, seen=seen)

    return mistake
