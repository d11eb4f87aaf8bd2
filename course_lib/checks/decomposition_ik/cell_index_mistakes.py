"""The cells that positions lie in, and what a mistake in one of the steps makes of them."""

import numpy as np


def parts(xy, low, high, n):
    """How many cells, whole and broken, lie between low and each position."""
    with np.errstate(all="ignore"):
        return (xy - low) / (high - low) * n


def outside(xy, low, high):
    return ((xy < low) | (xy > high)).any(axis=1, keepdims=True)


def marked(index, outside):
    return np.where(outside, -1, index)


def cells(xy, low, high, n):
    return marked(np.minimum(np.floor(parts(xy, low, high, n)), n - 1), outside(xy, low, high))


def changed(parts=parts, to_whole=np.floor, last=True, outside=outside, mark=marked):
    """The answer of somebody with one of these steps changed."""

    def answer(xy, low, high, n):
        with np.errstate(all="ignore"):
            index = to_whole(parts(xy, low, high, n))
        index = np.where(last & (xy == high), n - 1, index)
        return mark(index, outside(xy, low, high)) + 0.0

    return answer


def unmarked(index, outside):
    return index


def marks_found_later(xy, low, high, n, to_whole, edge=True):
    """The answer of somebody who looks for -1 and n in the whole numbers to find what is outside."""
    index = to_whole(parts(xy, low, high, n))
    index = np.where(edge & (xy == high), n - 1, index)
    return marked(index, ((index < 0) | (index >= n)).any(axis=1, keepdims=True))


def clipped(xy, low, high, n):
    return np.clip(np.floor(parts(xy, low, high, n)), 0, n - 1)


def each_by_itself(xy, low, high):
    return (xy < low) | (xy > high)
