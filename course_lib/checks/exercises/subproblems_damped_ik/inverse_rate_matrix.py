"""inverse_rate_matrix: from the angular velocity back to the rates of three angles."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.subproblems_damped_ik.rate_matrix import quadrants, rates
from course_lib.checks.format_numbers import format_array
from course_lib.rotations import rot_y

_SMALL = 0.01  # sines below this are near zero


def _cases(rng):
    quarter = np.pi / 2
    named = [[0, quarter, 0], [quarter, quarter, 0], [0, -quarter, 0], [0, 0.5, 0], [0.5, quarter, 0]]
    small = [[0.6, 1e-3, -0.8], [-1.1, -1e-3, 0.5], [0.8, np.pi - 1e-3, 0.2], [-2.0, 1e-3 - np.pi, 1.0]]
    return [(np.array(b, float),) for b in named + quadrants(rng) + small] + [(np.array([1, 2, 3]),)]


def _near_the_end(b):
    return abs(np.sin(b[1])) < _SMALL


def _right(b):
    return np.linalg.inv(rates(b))


def _close(X, b):
    return np.abs(rates(b) @ X - np.eye(3)).max() < 1e-9 * np.linalg.norm(_right(b))


def _product(X, b):
    return f"With yours A times it is {format_array(rates(b) @ X, 3)}."


def _by_formula(first, third):
    """A prediction: the formula of the inverse with first(b2) and third(b2) for the 1/sin b2 in rows 1 and 3."""

    def prediction(b):
        c1, s1, c2 = np.cos(b[0]), np.sin(b[0]), np.cos(b[1])
        f, g = first(b[1]), third(b[1])
        return np.array([[-s1 * c2 * f, 1, -c1 * c2 * f], [c1, 0, -s1], [s1 * g, 0, c1 * g]])

    return prediction


def _cosecant(b2):
    return 1 / np.sin(b2)


def _minus(b2):
    return -1 / np.sin(b2)


def _reciprocals(b):
    A = rates(b)
    return np.divide(1, A, out=np.full((3, 3), np.inf), where=A != 0)


def _with_first(quotient):
    """A prediction: the inverse with quotient(b2) for cos b2 / sin b2 in row 1."""

    def prediction(b):
        exact = _right(b)
        exact[0, [0, 2]] = -quotient(b[1]) * np.array([np.sin(b[0]), np.cos(b[0])])
        return exact

    return prediction


EXERCISE = Exercise(
    name="inverse_rate_matrix",
    points=2,
    arguments=("b",),
    cases=_cases,
    returns=numbers(lambda b: (3, 3)),
    properties=(
        Property(
            "A times the answer is the identity, with the matrix A of omega = A b'",
            _close,
            _product,
            where=lambda b: not _near_the_end(b),
        ),
        Property(
            "A times the answer is the identity, also where sin b2 is small",
            _close,
            _product,
            where=_near_the_end,
            mistake=Mistake(
                "a small sin b2 is treated as if it were zero",
                "0.001 is no zero: A still has an inverse, with large entries. Nothing need be added or cut off.",
            ),
        ),
    ),
    mistakes=(
        Mistake(
            "A is transposed rather than inverted",
            "Only for rotations is the transpose the inverse. The columns of A are unit vectors, but the first and "
            "the third do not stand at a right angle.",
            lambda b: rates(b).T,
        ),
        Mistake("A itself is returned", "From omega back to the rates: A^-1.", rates),
        Mistake(
            "each entry is inverted by itself",
            "The inverse of a matrix is another matrix than that of the reciprocals 1 / A.",
            _reciprocals,
        ),
        Mistake(
            "the division by sin b2 is missing",
            "A^-1 = adj(A) / det A, and det A = -sin b2.",
            _by_formula(np.ones_like, np.ones_like),
            _by_formula(np.ones_like, _cosecant),
            _by_formula(_cosecant, np.ones_like),
            lambda b: -np.sin(b[1]) * _right(b),
            lambda b: np.sin(b[1]) * _right(b),
        ),
        Mistake(
            "sin b2 is multiplied by, not divided by",
            "A^-1 = adj(A) / det A, and det A = -sin b2.",
            _by_formula(np.sin, np.sin),
            lambda b: np.sin(b[1]) ** 2 * _right(b),
        ),
        Mistake("the whole inverse has the wrong sign", "det A is -sin b2, not sin b2.", lambda b: -_right(b)),
        Mistake(
            "the sign of sin b2 is lost",
            "For a negative b2 the determinant -sin b2 is positive.",
            _by_formula(lambda b2: abs(_cosecant(b2)), lambda b2: abs(_cosecant(b2))),
            lambda b: np.sign(np.sin(b[1])) * _right(b),
            lambda b: -np.sign(np.sin(b[1])) * _right(b),
        ),
        Mistake(
            "the inverse is transposed",
            "The adjugate is the transpose of the matrix of cofactors.",
            lambda b: _right(b).T,
        ),
        Mistake(
            "1/sin b2 has the wrong sign in row 1 or row 3",
            "A times your answer is to be the identity: try it with numbers.",
            _by_formula(_minus, _cosecant),
            _by_formula(_cosecant, _minus),
            _by_formula(_minus, _minus),
        ),
        Mistake(
            "Ry(b1) is on the wrong side, or is not inverted",
            "(Ry(b1) B)^-1 = B^-1 Ry(-b1): the factors change places, and each is inverted.",
            lambda b: rot_y(-b[0]) @ _right(b * [0, 1, 1]),
            lambda b: rot_y(b[0]) @ _right(b * [0, 1, 1]),
            lambda b: _right(b * [0, 1, 1]) @ rot_y(b[0]),
            lambda b: _right(b * [0, 1, 1]),
        ),
        Mistake(
            "cos b2 / sin b2 is missing in row 1, or upside down",
            "From omega, b3' is read off first. Then b1' = (second number of Ry(-b1) omega) - cos(b2) b3'.",
            _with_first(lambda b2: 0.0),
            _with_first(np.tan),
            _with_first(lambda b2: 1.0),
            _with_first(lambda b2: 1 / np.sin(b2)),
        ),
        Mistake(
            "the inverse is damped",
            "Where sin b2 is not 0 there is an inverse: nothing need be added to the matrix.",
            *(lambda b, e=e: np.linalg.solve(rates(b).T @ rates(b) + e * np.eye(3), rates(b).T) for e in (1e-6, 0.01)),
        ),
    ),
    library=_right,
    hints=(
        "Take Ry(b1) out: A = Ry(b1) [e_y, e_x, Rx(b2) e_y]. On the right, two columns hold zeros and ones only.",
        "Solve [e_y, e_x, Rx(b2) e_y] x = u entry by entry: first x3, from the entry with sin b2. Then "
        "u = Ry(-b1) omega.",
        "To test it: rate_matrix(b) @ inverse_rate_matrix(b) is the identity, to rounding.",
        "Rows 1 to 3: (-s1 c2 / s2, 1, -c1 c2 / s2), (c1, 0, -s1), (s1 / s2, 0, c1 / s2).",
    ),
    forbidden=tuple(f"numpy.linalg.{name}" for name in ("inv", "pinv", "solve", "lstsq")),
)
