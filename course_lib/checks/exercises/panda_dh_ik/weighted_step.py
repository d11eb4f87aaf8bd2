"""weighted_step: a damped step in which each row of the error has a weight, such as for metres and radians."""

import itertools

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.exercises.panda_dh_ik.shared import FLAT, add_mistakes_of_a_step, damped, panda_step
from course_lib.checks.vocabulary import away_from_zero


def right(q, J, e, eps, weights):
    """Return the right answer: the damped step of the weighted rows."""
    roots = np.sqrt(weights)
    return damped(q, roots[:, None] * J, roots * e, eps)


def _cases(rng):
    cases = [(np.zeros(3), FLAT, np.array([1.0, 2]), 1.0, np.array([1.0, 3]))]
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
    hints=(
        "A sum of weighted squares is a plain sum of squares of other numbers: multiply each row by a factor.",
        "w_i (e_i - J_i delta)^2 is the square of r_i e_i - r_i J_i delta, with r_i the square root of w_i.",
        "r = np.sqrt(weights); then ik_step_dls(q, r[:, None] * J, r * e, eps).",
    ),
    library=right,
)
add_mistakes_of_a_step(EXERCISE)


@EXERCISE.mistake
def squared_weights(q, J, e, eps, weights):
    """the weights come in as their squares. A row r e_i adds (r e_i)^2 to the sum: which r makes that w_i e_i^2?"""
    return damped(q, weights[:, None] * J, weights * e, eps)


@EXERCISE.mistake(pair=itertools.permutations((np.ones_like, np.sqrt, np.copy), 2))
def weighted_differently(q, J, e, eps, weights, pair):
    """J and e are not weighted alike. The residual is e - J delta: what multiplies each of its rows?"""
    return damped(q, pair[0](weights)[:, None] * J, pair[1](weights) * e, eps)


@EXERCISE.mistake
def weights_unused(q, J, e, eps, weights):
    """the weights are not used. By which factor does a row of J and e count more?"""
    return damped(q, J, e, eps)


@EXERCISE.mistake(power=(-1, -2))
def divided(*case, power):
    """the rows are divided by the weights, or by their roots. Should a larger weight make an error count more?"""
    return right(*case[:-1], case[-1] ** power) if case[-1].all() else None
