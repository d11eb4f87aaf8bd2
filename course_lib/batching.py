"""Batches in the layout that makes numpy fast, a structure of arrays.

The items of a batch lie along the last axis.

An array (N, 3, 3) keeps the nine entries of one matrix together. numpy then works on N tiny
matrices one after the other, and the overhead of each is most of the time. Here R is (3, 3, N), and
R[i, j] holds that entry of all N. One line of a formula then computes one product for all of them,
in long runs through memory. The chunks are so small that the result of one line is still in the
processor's cache when the next line reads it, and little memory is needed besides the result.

by_entries is for formulas, which may also be given a single item; in_chunks is for functions that
write the results of a chunk where they belong.
"""

import math

import numpy as np

# Items of a few entries, such as vectors and matrices, computed at a time. A chunk of rotations has
# about 250 bytes an item, 1.5 MB in all, and stays in a second-level cache of 2 MB. A third of
# that is a tenth slower, because each call of numpy costs half a microsecond.
ITEMS = 6000


def by_entries(formula, shape, *arrays, batch, most=ITEMS):
    """Return a formula's value for each item of a batch, (*batch, *shape).

    Given the arrays (*batch, ...) with the batch on the right, (...) or (..., m), the formula
    returns (*shape) or (*shape, m). At most `most` items are computed at a time.
    """
    if batch == ():
        with np.errstate(all="ignore"):  # the caller refuses results that are inf or NaN
            return np.asarray(formula(*arrays)).reshape(shape)

    def fill(*entries_and_result):
        *entries, result = entries_and_result
        values = np.reshape(formula(*entries), (*shape, len(result)))
        # Copying all entries at once is three times as fast as copying them one by one.
        result[...] = values.transpose(values.ndim - 1, *range(values.ndim - 1))

    return in_chunks(fill, shape, *arrays, batch=batch, most=most)


def in_chunks(fill, shape, *arrays, batch, most=ITEMS):
    """Return the results (*batch, *shape) for a batch, computed in chunks.

    At most `most` items are computed at a time. fill(*arrays, result) is given the arrays (..., m)
    of a chunk, and writes to result (m, *shape).
    """
    n = math.prod(batch)
    result = np.empty((n, *shape))
    items = [array.reshape((n, *array.shape[len(batch) :])) for array in arrays]
    with np.errstate(all="ignore"):  # the caller refuses results that are inf or NaN
        for start in range(0, n, most):
            chunk = slice(start, start + most)
            arguments = [np.ascontiguousarray(_batch_last(array[chunk])) for array in items]
            fill(*arguments, result[chunk])
    return result.reshape((*batch, *shape))


def _batch_last(items):
    return items.transpose(*range(1, items.ndim), 0)
