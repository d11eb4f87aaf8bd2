"""Format numbers for the messages of checks."""

import numpy as np

SHOWN_DIGITS = (6, 9, 12)  # of the numbers of a case: the fewest with which it still fails
ALL_DIGITS = 17
ORDINALS = "first", "second", "third", "fourth", "fifth", "sixth", "seventh", "eighth"


def format_tuple(numbers, rounding=1e-12, digits=4):
    """Return numbers in the form of a tuple, and a single number without brackets; rounding errors
    are written as 0.

    Parameters
    ----------
    numbers : array_like
    rounding : float, optional
        The largest rounding error.
    digits : int, optional

    Returns
    -------
    str

    Examples
    --------
    >>> format_tuple([0.1, -2, 1e-17]), format_tuple(1 / 3)
    ('(0.1, -2, 0)', '0.3333')
    """
    entries = [0 if abs(number) <= rounding else number for number in np.ravel(numbers)]
    written = [f"{entry:.{digits}g}" for entry in entries]
    return written[0] if np.size(numbers) == 1 else f"({', '.join(written)})"


def format_as_needed(numbers, holds, digits=4):
    """Return numbers in the form of a tuple, with so many digits that what is said of them is true
    of the numbers as they are written.

    Parameters
    ----------
    numbers : array_like
    holds : callable
        holds(written): whether it is true of these numbers, an array.
    digits : int, optional
        How many are tried first; then nine, and then all.

    Returns
    -------
    str

    Examples
    --------
    >>> format_as_needed([0.25, 1.99999], lambda written: (written < 2).all())
    '(0.25, 1.99999)'
    """
    for count in (digits, SHOWN_DIGITS[1]):
        written = np.array([float(f"{number:.{count}g}") for number in np.ravel(numbers)])
        if holds(written):
            return format_tuple(numbers, rounding=0, digits=count)
    return format_tuple(numbers, rounding=0, digits=ALL_DIGITS)


def format_array(numbers, digits=4):
    """Return an array on one line, its entries in the form in which messages show arrays.

    Parameters
    ----------
    numbers : array_like
    digits : int, optional
        The largest number of decimals.

    Returns
    -------
    str

    Examples
    --------
    >>> format_array([0.1, -2, 1 / 3], digits=2)
    '[0.1 -2 0.33]'
    """
    array = np.asarray(numbers, float)

    def entry(number):
        return f"{round(number, digits) + 0.0:.6g}"  # + 0.0: no -0

    return np.array2string(array, formatter={"float_kind": entry}).replace("\n", "")


def digits_of(array, digits):
    """Return the function that writes an entry of an array of floats with so many digits.

    With the fewest digits, rounding errors beside larger entries are written as 0. With more, the
    zero with a minus sign is written as a float, because Python reads -0 as 0.
    """
    if digits >= ALL_DIGITS:
        return lambda x: repr(float(x)) if _is_minus_zero(x) else repr(float(x)).removesuffix(".0")
    largest = np.abs(array[np.isfinite(array)]).max(initial=0)
    noise = 1e-13 * largest if digits == SHOWN_DIGITS[0] else 0

    def written(x):
        if digits > SHOWN_DIGITS[0] and _is_minus_zero(x):
            return "-0.0"
        return "0" if abs(x) <= noise else f"{x:.{digits}g}"

    return written


def _is_minus_zero(x):
    return x == 0 and bool(np.signbit(x))


def as_shown(case, digits):
    """Return the arguments of a case with the numbers in arrays as they are written.

    Examples
    --------
    >>> as_shown((np.array([2.0000000000000004, 1 / 3]), "world"), 6)
    (array([2.      , 0.333333]), 'world')
    """

    def shown(argument):
        if not isinstance(argument, np.ndarray) or argument.dtype.kind != "f":
            return argument
        written = digits_of(argument, digits)
        return np.array([float(written(x)) for x in argument.flat]).reshape(argument.shape)

    return tuple(map(shown, case))
