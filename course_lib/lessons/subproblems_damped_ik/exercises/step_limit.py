"""step_limit: find the bug.

The largest step size with which damped steps converge near the target.
"""

import numpy as np

from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.special_cases import SMALL_NUMBERS, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import near
from course_lib.lessons.subproblems_damped_ik.exercises.shared import single


def _by(limit):
    return lambda J, eps: limit(np.linalg.svd(J, compute_uv=False), eps)


_right = _by(lambda s, eps: 2 * (1 + eps / s[0] ** 2))


def _cases(rng):
    plain = [(np.diag([2.0, 1.0]), 1.0), (np.array([[0.0, -1, -1, -1], [4, 3, 2, 1]]), 3.0)]
    return plain + [
        (rng.normal(size=shape), eps)
        for shape, eps in (
            ((2, 4), 2.0),
            ((2, 4), 50.0),
            ((3, 6), 0.01),
            ((2, 2), 0.5),  # the eigenvalues of a square J are not its singular values
            ((3, 3), 1.5),
        )
    ]


def _smaller(rng, size):
    """Return the case of an arm in smaller units, whose limit is the same however tiny eps is."""
    return size * rng.normal(size=(2, 4)), 0.5 * size**2


def _factor(limit, J, eps):
    s = np.linalg.svd(J, compute_uv=False)
    factors = 1 - limit * s**2 / (s**2 + eps)
    return (
        f"With alpha = {limit:.4g} a step multiplies the errors along the singular directions by "
        f"{factors.round(3)}."
    )


EXERCISE = Exercise(
    name="step_limit",
    points=1,
    arguments=("J", "eps"),
    tolerance=EXACT,
    cases=_cases,
    small=("J",),
    sweeps=(
        Sweep("little damping", lambda rng, eps: (rng.normal(size=(2, 4)), eps), SMALL_NUMBERS),
        Sweep("an arm in smaller units", _smaller, SMALL_NUMBERS),
    ),
    returns=lambda value, *case: single(value, "one number"),
    library=_right,
    broken=_by(lambda s, eps: 2 * (1 + eps / s[-1] ** 2)),
    properties=(
        Property(
            "at the limit the smallest factor is -1, and no factor is below it",
            lambda limit, *case: near(limit, _right(*case)),
            _factor,
            mistake=Mistake(
                "the smallest factor is not -1 at your limit",
                "How does the factor of a direction depend on alpha and on eps, and in which "
                "direction does it reach -1 first?",
            ),
        ),
    ),
    hints=(
        (
            "Take J = diag(2, 1) and eps = 1, and compute the factor of a step in both directions"
            " at the returned limit."
        ),
        (
            "The factor has to lie between -1 and 1 in every direction: the strictest direction "
            "decides."
        ),
        (
            "numpy sorts singular values from the largest to the smallest: the largest one is"
            " number 0."
        ),
    ),
)


@EXERCISE.mistake(
    "one direction decides, and not the strictest one",
    "The factor must stay above -1 in every direction: in which direction does it reach -1 first?",
    square=(
        lambda s: s[-2] ** 2,
        lambda s: s[1] ** 2,
    ),
)
def another_singular_value(J, eps, square):
    return _by(lambda s, eps: 2 * (1 + eps / square(s)))(J, eps)


@EXERCISE.mistake(
    "the singular values are combined: in a norm, a mean or a product",
    "Each direction has a factor of its own. At which alpha does the first of them reach -1?",
    square=(lambda s: np.mean(s) ** 2, np.prod, lambda s: np.sum(s**2), lambda s: np.mean(s**2)),
)
def all_directions_together(J, eps, square):
    return _by(lambda s, eps: 2 * (1 + eps / square(s)))(J, eps)


@EXERCISE.mistake(
    "s or eps stands in a wrong power",
    "Compare with the factor of a step, and ask whether you have s or its square: what are the "
    "eigenvalues of J J^T?",
    share=(
        lambda s, eps: eps / s[0],
        lambda s, eps: (eps / s[0]) ** 2,
        lambda s, eps: eps / s[0] ** 4,
    ),
)
def power_wrong(J, eps, share):
    return _by(lambda s, eps: 2 * (1 + share(s, eps)))(J, eps)


@EXERCISE.mistake(
    "the limit without damping is returned",
    "eps makes each step shorter: what does this mean for alpha?",
    limit=(lambda s, eps: 2.0, lambda s, eps: 2 / s[0] ** 2),
)
def without_damping(J, eps, limit):
    return _by(limit)(J, eps)
