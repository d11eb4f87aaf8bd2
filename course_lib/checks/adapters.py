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


class Overwritten(ValueError):
    """A later call of the function has changed the matrix that an earlier one returned.

    value: what that was.
    """

    def __init__(self, value):
        super().__init__("a later call has changed this answer")
        self.value = value


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

    The function is then called with other symbols for the first half of the floats, with symbols
    for every other float, and with the floats themselves. The first answer that differs is
    returned. Whole numbers are passed unchanged. The symbols are real, have the names of the
    arguments, and differ from all symbols made elsewhere.
    Expressions are evaluated in SymPy's matrices and arrays, and in numpy's arrays, lists and
    tuples; any other answer is passed on unchanged. No text is ever parsed as an expression.

    The other symbols are plain ones, as sympy.symbols makes them, and have the names of the
    arguments in reverse: somebody who has symbols of these names too may confuse them.

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
    Overwritten
        If a later call has changed the matrix that an earlier one returned.

    Examples
    --------
    >>> with_symbols(lambda x: [2 * x, "x"], ["x"], [1.5])
    [3.0, 'x']
    """
    import sympy

    floats = [k for k, argument in enumerate(arguments) if isinstance(argument, float)]
    own = [sympy.Dummy(name, real=True) for name in names]
    plain = [sympy.Symbol(name) for name in reversed(names)]

    def asked(symbols, positions):
        """Return the answer to symbols in place of the floats at these positions."""
        given = [symbols[k] if k in positions else x for k, x in enumerate(arguments)]
        answer = function(*given)
        if isinstance(answer, sympy.MatrixBase):
            answers.append((answer, answer.copy()))
        return _evaluated(answer, {symbols[k]: sympy.Float(arguments[k]) for k in positions})

    answers = []
    first = asked(own, floats)
    half = floats[: (len(floats) + 1) // 2]
    others = (plain, half), (own, floats[::2]), (own, [])
    for symbols, positions in others if floats else ():
        other = asked(symbols, positions)
        if not _agree(first, other):
            return other
    if any(answer != as_it_came for answer, as_it_came in answers):
        raise Overwritten(first)
    return first


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
