"""The cells that positions lie in, and what a mistake in one of the steps makes of them."""

import numpy as np


def parts(xy, low, high, n):
    """Return how many cells lie between `low` and each position, with their fractions."""
    with np.errstate(all="ignore"):
        return (xy - low) / (high - low) * n


def outside(xy, low, high):
    """Return which positions lie outside the grid, (m, 1)."""
    return ((xy < low) | (xy > high)).any(axis=1, keepdims=True)


def marked(index, outside):
    """Return the index with -1 for positions outside."""
    return np.where(outside, -1, index)


def cells(xy, low, high, n):
    """Return the right answer, in floats."""
    return marked(np.minimum(np.floor(parts(xy, low, high, n)), n - 1), outside(xy, low, high))


def changed(parts=parts, to_whole=np.floor, last=True, outside=outside, mark=marked):
    """Return an answer in which one of these steps is changed."""

    def answer(xy, low, high, n):
        with np.errstate(all="ignore"):
            index = to_whole(parts(xy, low, high, n))
        index = np.where(last & (xy == high), n - 1, index)
        return mark(index, outside(xy, low, high)) + 0.0

    return answer


def unmarked(index, outside):
    """Return the index as it is: positions outside are not marked."""
    return index


def marks_found_later(xy, low, high, n, to_whole, edge=True):
    """Return the answer that finds the positions outside by -1 and n among the whole numbers."""
    index = to_whole(parts(xy, low, high, n))
    index = np.where(edge & (xy == high), n - 1, index)
    return marked(index, ((index < 0) | (index >= n)).any(axis=1, keepdims=True))


def clipped(xy, low, high, n):
    """Return the answer that moves positions outside to the nearest cell."""
    return np.clip(np.floor(parts(xy, low, high, n)), 0, n - 1)


def each_by_itself(xy, low, high):
    """Return which coordinates are outside, (m, 2), each regardless of the other."""
    return (xy < low) | (xy > high)
