"""fit_square: a model of one branch in one cell that is smooth where the arm is stretched."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.kinds import OWN_CASES, whole_numbers
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import compared, two_link_angles
from course_lib.lessons.decomposition_ik.cells import quadratic_terms
from course_lib.lessons.decomposition_ik.exercises.shared import some_twice, with_one

_ROUNDING = 1e-14  # of A^T A, relative
_SMALL_BENDS = (9e-2, 9e-3, 9e-4)  # rad: with smaller ones rounding hides the fit
_WHOLE_TERMS = np.array([[1, 0, 0], [1, 1, 0], [1, 0, 1], [1, 2, 1], [1, -1, 2], [1, 1, -2]])
_WHOLE_ANGLES = np.array([[1, 2], [0, 1], [2, -1], [1, 1], [3, 2], [-1, 2]])


def _least_squares(terms, wanted):
    return np.linalg.lstsq(terms, wanted, rcond=None)[0]


def _fitted(target=np.square, extra=lambda q2: q2):
    """Return the answer whose row 1 fits target(q2), and whose row 0 has a term extra(q2)."""

    def answer(terms, q):
        terms, q = np.asarray(terms, float), np.asarray(q, float)
        first = _least_squares(np.column_stack([terms, extra(q[:, 1])]), q[:, 0])
        return np.array([first, [*_least_squares(terms, target(q[:, 1])), 0]])

    return answer


_right = _fitted()


def _cases(rng):
    found = []
    for k, m in enumerate((5, 6, 20, 20)):
        middle = rng.uniform(1.2, 1.5) * np.array([np.cos(a := rng.uniform(0.5, 2.2)), np.sin(a)])
        xy = middle + rng.uniform(-0.3, 0.3, (m, 2))
        found.append(((with_one(xy), quadratic_terms(xy))[k // 2], two_link_angles(xy)[:, k % 2]))
    terms, q = found[1]
    revolved = terms, q + 2 * np.pi * np.array([2, 0])
    twice = some_twice(terms, q)
    whole = [(_WHOLE_TERMS, _WHOLE_ANGLES), *_whole_in_one(rng)]
    return [*found, _without_a_constant(rng), revolved, twice, *whole]


def _whole_in_one(rng):
    """Return samples with whole numbers in one array and fractions in the other, in both ways: a
    column that is added to the whole ones must not become whole."""
    fractions = rng.uniform(0.2, 0.8, (6, 2))
    return (
        (_WHOLE_TERMS, _WHOLE_ANGLES + fractions),
        (_WHOLE_TERMS + 0.5 * with_one(fractions), _WHOLE_ANGLES),
    )


def _without_a_constant(rng):
    """Return samples with six terms, none of which is constant."""
    x, y = rng.uniform(-1, 1, (2, 8))
    terms = np.column_stack([x, y, x**2, x * y, y**2, x**3])
    return terms, two_link_angles(np.column_stack([0.3 * x, 1.3 + 0.3 * y]))[:, 0]


def _nearly_stretched(rng, size):
    """Return samples whose q2 are small."""
    terms = with_one(rng.uniform([0.1, 1.6], [0.7, 2.2], (8, 2)))
    return terms, rng.uniform([0.5, -size], [1.5, size], (8, 2))


def _special(rng):
    """Samples in whole numbers, some of them equal, that determine all coefficients; None now and
    then."""
    terms, q = with_one(whole_numbers(rng, (8, 2))), whole_numbers(rng, (8, 2))
    return (terms, q) if np.linalg.matrix_rank(_columns(terms, q)) == 4 else None


def _columns(terms, q):
    return np.column_stack([terms, q[:, 1]])


def _off(model, terms, q):
    """Return how far each row is from the right one, (2,), by what both give at the samples."""
    return np.abs(_columns(terms, q) @ (model - _right(terms, q)).T).max(0)


def _misfits(model, terms, q):
    """Return how far each row is off, (2,), as a share of what rounding in A^T A does."""
    rounding = _ROUNDING / EXACT * np.linalg.cond(_columns(terms, q)) ** 2
    return _off(model, terms, q) / max(1, rounding)


def _distance(model, right, terms, q):
    return _misfits(model, terms, q).max()


def _found(model, terms, q):
    j = 1 if _misfits(model, terms, q)[1] > EXACT else 0
    right = _right(terms, q)[j]
    rows = f"Row {j} should be " + compared(right, model[j])
    at_samples = f"{_off(model, terms, q)[j]:.2g} at one of the samples."
    return (
        rows
        + ". Times the terms and q2, this row of yours and the right one differ by "
        + at_samples
    )


_OTHER_ROW_0 = Question(
    "row 0 is not the least-squares fit of q1 by the terms and q2 together",
    "Print the sum of squares of A @ row - q1 for your row and for the right one, with A made of "
    "the terms and of q2. Which of your coefficients come from another fit, or are changed?",
)


def _otherwise(model, terms, q):
    return None if _misfits(model, terms, q)[1] > EXACT else _OTHER_ROW_0


def _with_row_0(row):
    """Return the answer whose row 0 is row(terms, q)."""
    return lambda terms, q: np.array([row(terms, q), _right(terms, q)[1]])


def _square_by_q2(terms, q):
    return np.array([_right(terms, q)[0], _least_squares(_columns(terms, q), q[:, 1] ** 2)])


def _with_another_term(extra):
    """Return the answer with a term extra(q2); for samples with q2 > 0 alone, |q2| is q2."""
    answer = _fitted(extra=extra)
    return lambda terms, q: None if np.array_equal(extra(q[:, 1]), q[:, 1]) else answer(terms, q)


def _one_after_the_other(terms, q):
    first = _least_squares(terms, q[:, 0])
    residual = q[:, 0] - terms @ first
    return [*first, residual @ q[:, 1] / (q[:, 1] @ q[:, 1])]


EXERCISE = declared(
    "fit_square",
    points=2,
    arguments={"terms": OWN_CASES, "q": OWN_CASES},
    cases=_cases,
    library=_right,
    distance=_distance,
    says="no other rows have a smaller sum of squares: row 1, times the terms, fits the square of "
    "q2, and row 0, times the terms and q2, fits q1; the last entry of row 1 is 0",
    found=_found,
    otherwise=_otherwise,
    sweeps=(Sweep("a nearly stretched arm", _nearly_stretched, _SMALL_BENDS),),
    special=_special,
    hints=(
        "np.linalg.lstsq(A, b)[0] returns the coefficients c for which A @ c comes closest to b.",
        "What is A and what is b for row 1? What does a query know when it computes the square of "
        "q2?",
        "For row 0, A has one column more than the terms, and the row has one coefficient more. "
        "Which column is that?",
    ),
    mistakes=(
        Mistake(
            "nan stands in the model", "The last entry of row 1 is 0.", nan=lambda terms, q: True
        ),
        Mistake(
            "the coefficient of q2 has no column",
            "How many numbers does each row hold, and what is the last one?",
            form=lambda array, terms, q: array.shape == (2, terms.shape[1]),
        ),
        Mistake(
            "q2 or |q2| is fitted, not the square of q2",
            "Which of the three is smooth at the edge of the workspace?",
            _fitted(target=np.positive),
            _fitted(target=np.abs),
        ),
        Mistake(
            "q1 is fitted without a term in q2",
            "Is q1 alone a smooth function of the position?",
            _with_row_0(lambda terms, q: [*_least_squares(terms, q[:, 0]), 0]),
        ),
        Mistake(
            "the square of q2 is fitted with a term in q2",
            "Which angle does a query not know yet when it computes the square of q2?",
            _square_by_q2,
        ),
        Mistake(
            "q1 is fitted with a term in |q2|, or in the square of q2, instead of q2",
            "The last entry of row 0 is a coefficient. Which quantity does it multiply?",
            _with_another_term(np.square),
            _with_another_term(np.abs),
        ),
        Mistake(
            "the coefficient of q2 is set to -1/2 and not fitted",
            "For which arm does -1/2 hold, and what does the task say about the coefficients?",
            _with_row_0(lambda terms, q: [*_least_squares(terms, q[:, 0] + q[:, 1] / 2), -0.5]),
        ),
        Mistake(
            "the terms are fitted first, and q2 is fitted to the residuals afterwards",
            "Do two fits, one after the other, reach the least sum of squares of one fit with all "
            "columns?",
            _with_row_0(_one_after_the_other),
        ),
    ),
)
