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
    if not np.isfinite(X).all():
        return "Yours holds nan or inf."
    return f"With yours A times it is {format_array(rates(b) @ X, 3)}."


EXERCISE = Exercise(
    name="inverse_rate_matrix",
    points=2,
    arguments=("b",),
    cases=_cases,
    returns=numbers(lambda b: (3, 3), gaps=True),
    library=_right,
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
                "Does A have an inverse if sin b2 is 0.001, and how large are its entries?",
            ),
        ),
    ),
    hints=(
        "Take Ry(b1) out: A = Ry(b1) [e_y, e_x, Rx(b2) e_y]. On the right, two columns hold zeros and ones only.",
        "Solve [e_y, e_x, Rx(b2) e_y] x = u entry by entry: first x3, from the entry with sin b2. Then "
        "u = Ry(-b1) omega.",
        "To test it: rate_matrix(b) @ inverse_rate_matrix(b) is the identity, to rounding.",
        "Rows 1 to 3: (-s1 c2 / s2, 1, -c1 c2 / s2), (c1, 0, -s1), (s1 / s2, 0, c1 / s2).",
    ),
    forbidden=tuple(f"numpy.linalg.{name}" for name in ("inv", "pinv", "solve", "lstsq")),
)


@EXERCISE.mistake
def transposed_not_inverted(b):
    """A is transposed rather than inverted. For which matrices is the transpose the inverse? Are the columns of A
    perpendicular to each other?"""
    return rates(b).T


def _same_sizes(X, predicted, b):
    return np.allclose(np.abs(X), predicted, equal_nan=True)


@EXERCISE.mistake(alike=_same_sizes)
def each_entry_inverted(b):
    """each entry is inverted by itself. numpy's ** and / work entry by entry. Is that the inverse of a matrix?"""
    return 1 / np.abs(rates(b))


@EXERCISE.mistake(factor=(lambda s: s, lambda s: -s, lambda s: s * s, np.sign), of=([0], [2], [0, 2], [0, 1, 2]))
def not_divided(b, factor, of):
    """the division by sin b2 is missing, is a product, or has the wrong sign. What is det A, for a negative b2 too?"""
    exact = _right(b)
    exact[of, :: 2 if len(of) < 3 else 1] *= factor(np.sin(b[1]))
    return exact


@EXERCISE.mistake(product=(lambda R, B: R.T @ B, lambda R, B: R @ B, lambda R, B: B @ R, lambda R, B: B))
def first_rotation_wrong(b, product):
    """Ry(b1) is on the wrong side, is not inverted, or is left out. What is the inverse of a product of two
    matrices?"""
    return product(rot_y(b[0]), _right(b * [0, 1, 1]))


@EXERCISE.mistake(quotient=(lambda c, s: 0, lambda c, s: s / c, lambda c, s: 1, lambda c, s: 1 / s))
def row_1_wrong(b, quotient):
    """row 1 has another factor than cos b2 / sin b2. If b3' is known, how does omega depend on b1', with b3' taken
    out?"""
    exact = _right(b)
    exact[0, [0, 2]] = -quotient(np.cos(b[1]), np.sin(b[1])) * np.array([np.sin(b[0]), np.cos(b[0])])
    return exact
