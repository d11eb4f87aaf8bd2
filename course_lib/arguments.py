"""Checks of arguments, which return a usable value or raise a ValueError.

The message names the argument, what it should be and what was given.
"""

import os
from functools import partial
from pathlib import Path

import numpy as np

# The largest size of an entry. The product of three such entries, 1e300, is still below the largest
# float, 1.8e308.
_MAX_SIZE = 1e100
# Some of numpy's functions stop at 32 axes, and results have more axes than arguments.
_MAX_AXES = 16


def real_array(value, name, *shapes, batched=True, copy=True, infinite=False, gaps=False):
    """Return an argument as a float64 array whose last axes have one of the given shapes.

    A shape is a tuple such as (3,) or ("n", 3), in which "n" stands for any number from 1 on.

    Parameters
    ----------
    value : array_like
    name : str
        The argument's name, for messages.
    *shapes : tuple
        The allowed shapes of the last axes; () allows every shape.
    batched : bool, default True
        Whether more axes, those of the batch, may stand before them.
    copy : bool, default True
        With False, for callers that only read the array, the result may be `value` itself.
    infinite : bool, default False
        Whether entries may be infinite, as joint limits may.
    gaps : bool, default False
        Whether entries may be NaN, as missing answers are.

    Returns
    -------
    array (..., *shape)

    Raises
    ------
    ValueError
        If the argument is not such an array.
    """
    expected = partial(_expected, name, shapes, batched)
    if isinstance(value, np.ma.MaskedArray):
        raise ValueError(f"{expected()}; it is a masked array: fill its gaps, or leave them out")
    try:
        array = np.asarray(value)
    except Exception as unreadable:
        # This catches ragged lists, and whatever a foreign object's __array__ raises.
        raise ValueError(f"{expected()}; numpy cannot read it: {unreadable!s:.200}") from unreadable
    if array.dtype.kind not in "iuf":
        is_single = array.shape == ()
        contents = f"a {type(value).__name__}" if is_single else f"entries of type {array.dtype}"
        raise ValueError(f"{expected()}; it holds {contents}")
    # The first look is enough for one item, and takes a third of the time of the other.
    if array.shape not in shapes and not any(_fits(array.shape, each, batched) for each in shapes):
        raise ValueError(f"{expected()}; its shape is {array.shape}")
    if array.ndim > _MAX_AXES:
        raise ValueError(f"{name} must have at most {_MAX_AXES} axes; it has {array.ndim}")
    if array.dtype != np.float64:
        array = array.astype(np.float64)
    elif copy:
        array = array.copy()
    # If the squares add up to a usable number, all entries are usable. This looks at each entry
    # once, in a third of the time of the comparisons below, which find the entry that is not.
    if np.vdot(array, array) <= _MAX_SIZE**2:
        return array
    usable = ~np.isnan(array) if infinite else np.abs(array) <= _MAX_SIZE
    if gaps:
        usable |= np.isnan(array)
    # For a small array, counting takes a third of the time of usable.all().
    if np.count_nonzero(usable) < array.size:
        first = tuple(np.argwhere(~usable)[0])
        wanted = f"at most {_MAX_SIZE:g}, of either sign" if np.isfinite(array[first]) else "finite"
        raise ValueError(f"{name} must be {wanted}; {entry(name, first)} is {array[first]}")
    return array


def tolerance(value, name="tol"):
    """Return an argument as a float that is a usable tolerance: finite and not negative."""
    number = float(real_array(value, name, (), batched=False, copy=False))
    if number < 0:
        raise ValueError(f"{name} must be zero or more; it is {number:g}")
    return number


def positive(value, name, *shape, batched=True):
    """Return an argument as an array of finite numbers above zero.

    With batched=False and no shape it is one number.
    """
    array = real_array(value, name, shape, batched=batched)
    refuse_first(array <= 0, name, "must be greater than zero; it is {:g}", array)
    return array


def count(value, name="n", least=0):
    """Return an argument as a whole number from `least` to 10^9.

    No memory holds an answer with more entries than that.
    """
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
    """Return an argument if it is a numpy random Generator, which a seed is not."""
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
    """Return the common shape of several batches, given by their arguments' names.

    An error names the first argument whose batch does not fit those before it.
    """
    common = ()
    for name, batch in batches.items():
        if batch in ((), common):
            continue
        try:
            common = np.broadcast_shapes(common, batch)
        except ValueError as mismatch:
            raise ValueError(
                f"{name} must have a batch that goes with that of the arguments before it, "
                f"{common}; it is {batch}"
            ) from mismatch
    return common


def refuse_first(bad, name, reason, *values):
    """Raise ValueError for the first True in a batch of flags.

    The message is `reason`, formatted with the entries of the values at the same index.
    """
    if np.count_nonzero(bad):
        index = tuple(np.argwhere(bad)[0])
        raise ValueError(
            f"{entry(name, index)} {reason.format(*(value[index] for value in values))}"
        )


def read_only(array):
    """Return an array that cannot be changed in place.

    It is for values that functions read and that must stay as they are.

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
    """Return how a message writes the entry of an array, such as R[2, 0].

    Without an index it is the array's name.
    """
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
