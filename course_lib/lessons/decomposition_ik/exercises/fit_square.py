"""fit_square: a model of one branch in one cell that is smooth where the arm is stretched."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.tolerances import HALF_THE_DIGITS
from course_lib.checks.vocabulary import two_link_angles
from course_lib.lessons.decomposition_ik.cells import quadratic_terms
from course_lib.lessons.decomposition_ik.exercises.shared import with_one

_ONE_COLUMN_LESS = Mistake(
    "the coefficient of q2 has no column",
    "How many numbers does each row hold, and what is the last one?",
)


_WHOLE_TERMS = np.array([[1, 0, 0], [1, 1, 0], [1, 0, 1], [1, 2, 1], [1, -1, 2], [1, 1, -2]])
_WHOLE_ANGLES = np.array([[1, 2], [0, 1], [2, -1], [1, 1], [3, 2], [-1, 2]])


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
    return [*found, (_WHOLE_TERMS, _WHOLE_ANGLES)]


def _row(j):
    """Return whether row j fits as well as the best one, at the samples."""

    def holds(model, terms, q):
        columns = np.column_stack([terms, q[:, 1]])
        off = np.abs(columns @ (model[j] - fit_square(terms, q)[j])).max()
        return off < HALF_THE_DIGITS

    return holds


EXERCISE = Exercise(
    name="fit_square",
    points=2,
    arguments=("terms", "q"),
    cases=_cases,
    returns=numbers(lambda terms, q: (2, terms.shape[1] + 1)),
    library=fit_square,
    properties=(
        Property(
            "row 1, times the terms, fits the square of q2 with the least sum of squares", _row(1)
        ),
        Property(
            "the last entry of row 1 is 0: the square of q2 is fitted by the terms alone",
            lambda model, *case: abs(model[1, -1]) < 1e-12,
        ),
        Property(
            "row 0, times the terms and q2, fits q1 with the least sum of squares",
            _row(0),
            mistake=Mistake(
                "row 0 is not the least-squares fit of q1 by the terms and q2 together",
                "Print the sum of squares of A @ row - q1, with A made of the terms and of q2. "
                "Which "
                "of your coefficients is not found by this fit?",
            ),
        ),
    ),
    hints=(
        "np.linalg.lstsq(A, b)[0] returns the coefficients c for which A @ c comes closest to b.",
        "What is A and what is b for row 1? What does a query know when it computes the square of "
        "q2?",
        "For row 0, A has one column more than the terms, and the row has one coefficient more. "
        "Which column is that?",
    ),
)

EXERCISE.mistake(
    Mistake("nan stands in the model", "The last entry of row 1 is 0."), nan=lambda terms, q: True
)
EXERCISE.mistake(_ONE_COLUMN_LESS, form=lambda array, terms, q: array.shape == (2, terms.shape[1]))


@EXERCISE.mistake(
    "q2 or |q2| is fitted, not the square of q2",
    "Which of the three is smooth at the edge of the workspace?",
    target=(np.positive, np.abs),
)
def not_the_square(terms, q, target):
    return fit_square(terms, q, target)


@EXERCISE.mistake(
    "q1 is fitted without a term in q2",
    "Is q1 alone a smooth function of the position?",
)
def q1_without_q2(terms, q):
    return np.array([[*_least_squares(terms, q[:, 0]), 0], fit_square(terms, q)[1]])


@EXERCISE.mistake(
    "the square of q2 is fitted with a term in q2",
    "Which angle does a query not know yet when it computes the square of q2?",
)
def square_by_q2(terms, q):
    columns = np.column_stack([terms, q[:, 1]])
    return np.array([fit_square(terms, q)[0], _least_squares(columns, q[:, 1] ** 2)])


@EXERCISE.mistake(
    "q1 is fitted with a term in |q2|, or in the square of q2, instead of q2",
    "The last entry of row 0 is a coefficient. Which quantity does it multiply?",
    extra=(np.square, np.abs),
)
def q1_with_another_term(terms, q, extra):
    found = fit_square(terms, q, extra=extra)
    # For samples with q2 > 0 alone, |q2| is q2.
    return None if np.array_equal(extra(q[:, 1]), q[:, 1]) else found


@EXERCISE.mistake(
    "the coefficient of q2 is set to -1/2 and not fitted",
    "For which arm does -1/2 hold, and what does the task say about the coefficients?",
)
def coefficient_put_in(terms, q):
    found = fit_square(terms, q)
    found[0] = [*_least_squares(terms, q[:, 0] + q[:, 1] / 2), -0.5]
    return found


@EXERCISE.mistake(
    "the terms are fitted first, and q2 is fitted to the residuals afterwards",
    "Do two fits, one after the other, reach the least sum of squares of one fit with all columns?",
)
def one_after_the_other(terms, q):
    found = fit_square(terms, q)
    first = _least_squares(terms, q[:, 0])
    residual = q[:, 0] - terms @ first
    found[0] = [*first, residual @ q[:, 1] / (q[:, 1] @ q[:, 1])]
    return found
