"""Matrices as answers: how they are read, told of, and looked at block by block."""

import numpy as np

from course_lib.checks.exercise import Mistake, Unreadable, same
from course_lib.checks.reading import OTHER_FORM, numbers

FINE = 1e-9  # what a right answer may be off by, relative to its size

BLOCK, COLUMN = (slice(0, 3), slice(0, 3)), (slice(0, 3), 3)  # of a pose or the matrix of a twist


def matrix(shape, misshapen):
    """Return a reader of arrays of this shape; misshapen: other shapes, and the Mistake that each of them shows."""
    reader = numbers(lambda *case: shape)

    def read(value, *case):
        try:
            return reader(value, *case)
        except Unreadable as wrong:
            known = misshapen.get(_shape(value)) if wrong.mistake is OTHER_FORM else None
            raise Unreadable(str(wrong), known or wrong.mistake) from None

    return read


def _shape(value):
    try:
        return np.shape(value)
    except ValueError:  # a list whose parts differ in shape
        return None


def near(answer, right, fine=FINE):
    return np.abs(answer - right).max() <= fine * max(1.0, np.abs(right).max())


def in_words(vector):
    return "(" + ", ".join(f"{x if abs(x) > 1e-12 else 0:.4g}" for x in vector) + ")"


def told(columns, right):
    """Return a `seen` that tells of the worst column. columns(answer), right(*case): the part looked at."""

    def seen(answer, *case):
        part, wanted = columns(answer), right(*case)
        k = np.abs(part - wanted).max(axis=0).argmax()
        which = ("first", "second", "third")[k]
        return f"Its {which} column should be {in_words(wanted[:, k])}. Yours is {in_words(part[:, k])}."

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
