"""step_limit: find the bug. The largest step size with which damped steps converge near the target."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.vocabulary import doubled, few_digits, halved, near


def _by(limit):
    return lambda J, eps: limit(np.linalg.svd(J, compute_uv=False), eps)


right = _by(lambda s, eps: 2 * (1 + eps / s[0] ** 2))


def _cases(rng):
    plain = [(np.diag([2.0, 1.0]), 1.0), (np.array([[0.0, -1, -1, -1], [4, 3, 2, 1]]), 3.0)]
    return plain + [(rng.normal(size=shape), eps) for shape, eps in (((2, 4), 2.0), ((2, 4), 50.0), ((3, 6), 0.01))]


def _number(value, *case):
    """Return one number, which may stand in an array or list of one."""
    one = value if isinstance(value, np.ndarray) else value[0] if isinstance(value, list) and len(value) == 1 else value
    one = one.reshape(()) if isinstance(one, np.ndarray) and one.size == 1 else one
    return float(numbers(lambda *case: ())(one, *case))


def _factor(limit, J, eps):
    s = np.linalg.svd(J, compute_uv=False)
    factors = 1 - limit * s**2 / (s**2 + eps)
    return f"With alpha = {limit:.4g} a step multiplies the errors along the singular directions by {factors.round(3)}."


EXERCISE = Exercise(
    name="step_limit",
    points=1,
    arguments=("J", "eps"),
    cases=_cases,
    returns=_number,
    properties=(
        Property(
            "at the limit the largest factor is -1, and no factor is below it",
            lambda limit, *case: near(limit, right(*case)),
            _factor,
        ),
    ),
    mistakes=(
        few_digits(right),
        doubled(right),
        halved(right),
        Mistake(
            "another singular value than the largest decides",
            "The factor must stay above -1 in every direction. In which direction does it reach -1 first?",
            _by(lambda s, eps: 2 * (1 + eps / s[1] ** 2)),
            _by(lambda s, eps: 2 * (1 + eps / np.mean(s) ** 2)),
            _by(lambda s, eps: 2 * (1 + eps / np.prod(s))),
            _by(lambda s, eps: 2 * (1 + eps / np.sum(s**2))),
        ),
        Mistake(
            "s is not squared, or eps is",
            "Compare with the factor of a step: s^2 / (s^2 + eps).",
            _by(lambda s, eps: 2 * (1 + eps / s[0])),
            _by(lambda s, eps: 2 * (1 + eps / s[-1])),
            _by(lambda s, eps: 2 * (1 + (eps / s[0]) ** 2)),
        ),
        Mistake(
            "s is squared twice",
            "The eigenvalues of J J^T are the s^2 already.",
            _by(lambda s, eps: 2 * (1 + eps / s[0] ** 4)),
        ),
        Mistake(
            "eps and s are swapped",
            "A larger damping allows larger steps.",
            _by(lambda s, eps: 2 * (1 + s[0] ** 2 / eps)),
            _by(lambda s, eps: 2 / (1 + eps / s[0] ** 2)),
        ),
        Mistake(
            "the limit without damping is returned",
            "eps in the denominator makes each step shorter, and so allows a larger alpha.",
            lambda J, eps: 2.0,
            _by(lambda s, eps: 2 / s[0] ** 2),
        ),
    ),
    hints=(
        "Take J = diag(2, 1) and eps = 1, and compute the factor of a step in both directions at the returned limit.",
        "The factor has to lie between -1 and 1 in every direction: the strictest direction decides.",
        "numpy sorts singular values from the largest to the smallest: the largest one is number 0.",
    ),
    library=right,
    broken=_by(lambda s, eps: 2 * (1 + eps / s[-1] ** 2)),
)
