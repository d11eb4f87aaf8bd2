"""dh_symbolic: the matrix of one link by its Denavit-Hartenberg parameters, as a formula."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.declared import declared
from course_lib.checks.kinds import ANGLE, LENGTH
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import SMALL_NUMBERS, Sweep
from course_lib.checks.vocabulary import LAST_ROW
from course_lib.rigid import transform
from course_lib.rotations import rot_x, rot_z

_MAX_ROUNDED = 0.01  # error of numbers that are rounded to two digits

_NUMPY_USED = (
    "a function of numpy or math is called with symbols",
    "SymPy has functions and matrices of the same names, which accept symbols and numbers.",
)
_NUMBERS_NOT_TAKEN = (
    "the function accepts symbols only",
    "SymPy's functions accept numbers too.",
)

# Each case takes milliseconds, and what is small has two sweeps of its own.
_LENGTH, _ANGLE = LENGTH.but(small=False), ANGLE.but(small=False, beside=())


def _cases(rng):
    """Whole numbers are passed as numbers, all others as symbols; see adapters.py. The last row's
    numbers have many digits, which simple fractions do not give."""
    whole = [(0, 0, 0, 0), (1, 0, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1), (0, 1, 0, 0)]
    some = [(1, 0, 0, 0.5), (0, np.pi / 2, 0, 0), (0.5, 0, 0, 0.5), (2, 1, 3, -2)]
    rows = [tuple(float(number) for number in row) for row in (*whole, *some)]
    return [*rows, tuple(_drawn(rng))]


def _drawn(rng):
    """Return a row of numbers far from all that is special."""
    sizes = rng.uniform([0.2, 0.5, 0.2, 0.5], [0.8, 1.1, 0.8, 1.1])
    return [float(number) for number in sizes * rng.choice([-1, 1], 4)]


def _nearly_a_quarter(rng, gap):
    """A row whose angles are nearly right angles: their cosines are small, and count."""
    a, alpha, d, _ = _drawn(rng)
    quarter = np.pi / 2
    return a, float(np.copysign(quarter, alpha) + 0.7 * gap), d, float(quarter - 0.4 * gap)


def _small(rng, size):
    return tuple(size * number for number in _drawn(rng))


def _right(a, alpha, d, theta):
    """Return the right matrix as numbers."""
    moved = transform(rot_z(theta), [0, 0, d])
    return moved @ transform(rot_x(alpha), [a, 0, 0])


def _symbolic(a, alpha, d, theta):
    """Return the standard DH matrix of one row, a SymPy Matrix."""
    from sympy import Matrix, cos, sin

    c, s, ca, sa = cos(theta), sin(theta), cos(alpha), sin(alpha)
    return Matrix(
        [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]]
    )


_COLUMN = Question(
    "a column is not that of Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha)",
    "Multiply the four matrices on paper, and compare the column named above with yours, entry by "
    "entry. Does each argument enter them as it came, also an angle of more than a revolution? The "
    "check passes these numbers, or symbols in place of some: is your matrix the same with both?",
    of_the_formula=True,
)
_ROUNDED = Question(
    "the numbers in the matrix are rounded, or replaced by simple fractions",
    "The column is nearly right. Numbers must stay as they are: which line of your code changes "
    "one, or computes with fewer digits?",
)


def _otherwise(T, *case):
    """Return the Mistake of a wrong column: small differences come from rounding."""
    return _ROUNDED if np.abs(T - _right(*case)).max() < _MAX_ROUNDED else _COLUMN


EXERCISE = declared(
    "dh_symbolic",
    points=1,
    sets=1,
    arguments={"a": _LENGTH, "alpha": _ANGLE, "d": _LENGTH, "theta": _ANGLE},
    cases=_cases,
    through="symbols",
    special=None,  # each case takes milliseconds
    library=_symbolic,
    reads=numbers(lambda *case: (4, 4)),
    properties=(LAST_ROW,),
    says="the matrix is the product Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha)",
    otherwise=_otherwise,
    sweeps=(
        Sweep("angles of nearly a quarter of a revolution", _nearly_a_quarter, SMALL_NUMBERS),
        Sweep("small numbers", _small, SMALL_NUMBERS),
    ),
    hints=(
        "Make four SymPy matrices, each 4 x 4: Rot_z(theta), Trans_z(d), Trans_x(a), Rot_x(alpha).",
        "Rot_z(theta) = Matrix([[cos, -sin, 0, 0], [sin, cos, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]), "
        "with sp.cos(theta) and sp.sin(theta). Rot_x has the same four entries in its rows and "
        "columns of y and z.",
        "Multiply them in this order with * or @. Use the arguments as they come: symbols, or "
        "numbers.",
    ),
    mistakes=(
        Mistake(*_NUMPY_USED, raises=("TypeError", "Cannot convert expression to float")),
        Mistake(*_NUMPY_USED, raises=("TypeError", "which has no callable")),
        Mistake(*_NUMPY_USED, raises=("AttributeError", "'Dummy' object has no attribute")),
        Mistake(*_NUMBERS_NOT_TAKEN, raises=("AttributeError", "'int' object has no attribute")),
        Mistake(*_NUMBERS_NOT_TAKEN, raises=("AttributeError", "'float' object has no attribute")),
        Mistake(
            "an if or a comparison asks for the value of a symbol, which has none",
            "The matrix is one formula for all values. No case needs a branch of its own.",
            raises=("TypeError", "cannot determine truth value of Relational"),
        ),
        Mistake(
            "the matrix is that of the modified convention",
            "With which of the four motions does the standard convention begin?",
            lambda a, alpha, d, theta: (
                transform(rot_x(alpha), [a, 0, 0]) @ transform(rot_z(theta), [0, 0, d])
            ),
        ),
    ),
)
