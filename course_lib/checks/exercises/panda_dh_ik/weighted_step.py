"""weighted_step: a damped step in which each row of the error has a weight, such as for metres and radians."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.panda_dh_ik.ik_step_dls import panda_step, step_of
from course_lib.checks.vocabulary import away_from_zero, few_digits, wrong_steps

_ROOT = "A row r e_i adds (r e_i)^2 to the sum of squares. Which r makes that w_i e_i^2?"
_BOTH = "The residual is e - J delta: each of its rows has one factor, which multiplies the row of J and that of e."


def right(q, J, e, eps, weights):
    """Return the right answer: the damped step of the weighted rows."""
    roots = np.sqrt(weights)
    return step_of(q, roots[:, None] * J, roots * e, eps)


def _scaled(rows, error):
    """Return an answer: J multiplied by rows(weights), e by error(weights)."""
    return lambda q, J, e, eps, weights: step_of(q, rows(weights)[:, None] * J, error(weights) * e, eps)


def _with(weights_of):
    return lambda q, J, e, eps, weights: right(q, J, e, eps, weights_of(weights))


def _cases(rng):
    flat = np.array([[1.0, 0, 0], [0, 1, 0]])
    cases = [(np.zeros(3), flat, np.array([1.0, 2]), 1.0, np.array([1.0, 3]))]
    for m, n in ((2, 4), (3, 3), (3, 2)):
        drawn = away_from_zero(rng, n), away_from_zero(rng, (m, n)), away_from_zero(rng, m)
        cases.append((*drawn, 0.3, np.round(rng.uniform(0.2, 4, m), 2)))
    for unit, eps in ((0.1, 0.05), (10.0, 0.01)):
        cases.append((*panda_step(rng), eps, np.array([1 / unit**2] * 3 + [1.0] * 3)))
    q, J, e = panda_step(rng)
    return [*cases, (q, J, e, 0.02, np.array([1.0, 1, 1, 0, 0, 0])), (q, J, e, 0.02, np.ones(6))]


def _close(answer, q, *rest):
    return np.abs(answer - right(q, *rest)).max() < 1e-8 * (1 + np.abs(answer).max())


EXERCISE = Exercise(
    name="weighted_step",
    points=1,
    arguments=("q", "J", "e", "eps", "weights"),
    cases=_cases,
    returns=numbers(lambda q, *rest: (len(q),)),
    properties=(
        Property(
            "a part of the error whose weight is 0 changes nothing",
            _close,
            where=lambda *case: not case[-1].all(),
        ),
        Property(
            "with all weights 1 the answer is that of ik_step_dls",
            _close,
            where=lambda *case: (case[-1] == 1).all(),
        ),
        Property("the step minimizes the sum of w_i (e - J delta)_i^2, plus eps |delta|^2", _close),
    ),
    mistakes=(
        few_digits(right),
        Mistake("the weights come in as their squares", _ROOT, _scaled(np.copy, np.copy)),
        Mistake(
            "only one of J and e is weighted",
            _BOTH,
            *(_scaled(*pair) for f in (np.copy, np.sqrt) for pair in ((f, np.ones_like), (np.ones_like, f))),
        ),
        Mistake("J and e are weighted differently", _BOTH, _scaled(np.copy, np.sqrt), _scaled(np.sqrt, np.copy)),
        Mistake("the weights are not used", _ROOT, _with(np.ones_like)),
        Mistake(
            "the rows are divided by the weights, or by their roots",
            "A larger weight makes a part of the error count more.",
            *(lambda *case, k=k: right(*case[:-1], case[-1] ** k) if case[-1].all() else None for k in (-1.0, -2.0)),
        ),
        Mistake(
            "the weights are scaled to the sum 1",
            "Only the ratio of the weights to eps counts: take them as they are given.",
            _with(lambda w: w / w.sum()),
        ),
        *wrong_steps(right),
    ),
    hints=(
        "A sum of weighted squares is a plain sum of squares of other numbers: multiply each row by a factor.",
        "w_i (e_i - J_i delta)^2 is the square of r_i e_i - r_i J_i delta, with r_i the square root of w_i.",
        "r = np.sqrt(weights); then ik_step_dls(q, r[:, None] * J, r * e, eps).",
    ),
    library=right,
)
