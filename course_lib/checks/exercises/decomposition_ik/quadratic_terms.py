"""quadratic_terms: the terms of a polynomial of degree two in x and y."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.vocabulary import away_from_zero, near

_SHAPES = {
    5: Mistake("one of the six terms is missing", "1, x, y, x^2, x y, y^2: the constant and the product count too."),
    3: Mistake("the terms of degree two are missing", "Add x^2, x y and y^2 to 1, x, y."),
}
_TRANSPOSED = Mistake("the terms are stacked along the first axis", "np.column_stack puts one position in each row.")
_LINEAR = (lambda x, y: 1 + 0 * x, lambda x, y: x, lambda x, y: y)
_SQUARES = (lambda x, y: x * x, lambda x, y: x * y, lambda x, y: y * y)


def _columns(*terms):
    return lambda xy: np.column_stack([term(*np.asarray(xy, float).T) for term in terms])


quadratic_terms = _columns(*_LINEAR, *_SQUARES)


def _known_form(array, xy):
    return _TRANSPOSED if array.shape == (6, len(xy)) else _SHAPES.get(array.shape[-1] if array.ndim == 2 else 0)


def _cases(rng):
    simple = [[2.0, 3.0]], [[0.5, -1.0]]
    return [(np.array(xy),) for xy in (*simple, *(away_from_zero(rng, (m, 2)) for m in (1, 3, 8)), np.array([[1, 2]]))]


EXERCISE = Exercise(
    name="quadratic_terms",
    points=1,
    arguments=("xy",),
    cases=_cases,
    returns=numbers(lambda xy: (len(xy), 6), _known_form),
    properties=(
        Property(
            "each row holds 1, x, y, x^2, x y, y^2, in this order", lambda terms, xy: near(terms, quadratic_terms(xy))
        ),
    ),
    mistakes=(
        Mistake(
            "the array holds whole numbers only, and digits after the point are cut off",
            "np.zeros((m, 6), int) has no room for digits: leave out int.",
            lambda xy: np.trunc(quadratic_terms(xy)),
        ),
        Mistake(
            "the product is counted twice",
            "The coefficients are fitted later: leave out the factor 2.",
            _columns(*_LINEAR, _SQUARES[0], lambda x, y: 2 * x * y, _SQUARES[2]),
        ),
        Mistake(
            "the terms are in another order",
            "1, x, y, x^2, x y, y^2.",
            _columns(*_LINEAR, _SQUARES[0], _SQUARES[2], _SQUARES[1]),
            _columns(*_SQUARES, *_LINEAR[1:], _LINEAR[0]),
            _columns(*_LINEAR[1:], *_SQUARES, _LINEAR[0]),
            _columns(_LINEAR[0], _LINEAR[2], _LINEAR[1], *_SQUARES[::-1]),
            _columns(*_SQUARES, *_LINEAR),
            lambda xy: quadratic_terms(xy)[:, ::-1],
            lambda xy: quadratic_terms(xy[:, ::-1]),
        ),
        Mistake(
            "the constant term is 0",
            "A constant is a multiple of 1: the first column holds ones.",
            _columns(lambda x, y: 0 * x, *_LINEAR[1:], *_SQUARES),
        ),
        Mistake(
            "** is taken for ^, or the squares are doubles",
            "x**2 is the square of x.",
            _columns(*_LINEAR, lambda x, y: 2 * x, _SQUARES[1], lambda x, y: 2 * y),
        ),
        Mistake(
            "the product is x + y",
            "The fifth term is x y.",
            _columns(*_LINEAR, _SQUARES[0], lambda x, y: x + y, _SQUARES[2]),
        ),
        Mistake(
            "the product of x and y is 0, or of another degree",
            "The fifth term is x y, as it stands.",
            _columns(*_LINEAR, _SQUARES[0], lambda x, y: 0 * x, _SQUARES[2]),
            _columns(*_LINEAR, _SQUARES[0], lambda x, y: (x * y) ** 2, _SQUARES[2]),
        ),
    ),
    errors=(
        (
            "ValueError",
            "values to unpack",
            Mistake("xy is taken for one position", "It holds one in each row: x, y = xy.T takes its columns."),
        ),
    ),
    hints=(
        "x, y = xy.T gives all x and all y.",
        "There are six terms of degree two at most: one constant, two linear ones, three of degree two.",
        "np.column_stack([np.ones(len(xy)), x, y, ...]) puts them side by side.",
    ),
    library=quadratic_terms,
)
