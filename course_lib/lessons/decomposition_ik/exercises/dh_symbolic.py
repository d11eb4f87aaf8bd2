"""dh_symbolic: the matrix of one link by its Denavit-Hartenberg parameters, as a formula."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake
from course_lib.checks.special_cases import SMALL_NUMBERS, Sweep
from course_lib.checks.vocabulary import COLUMNS, LAST_ROW, part_is
from course_lib.rigid import transform
from course_lib.rotations import rot_x, rot_z

_MAX_ROUNDED = 0.01  # error of numbers that are rounded to two digits

_NUMPY_USED = Mistake(
    "a function of numpy or math is called with symbols",
    "SymPy has functions and matrices of the same names, which accept symbols and numbers.",
)
_ASKED_A_SYMBOL = Mistake(
    "an if or a comparison asks for the value of a symbol, which has none",
    "The matrix is one formula for all values. No case needs a branch of its own.",
)
_NUMBERS_NOT_TAKEN = Mistake(
    "the function accepts symbols only", "SymPy's functions accept numbers too."
)


def _cases(rng):
    """Whole numbers are passed as numbers, all others as symbols; see adapters.py."""
    whole = [(0, 0, 0, 0), (1, 0, 0, 0), (0, 0, 1, 0), (0, 0, 0, 1), (0, 1, 0, 0)]
    some = [
        (1, 0, 0, 0.5),
        (0, np.pi / 2, 0, 0),
        (0.5, 0, 0, 0.5),
        (0.5, 0, *np.round(rng.uniform([0.2, 1.9], [0.4, 2.2]), 2)),
        (2, 1, 3, -2),
    ]
    sizes = rng.uniform([0.2, 0.3, 1.0, 0.4], [0.8, 1.2, 1.9, 1.3], (3, 4))
    drawn = np.round(sizes * [(1, 1, 1, 1), (1, -1, 1, 1), (-1, 1, -1, -1)], 2)
    large = np.round(rng.uniform([0.3, 2.4, -0.9, -2.2], [0.5, 2.7, -0.6, -1.9]), 2)
    # The last numbers have many digits, which simple fractions do not give.
    rows = [*drawn, large, sizes[0]]
    return whole + some + [tuple(float(number) for number in row) for row in rows]


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


def _factors(a, alpha, d, theta):
    still = np.zeros(3)
    moves = transform(np.eye(3), [0, 0, d]), transform(np.eye(3), [a, 0, 0])
    return transform(rot_z(theta), still), *moves, transform(rot_x(alpha), still)


def _right(*case):
    return np.linalg.multi_dot(_factors(*case))


def dh_symbolic(a, alpha, d, theta):
    """Return the standard DH matrix of one row, a SymPy Matrix."""
    from sympy import Matrix, cos, sin

    c, s, ca, sa = cos(theta), sin(theta), cos(alpha), sin(alpha)
    return Matrix(
        [[c, -s * ca, s * sa, a * c], [s, c * ca, -c * sa, a * s], [0, sa, ca, d], [0, 0, 0, 1]]
    )


_COLUMN = Mistake(
    "a column is not that of Rot_z(theta) Trans_z(d) Trans_x(a) Rot_x(alpha)",
    "Multiply the four matrices on paper, and compare the column named below with yours, entry by "
    "entry.",
)
_ROUNDED = Mistake(
    "the numbers in the matrix are rounded, or replaced by simple fractions",
    "Numbers must stay as they are. Which line of your code changes them?",
)


def _column(T, *case):
    """Return the Mistake of a wrong column: small differences come from rounding."""
    return _ROUNDED if np.abs(T - _right(*case)).max() < _MAX_ROUNDED else _COLUMN


EXERCISE = Exercise(
    name="dh_symbolic",
    points=1,
    sets=1,
    arguments=("a", "alpha", "d", "theta"),
    cases=_cases,
    through="symbols",
    returns=numbers(lambda *case: (4, 4)),
    library=dh_symbolic,
    sweeps=(
        Sweep("angles of nearly a quarter of a revolution", _nearly_a_quarter, SMALL_NUMBERS),
        Sweep("small numbers", _small, SMALL_NUMBERS),
    ),
    properties=(
        LAST_ROW,
        part_is(
            "the x axis, the first column, is rotated by theta about z", _right, COLUMNS[0], _column
        ),
        part_is(
            "the z axis, the third column, is rotated by alpha about x, then by theta about z",
            _right,
            COLUMNS[2],
            _column,
        ),
        part_is(
            "the y axis, the second column, is the cross product of the z axis and the x axis",
            _right,
            COLUMNS[1],
            _column,
        ),
        part_is(
            "the origin, the last column, is d up the old z, and then a along the new x",
            _right,
            COLUMNS[3],
            _column,
        ),
    ),
    hints=(
        "Make four SymPy matrices, each 4 x 4: Rot_z(theta), Trans_z(d), Trans_x(a), Rot_x(alpha).",
        "Rot_z(theta) = Matrix([[cos, -sin, 0, 0], [sin, cos, 0, 0], [0, 0, 1, 0], [0, 0, 0, 1]]), "
        "with sp.cos(theta) "
        "and sp.sin(theta). Rot_x has the same four entries in its rows and columns of y and z.",
        "Multiply them in this order with * or @. Use the arguments as they come: symbols, or "
        "numbers.",
    ),
)

EXERCISE.mistake(_NUMPY_USED, raises=("TypeError", "Cannot convert expression to float"))
EXERCISE.mistake(_NUMPY_USED, raises=("TypeError", "which has no callable"))
EXERCISE.mistake(_NUMPY_USED, raises=("AttributeError", "'Dummy' object has no attribute"))
EXERCISE.mistake(_NUMBERS_NOT_TAKEN, raises=("AttributeError", "'int' object has no attribute"))
EXERCISE.mistake(_NUMBERS_NOT_TAKEN, raises=("AttributeError", "'float' object has no attribute"))
EXERCISE.mistake(
    _ASKED_A_SYMBOL, raises=("TypeError", "cannot determine truth value of Relational")
)


@EXERCISE.mistake(
    "the matrix is that of the modified convention",
    "With which of the four motions does the standard convention begin?",
)
def modified(a, alpha, d, theta):
    return transform(rot_x(alpha), [a, 0, 0]) @ transform(rot_z(theta), [0, 0, d])
