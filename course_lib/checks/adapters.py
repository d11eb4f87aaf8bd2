"""Adapters, which call a student's function in its own process, with plain data as arguments and
answer.

An adapter is called as adapter(function, names, arguments) with the names and values of the
function's arguments, and returns what the function answers, as plain data if possible.
"""

import numpy as np

_ROUNDING = 1e-12  # by which formulas with symbols and with numbers may differ
_MAX_DEPTH = 12  # how deep lists may be nested; wire.py refuses deeper ones


class NoNumber(ValueError):
    """An entry of an answer is not a number although each argument is one; the message shows the
    entry."""


def directly(function, names, arguments):
    """Return what the function answers, called with the arguments as they are.

    Parameters
    ----------
    function : callable
    names : list of str
        Of the arguments; not used.
    arguments : list
    """
    return function(*arguments)


def with_symbols(function, names, arguments):
    """Return what the function answers, called with SymPy symbols for its floats, as numbers for
    these floats.

    The function is then called with the floats themselves. If it answers otherwise, this is what is
    returned. Whole numbers are passed unchanged. The symbols are real, have the names of the
    arguments, and differ from all symbols made elsewhere. Expressions are evaluated in SymPy's
    matrices and arrays, and in numpy's arrays, lists and tuples; any other answer is passed on
    unchanged. No text is ever parsed as an expression.

    Parameters
    ----------
    function : callable
    names : list of str
        Of the arguments.
    arguments : list

    Raises
    ------
    NoNumber
        If an expression contains other symbols.

    Examples
    --------
    >>> with_symbols(lambda x: [2 * x, "x"], ["x"], [1.5])
    [3.0, 'x']
    """
    import sympy

    at, given = {}, []
    for name, argument in zip(names, arguments, strict=True):
        is_float = isinstance(argument, float)
        given.append(sympy.Dummy(name, real=True) if is_float else argument)
        if is_float:
            at[given[-1]] = sympy.Float(argument)
    by_symbols = _evaluated(function(*given), at)
    if not at:
        return by_symbols
    by_numbers = _evaluated(function(*arguments), {})
    return by_symbols if _agree(by_symbols, by_numbers) else by_numbers


ADAPTERS = {"": directly, "symbols": with_symbols}


def _agree(value, other, depth=0):
    """Return whether two answers agree to rounding; True for answers that are not numbers."""
    if depth > _MAX_DEPTH:
        return True
    if isinstance(value, list | tuple) and isinstance(other, list | tuple):
        same_length = len(value) == len(other)
        return same_length and all(map(_agree, value, other, [depth + 1] * len(value)))
    if not (_is_number(value) and _is_number(other)):
        return True
    try:
        return np.shape(value) == np.shape(other) and np.allclose(
            value, other, rtol=_ROUNDING, atol=_ROUNDING, equal_nan=True
        )
    except (OverflowError, TypeError):  # whole numbers of any size
        return value == other


def _is_number(value):
    """Return whether an answer is a number of Python's or an array of numbers."""
    if isinstance(value, np.ndarray):
        return value.dtype.kind in "biufc"
    return isinstance(value, int | float | complex)


def _evaluated(value, at, depth=0):
    """Return the value with numbers in place of its expressions."""
    import sympy

    if isinstance(value, sympy.MatrixExpr):
        value = value.as_explicit()
    if isinstance(value, sympy.MatrixBase | sympy.NDimArray):
        return np.array(_evaluated(value.tolist(), at))
    if isinstance(value, np.ndarray) and value.dtype == object:
        value = value.tolist()
    if isinstance(value, list | tuple) and depth <= _MAX_DEPTH:
        items = [_evaluated(item, at, depth + 1) for item in value]
        return items if isinstance(value, list) else tuple(items)
    return _number(value.xreplace(at)) if isinstance(value, sympy.Expr) else value


def _number(expression):
    try:
        number = complex(expression)
    except TypeError:
        raise NoNumber(str(expression)) from None
    return number.real if abs(number.imag) <= 1e-12 * abs(number.real) else number
