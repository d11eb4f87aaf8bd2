"""Ways to call a student's function, in the process where it lives, so that plain data goes in and comes out.

An adapter is called as adapter(function, names, arguments) with the names and values of the function's arguments, and
returns what the function answers, as plain data where it can.
"""

import numpy as np

_DEPTH = 12  # how deep lists may stand in lists; plain.py refuses what lies deeper


class NoNumber(ValueError):
    """An entry of an answer that is no number, although there is a number for each argument; the message shows it."""


def directly(function, names, arguments):
    """Call the function with its arguments."""
    return function(*arguments)


def with_symbols(function, names, arguments):
    """Call the function with SymPy symbols for its floats; return its answer at these floats.

    Whole numbers go in as they are: such a function takes symbols and numbers alike. The symbols are real, are called
    as the arguments are, and are equal to none made elsewhere. Expressions are looked for in SymPy's matrices and
    arrays, and in numpy's arrays, lists and tuples; whatever else comes back is passed on as it is, and no text is
    ever made into an expression. Raises NoNumber where an expression has other symbols in it.
    """
    import sympy

    at, given = {}, []
    for name, argument in zip(names, arguments, strict=True):
        is_float = isinstance(argument, float)
        given.append(sympy.Dummy(name, real=True) if is_float else argument)
        if is_float:
            at[given[-1]] = sympy.Float(argument)
    return _evaluated(function(*given), at)


ADAPTERS = {"": directly, "symbols": with_symbols}


def _evaluated(value, at, depth=0):
    """The value, with numbers in place of the expressions in it."""
    import sympy

    if isinstance(value, sympy.MatrixExpr):
        value = value.as_explicit()
    if isinstance(value, sympy.MatrixBase | sympy.NDimArray):
        return np.array(_evaluated(value.tolist(), at))
    if isinstance(value, np.ndarray) and value.dtype == object:
        value = value.tolist()
    if isinstance(value, list | tuple) and depth <= _DEPTH:
        items = [_evaluated(item, at, depth + 1) for item in value]
        return items if isinstance(value, list) else tuple(items)
    return _number(value.xreplace(at)) if isinstance(value, sympy.Expr) else value


def _number(expression):
    try:
        number = complex(expression)
    except TypeError:
        raise NoNumber(str(expression)) from None
    return number.real if abs(number.imag) <= 1e-12 * abs(number.real) else number
