"""Checks of arguments: each returns a usable value, or raises a ValueError that names the argument."""

import os
from functools import partial
from pathlib import Path

import numpy as np

_LARGEST = 1e100  # of an entry, so that products of three do not overflow
_MOST_AXES = 16  # some of numpy's functions stop at 32, and results have more axes than arguments


def real_array(value, name, *shapes, batched=True, copy=True, infinite=False, gaps=False):
    """Return an argument as a float64 array whose last axes have one of the given shapes, such as (3,) or ("n", 3).

    "n" is any number from 1 on. The axes before them are the batch, unless batched=False; () allows
    every shape. With copy=False, for callers that only read the array, it may be `value` itself.
    With infinite=True entries may be infinite, as joint limits may; with gaps=True they may be NaN,
    as answers that are missing are.
    """
    expected = partial(_expected, name, shapes, batched)
    if isinstance(value, np.ma.MaskedArray):
        raise ValueError(f"{expected()}; it is a masked array: fill its gaps, or leave them out")
    try:
        array = np.asarray(value)
    except (
        Exception
    ) as unreadable:  # ragged lists, and any exception from a foreign object's __array__
        raise ValueError(f"{expected()}; numpy cannot read it: {unreadable!s:.200}") from unreadable
    if array.dtype.kind not in "iuf":
        what = (
            f"a {type(value).__name__}" if array.shape == () else f"entries of type {array.dtype}"
        )
        raise ValueError(f"{expected()}; it holds {what}")
    if not any(_fits(array.shape, shape, batched) for shape in shapes):
        raise ValueError(f"{expected()}; its shape is {array.shape}")
    if array.ndim > _MOST_AXES:
        raise ValueError(f"{name} must have at most {_MOST_AXES} axes; it has {array.ndim}")
    if array.dtype != np.float64:
        array = array.astype(np.float64)
    elif copy:
        array = array.copy()
    usable = ~np.isnan(array) if infinite else np.abs(array) <= _LARGEST
    if gaps:
        usable |= np.isnan(array)
    if (
        np.count_nonzero(usable) < array.size
    ):  # a third of the time of usable.all() for a small array
        first = tuple(np.argwhere(~usable)[0])
        wanted = f"at most {_LARGEST:g}, of either sign" if np.isfinite(array[first]) else "finite"
        raise ValueError(f"{name} must be {wanted}; {entry(name, first)} is {array[first]}")
    return array


def tolerance(value, name="tol"):
    """Return an argument as a float that is a usable tolerance: finite and not negative."""
    number = float(real_array(value, name, (), batched=False, copy=False))
    if number < 0:
        raise ValueError(f"{name} must be zero or more; it is {number:g}")
    return number


def positive(value, name, *shape, batched=True):
    """Return an argument as an array of finite numbers above zero; with batched=False and no shape, one number."""
    array = real_array(value, name, shape, batched=batched)
    refuse_first(array <= 0, name, "must be greater than zero; it is {:g}", array)
    return array


def count(value, name="n", least=0):
    """Return an argument as a whole number, of at most 10^9: no memory holds an answer with more entries."""
    if (
        isinstance(value, bool | np.bool_)
        or not isinstance(value, int | np.integer)
        or not least <= value <= 10**9
    ):
        raise ValueError(
            f"{name} must be a whole number from {least} to 1,000,000,000; it is {value!r}"
        )
    return int(value)


def generator(value, name="rng"):
    """Return an argument if it is a numpy random Generator; a seed is none."""
    if not isinstance(value, np.random.Generator):
        kind = type(value).__name__
        raise ValueError(
            f"{name} must be a numpy Generator, such as numpy.random.default_rng(0); it is of type "
            f"{kind}"
        )
    return value


def file_path(value, name="path"):
    """Return an argument as the pathlib.Path of a file."""
    if not isinstance(value, str | os.PathLike):
        raise ValueError(
            f"{name} must be a text or a pathlib.Path; it is of type {type(value).__name__}"
        )
    if "\0" in str(os.fspath(value)):
        raise ValueError(f"{name} must name a file; it holds a null character: {str(value)!r:.80}")
    if isinstance(os.fspath(value), bytes):
        raise ValueError(f"{name} must be a text or a pathlib.Path; it is a path in bytes")
    return Path(value)


def broadcast(**batches):
    """Return the common shape of several batches, given by their arguments' names; an error names the first misfit."""
    common = ()
    for name, batch in batches.items():
        try:
            common = np.broadcast_shapes(common, batch)
        except ValueError as mismatch:
            raise ValueError(
                f"{name} must have a batch that goes with that of the arguments before it, "
                f"{common}; it is {batch}"
            ) from mismatch
    return common


def refuse_first(bad, name, reason, *values):
    """Raise ValueError for the first True in a batch of flags: reason, formatted with that entry of the values."""
    if np.count_nonzero(bad):
        index = tuple(np.argwhere(bad)[0])
        raise ValueError(
            f"{entry(name, index)} {reason.format(*(value[index] for value in values))}"
        )


def read_only(array):
    """Return an array that cannot be changed in place, for values that functions read and that must stay as they are.

    Examples
    --------
    >>> base = read_only([0.5, 0, 1])
    >>> base += 1
    Traceback (most recent call last):
    ValueError: output array is read-only
    """
    array = np.array(array)
    array.flags.writeable = False
    return array


def entry(name, index):
    """Return how the entry of an array is written in a message, such as R[2, 0]; with no index, the array's name."""
    return f"{name}[{', '.join(str(int(i)) for i in index)}]" if len(index) else name


def _fits(shape, wanted, batched):
    batch = len(shape) - len(wanted)
    if batch < 0 or (batch > 0 and not batched):
        return False
    core = shape[batch:]
    return core == wanted or (wanted[:1] == ("n",) and core[0] > 0 and core[1:] == wanted[1:])


def _expected(name, shapes, batched):
    if shapes == ((),) and not batched:
        return f"{name} must be one real number"
    names = (", ".join([*["..."] * batched, *map(str, shape)]) for shape in shapes)
    return (
        f"{name} must be an array of real numbers of shape "
        f"{' or '.join(f'({sizes})' for sizes in names)}"
    )
