"""fit_square: a model of one branch in one cell that is smooth where the arm is stretched."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercises.decomposition_ik.quadratic_terms import quadratic_terms
from course_lib.checks.exercises.decomposition_ik.shared import solutions, with_one
from course_lib.checks.exercise import Exercise, Mistake, Property

_ONE_COLUMN_LESS = Mistake("the factor of q2 has no column", "The answer has k + 1 columns; row 1 ends with a 0.")
_TRANSPOSED = Mistake("the model is transposed", "Row 0 is for q1, row 1 for the square of q2.")


def _least_squares(terms, wanted):
    return np.linalg.lstsq(terms, wanted, rcond=None)[0]


def fit_square(terms, q, target=np.square, extra=lambda q2: q2):
    """Return the model (2, k + 1): q1 by the terms (m, k) and q2, and the square of q2 by the terms."""
    terms, q = np.asarray(terms, float), np.asarray(q, float)
    first = _least_squares(np.column_stack([terms, extra(q[:, 1])]), q[:, 0])
    return np.array([first, [*_least_squares(terms, target(q[:, 1])), 0]])


def _q2_in_both(terms, q):
    both = np.column_stack([terms, q[:, 1]])
    return np.array([fit_square(terms, q)[0], _least_squares(both, q[:, 1] ** 2)])


def _of_equal_links(terms, q):
    """The answer of those who subtract -q2 / 2, which the closed form knows, before they fit q1."""
    return np.array([[*_least_squares(terms, q[:, 0] + q[:, 1] / 2), -0.5], fit_square(terms, q)[1]])


def _without_constant(terms, q):
    """The factors of scikit-learn's LinearRegression, whose constant term is kept in another attribute."""

    def factors(columns, wanted):
        return _least_squares(columns - columns.mean(axis=0), wanted - wanted.mean())

    return np.array([factors(np.column_stack([terms, q[:, 1]]), q[:, 0]), [*factors(terms, q[:, 1] ** 2), 0]])


def _cases(rng):
    found = []
    for k, m in enumerate((5, 6, 20, 30)):
        middle = rng.uniform(1.2, 1.5) * np.array([np.cos(a := rng.uniform(0.5, 2.2)), np.sin(a)])
        xy = middle + rng.uniform(-0.3, 0.3, (m, 2))
        found.append(((with_one(xy), quadratic_terms(xy))[k // 2], solutions(xy)[:, k % 2]))
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
    returns=numbers(
        lambda terms, q: (2, terms.shape[1] + 1),
        lambda array, terms, q: {terms.shape[1]: _ONE_COLUMN_LESS, 2: _TRANSPOSED}.get(
            array.shape[-1] if array.ndim else 0
        ),
    ),
    properties=(
        Property("row 1, times the terms, fits the square of q2 with the least squares", _row(1)),
        Property(
            "the last entry of row 1 is 0: the square of q2 is fitted by the terms alone",
            lambda model, *case: abs(model[1, -1]) < 1e-12,
        ),
        Property("row 0, times the terms and q2, fits q1 with the least squares", _row(0)),
    ),
    mistakes=(
        Mistake(
            "q2 itself is fitted, not its square",
            "Near the edge q2 is a root of the position; q2**2 is smooth.",
            lambda terms, q: fit_square(terms, q, target=np.positive),
        ),
        Mistake(
            "|q2| is fitted, not its square",
            "The absolute value has the same root at the edge: take q2**2.",
            lambda terms, q: fit_square(terms, q, target=np.abs),
        ),
        Mistake(
            "q1 has no term in q2",
            "q1 is smooth only together with a multiple of q2: append q[:, 1] to the terms as a last column.",
            lambda terms, q: np.array([[*_least_squares(terms, q[:, 0]), 0], fit_square(terms, q)[1]]),
        ),
        Mistake(
            "q1 has a term in the square of q2, or in |q2|",
            "The last column is q2 itself, with its sign.",
            lambda terms, q: fit_square(terms, q, extra=np.square),
            lambda terms, q: fit_square(terms, q, extra=np.abs) if (q[:, 1] < 0).any() else None,
        ),
        Mistake(
            "the factor of q2 is -1/2, which the closed form knows, and is not fitted",
            "A table knows samples only: append q[:, 1] to the terms, and let the fit find its factor.",
            _of_equal_links,
        ),
        Mistake(
            "the coefficients are squared, not the samples",
            "Square q[:, 1] first, then fit: the square of a fit is not the fit of the square.",
            lambda terms, q: np.array([fit_square(terms, q)[0], [*_least_squares(terms, q[:, 1]) ** 2, 0]]),
        ),
        Mistake(
            "the constant term is lost: LinearRegression fits one of its own and keeps it in intercept_",
            "The terms contain the 1 already: LinearRegression(fit_intercept=False), or np.linalg.lstsq.",
            _without_constant,
        ),
        Mistake(
            "the square of q2 has a term in q2", "A query knows no q2 yet: row 1 uses the terms alone.", _q2_in_both
        ),
        Mistake(
            "the rows are swapped",
            "Row 0 is for q1, row 1 for the square of q2.",
            lambda *case: fit_square(*case)[::-1],
        ),
        Mistake(
            "the column of q2 stands first",
            "The terms come first, q2 last.",
            lambda *case: np.roll(fit_square(*case), 1, axis=1),
            lambda *case: np.stack([np.roll(fit_square(*case)[0], 1), fit_square(*case)[1]]),
        ),
        Mistake(
            "both angles are squared",
            "q1 is fitted as it is.",
            lambda terms, q: fit_square(terms, q ** [2, 1]),
        ),
        Mistake("q1 and q2 are swapped", "q[:, 1] is q2.", lambda terms, q: fit_square(terms, q[:, ::-1])),
    ),
    hints=(
        "np.linalg.lstsq(A, b)[0] returns the coefficients c for which A @ c comes closest to b.",
        "Row 1: A is terms, b is the square of q[:, 1]; append a 0. It has no term in q2, which a query does not know.",
        "Row 0: A is np.column_stack([terms, q[:, 1]]), b is q[:, 0].",
    ),
    library=fit_square,
)
