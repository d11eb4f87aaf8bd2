"""fit_square: a model of one branch in one cell that is smooth where the arm is stretched."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.vocabulary import two_link_angles
from course_lib.lessons.decomposition_ik.cells import quadratic_terms
from course_lib.lessons.decomposition_ik.exercises.shared import with_one

_ONE_COLUMN_LESS = Mistake(
    "the factor of q2 has no column", "How many numbers has each row, and what is the last one?"
)


def _least_squares(terms, wanted):
    return np.linalg.lstsq(terms, wanted, rcond=None)[0]


def fit_square(terms, q, target=np.square, extra=lambda q2: q2):
    """Return the model (2, k + 1): q1 by the terms (m, k) and q2, and the square of q2 by the
    terms."""
    terms, q = np.asarray(terms, float), np.asarray(q, float)
    first = _least_squares(np.column_stack([terms, extra(q[:, 1])]), q[:, 0])
    return np.array([first, [*_least_squares(terms, target(q[:, 1])), 0]])


def _cases(rng):
    found = []
    for k, m in enumerate((5, 6, 20, 30)):
        middle = rng.uniform(1.2, 1.5) * np.array([np.cos(a := rng.uniform(0.5, 2.2)), np.sin(a)])
        xy = middle + rng.uniform(-0.3, 0.3, (m, 2))
        found.append(((with_one(xy), quadratic_terms(xy))[k // 2], two_link_angles(xy)[:, k % 2]))
    return found


def _row(j):
    """Return whether row j fits as well as the best one, at the samples."""

    def holds(model, terms, q):
        columns = np.column_stack([terms, q[:, 1]])
        return np.abs(columns @ (model[j] - fit_square(terms, q)[j])).max() < 1e-7

    return holds


EXERCISE = Exercise(
    name="fit_square",
    points=2,
    arguments=("terms", "q"),
    cases=_cases,
    returns=numbers(lambda terms, q: (2, terms.shape[1] + 1)),
    library=fit_square,
    properties=(
        Property("row 1, times the terms, fits the square of q2 with the least squares", _row(1)),
        Property(
            "the last entry of row 1 is 0: the square of q2 is fitted by the terms alone",
            lambda model, *case: abs(model[1, -1]) < 1e-12,
        ),
        Property(
            "row 0, times the terms and q2, fits q1 with the least squares",
            _row(0),
            mistake=Mistake(
                "row 0 is no fit of q1 by the terms and q2 together",
                "Which columns has A, in which order?",
            ),
        ),
    ),
    hints=(
        "np.linalg.lstsq(A, b)[0] returns the coefficients c for which A @ c comes closest to b.",
        "What is A and what is b for row 1? What does a query know when it computes the square of "
        "q2?",
        "For row 0, A has one column more than the terms, and this row has one factor more. Which "
        "column is that?",
    ),
)

EXERCISE.mistake(
    Mistake("nan stands in the model", "The last entry of row 1 is 0."), nan=lambda terms, q: True
)
EXERCISE.mistake(_ONE_COLUMN_LESS, form=lambda array, terms, q: array.shape == (2, terms.shape[1]))


@EXERCISE.mistake(
    "q2, or |q2|, is fitted, not its square",
    "Which of the three is smooth at the edge of the workspace?",
    target=(np.positive, np.abs),
)
def not_the_square(terms, q, target):
    return fit_square(terms, q, target)


@EXERCISE.mistake(
    "q1 has no term in q2",
    "Is q1 alone a smooth function of the position?",
)
def q1_without_q2(terms, q):
    return np.array([[*_least_squares(terms, q[:, 0]), 0], fit_square(terms, q)[1]])


@EXERCISE.mistake(
    "the square of q2 has a term in q2",
    "What does a query know when it computes the square?",
)
def square_by_q2(terms, q):
    columns = np.column_stack([terms, q[:, 1]])
    return np.array([fit_square(terms, q)[0], _least_squares(columns, q[:, 1] ** 2)])


@EXERCISE.mistake(
    "q1 has a term in the square of q2",
    "Of what is the last entry of row 0 the factor?",
)
def q1_with_the_square(terms, q):
    return fit_square(terms, q, extra=np.square)
