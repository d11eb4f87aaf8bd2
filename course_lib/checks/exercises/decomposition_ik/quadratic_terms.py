"""quadratic_terms: the terms of a polynomial of degree two in x and y."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.vocabulary import away_from_zero, near

_TOO_FEW = Mistake(
    "some of the six terms are missing", "Which terms of degree 0, which of degree 1, which of degree 2 are there?"
)
_ONE_POSITION = Mistake("xy is taken for one position", "It holds one in each row. Where are all x?")


def quadratic_terms(xy, product=lambda x, y: x * y, square=np.square, one=1.0):
    """Return the terms (m, 6) of positions (m, 2): 1, x, y, x^2, x y, y^2."""
    x, y = np.asarray(xy, float).T
    return np.column_stack([np.full(len(x), one), x, y, square(x), product(x, y), square(y)])


def _cases(rng):
    simple = [[2.0, 3.0]], [[0.5, -1.0]]
    return [(np.array(xy),) for xy in (*simple, *(away_from_zero(rng, (m, 2)) for m in (1, 3, 8)), np.array([[1, 2]]))]


EXERCISE = Exercise(
    name="quadratic_terms",
    points=1,
    arguments=("xy",),
    cases=_cases,
    returns=numbers(
        lambda xy: (len(xy), 6),
        lambda array, xy: _TOO_FEW if array.shape[:-1] == (len(xy),) and array.shape[-1] < 6 else None,
    ),
    library=quadratic_terms,
    properties=(
        Property(
            "each row holds 1, x, y, x^2, x y, y^2, in this order",
            lambda terms, xy: near(terms, quadratic_terms(xy)),
            says=lambda terms, xy: f"Your row for {format_tuple(xy[0])} is {format_tuple(terms[0])}.",
        ),
    ),
    errors=(("ValueError", "values to unpack", _ONE_POSITION),),
    hints=(
        "x, y = xy.T gives all x and all y.",
        "There are six terms of degree two at most: one constant, two linear ones, three of degree two.",
        "np.column_stack([np.ones(len(xy)), x, y, ...]) puts them side by side.",
    ),
)


@EXERCISE.mistake
def whole_numbers(xy):
    """the array holds whole numbers only, and digits after the point are cut off. Which kind of array do you make?"""
    return np.trunc(quadratic_terms(xy))


@EXERCISE.mistake(
    order=([0, 1, 2, 3, 5, 4], [3, 4, 5, 1, 2, 0], [1, 2, 3, 4, 5, 0], [0, 2, 1, 5, 4, 3], [5, 4, 3, 2, 1, 0])
)
def another_order(xy, order):
    """the terms are in another order. Compare each column with the list in the task: which is wrong?"""
    return quadratic_terms(xy)[:, order]


@EXERCISE.mistake(product=(lambda x, y: 2 * x * y, lambda x, y: x + y, lambda x, y: (x * y) ** 2, lambda x, y: 0 * x))
def another_product(xy, product):
    """the fifth term is not x y. Which factor, and which powers, does it have in the task?"""
    return quadratic_terms(xy, product)
