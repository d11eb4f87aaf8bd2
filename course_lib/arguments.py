"""Check the arguments of public functions; an error is one sentence that names the argument."""

import numpy as np

_MOST_AXES = 16  # some of numpy's functions stop at 32, and results have more axes than arguments


def real_array(value, name, *shapes, copy=True, infinite=False):
    """Return an argument as a float64 array whose last axes have one of the given shapes.

    Parameters
    ----------
    value : array_like
    name : str
        The argument's name, for messages.
    *shapes : tuple of int
        Such as (3,) or (3, 3); any axes before them are the batch. () allows every shape.
    copy : bool, optional
        False if the caller only reads the array, which may then be `value` itself.
    infinite : bool, optional
        True if entries may be infinite, as joint limits may.

    Returns
    -------
    ndarray

    Raises
    ------
    ValueError
        For anything that is not real numbers, has another shape, or is not finite.

    Examples
    --------
    >>> real_array([1, 2, 3], "p", (3,))
    array([1., 2., 3.])
    >>> real_array([1, 2, np.nan], "p", (3,))
    Traceback (most recent call last):
        ...
    ValueError: p must be finite; p[2] is nan
    """
    if isinstance(value, np.ma.MaskedArray):
        raise ValueError(f"{_expected(name, shapes)}; it is a masked array: fill its gaps, or leave them out")
    try:
        array = np.asarray(value)
    except Exception as unreadable:  # ragged lists, and any exception from a foreign object's __array__
        raise ValueError(f"{_expected(name, shapes)}; numpy cannot read it: {unreadable!s:.200}") from unreadable
    if array.dtype.kind not in "iuf":
        raise ValueError(f"{_expected(name, shapes)}; it holds {_what(value, array)}")
    if not any(array.shape[array.ndim - len(shape) :] == shape for shape in shapes if array.ndim >= len(shape)):
        raise ValueError(f"{_expected(name, shapes)}; its shape is {array.shape}")
    if array.ndim > _MOST_AXES:
        raise ValueError(f"{name} must have at most {_MOST_AXES} axes; it has {array.ndim}")
    if array.dtype != np.float64:
        with np.errstate(over="ignore"):  # a long double beyond float64 becomes inf, and is named below
            array = array.astype(np.float64)
    elif copy:
        array = array.copy()
    finite = ~np.isnan(array) if infinite else np.isfinite(array)
    if np.count_nonzero(finite) < array.size:  # a third of the time of finite.all() for a small array
        first = tuple(np.argwhere(~finite)[0])
        raise ValueError(f"{name} must be finite; {entry(name, first)} is {array[first]}")
    return array


def tolerance(value, name="tol"):
    """Return an argument as a float that is a usable tolerance: finite and not negative.

    Parameters
    ----------
    value : float
    name : str, optional
        The argument's name, for messages.

    Returns
    -------
    float

    Raises
    ------
    ValueError
        For any other value.

    Examples
    --------
    >>> tolerance(0)
    0.0
    """
    array = real_array(value, name, (), copy=False)
    if array.shape != () or (number := float(array)) < 0:
        raise ValueError(f"{name} must be one number, zero or more; it is {value!r}")
    return number


def positive(value, name):
    """Return an argument as an array of finite numbers above zero.

    Parameters
    ----------
    value : array_like
    name : str
        The argument's name, for messages.

    Returns
    -------
    ndarray

    Raises
    ------
    ValueError
        For any other value; the message names the first entry that is not above zero.

    Examples
    --------
    >>> positive([2, 0], "lengths")
    Traceback (most recent call last):
        ...
    ValueError: lengths[1] must be greater than zero; it is 0
    """
    array = real_array(value, name, ())
    refuse_first(array <= 0, name, lambda i: f"must be greater than zero; it is {array[i]:g}")
    return array


def count(value, name="n", least=0):
    """Return an argument as a whole number, of at most 10^9: no memory holds an answer with more entries.

    Parameters
    ----------
    value : int
    name : str, optional
        The argument's name, for messages.
    least : int, optional
        The smallest number allowed.

    Returns
    -------
    int

    Raises
    ------
    ValueError
        For any other value, True and False included.

    Examples
    --------
    >>> count(True)
    Traceback (most recent call last):
        ...
    ValueError: n must be a whole number from 0 to 1,000,000,000; it is True
    """
    if isinstance(value, bool | np.bool_) or not isinstance(value, int | np.integer) or not least <= value <= 10**9:
        raise ValueError(f"{name} must be a whole number from {least} to 1,000,000,000; it is {value!r}")
    return int(value)


def generator(value, name="rng"):
    """Return an argument if it is a numpy random Generator.

    Parameters
    ----------
    value : numpy.random.Generator
    name : str, optional
        The argument's name, for messages.

    Returns
    -------
    numpy.random.Generator

    Raises
    ------
    ValueError
        For any other value, a seed included.

    Examples
    --------
    >>> generator(np.random.default_rng(0)).integers(10)
    np.int64(8)
    """
    if not isinstance(value, np.random.Generator):
        raise ValueError(
            f"{name} must be a numpy random Generator, such as numpy.random.default_rng(seed); "
            f"it is of type {type(value).__name__}"
        )
    return value


def broadcast(**batches):
    """Return the common shape of several batches.

    Parameters
    ----------
    **batches : tuple of int
        The shape of each argument's batch, by the argument's name.

    Returns
    -------
    tuple of int

    Raises
    ------
    ValueError
        If they do not broadcast; the message names the first that does not fit.

    Examples
    --------
    >>> broadcast(T=(4, 1), p=(3,))
    (4, 3)
    """
    common = ()
    for name, batch in batches.items():
        try:
            common = np.broadcast_shapes(common, batch)
        except ValueError as mismatch:
            raise ValueError(
                f"{name} must have a batch that goes with that of the arguments before it, {common}; it is {batch}"
            ) from mismatch
    return common


def refuse_first(bad, name, reason):
    """Raise ValueError for the first True in a batch of flags.

    Parameters
    ----------
    bad : ndarray of bool
    name : str
        The argument's name, for messages.
    reason : callable
        reason(index) returns the rest of the message.

    Raises
    ------
    ValueError
        If a flag is True.

    Examples
    --------
    >>> refuse_first(np.array([False, True]), "R", lambda index: "must be a rotation")
    Traceback (most recent call last):
        ...
    ValueError: R[1] must be a rotation
    """
    if np.count_nonzero(bad):
        index = tuple(np.argwhere(bad)[0])
        raise ValueError(f"{entry(name, index)} {reason(index)}")


def finite_result(result, name, item_axes=-1):
    """Return a result if all of it is finite.

    Parameters
    ----------
    result : ndarray
    name : str
        The name of the argument to which the error is due.
    item_axes : int or tuple of int or None, optional
        The axes of one item; None if the result's batch is not the argument's: then the message names no index.

    Returns
    -------
    ndarray

    Raises
    ------
    ValueError
        If an entry is not finite, because the argument is too large.

    Examples
    --------
    >>> finite_result(np.array([[1.0], [np.inf]]), "w")
    Traceback (most recent call last):
        ...
    ValueError: w[1] is too large: the result exceeds the largest number
    """
    finite = np.isfinite(result)
    if np.count_nonzero(finite) < finite.size:
        reason = "is too large: the result exceeds the largest number"
        refuse_first(~finite.all(item_axes), name, lambda i: reason)
    return result


def entry(name, index):
    """Return how the entry of an array is written in a message.

    Parameters
    ----------
    name : str
        The array's name.
    index : sequence of int
        Empty for the array itself.

    Returns
    -------
    str

    Examples
    --------
    >>> entry("R", (2, 0))
    'R[2, 0]'
    """
    return f"{name}[{', '.join(str(int(i)) for i in index)}]" if len(index) else name


def _expected(name, shapes):
    names = " or ".join("(" + ", ".join(["...", *map(str, shape)]) + ")" for shape in shapes)
    return f"{name} must be an array of real numbers of shape {names}"


def _what(value, array):
    if value is None:
        return "None"
    return f"a {type(value).__name__}" if array.shape == () else f"entries of type {array.dtype}"
