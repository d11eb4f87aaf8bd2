"""convergence_slope: the power of the cell size with which an error falls."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property


def right(sizes, errors):
    """Return the slope of the least-squares line through (log sizes, log errors)."""
    return np.polyfit(np.log(sizes), np.log(errors), 1)[0]


def _cases(rng):
    drawn = []
    for power in (0.5, 3.0):
        sizes = np.sort(rng.uniform(0.01, 0.5, 6))
        drawn.append((sizes, rng.uniform(0.2, 5) * sizes**power * rng.uniform(0.7, 1.4, 6)))
    halves = 0.2 / 2.0 ** np.arange(5)
    return [
        (np.array([0.1, 0.2]), np.array([0.01, 0.04])),
        (halves, 3 * halves),
        *drawn,
    ]


def _close(slope, sizes, errors):
    return abs(float(slope) - right(sizes, errors)) < 1e-6


def _exact(sizes, errors):
    fitted = np.polyfit(np.log(sizes), np.log(errors), 1)
    return np.allclose(np.polyval(fitted, np.log(sizes)), np.log(errors), atol=1e-9)


_BOTH = Mistake("both numbers of the fit are returned", "np.polyfit returns the slope first, then the constant term.")

EXERCISE = Exercise(
    name="convergence_slope",
    points=1,
    arguments=("sizes", "errors"),
    cases=_cases,
    returns=numbers(lambda sizes, errors: (), {(2,): _BOTH}),
    properties=(
        Property("errors that are c h^p have the slope p", _close, where=_exact),
        Property("the slope is that of the least-squares line through all points (log h, log error)", _close),
    ),
    mistakes=(
        Mistake("the sign is wrong", "The error falls with h: the slope is positive.", lambda h, e: -right(h, e)),
        Mistake(
            "no logarithm is taken",
            "A power law is a straight line only if both axes are logarithmic.",
            lambda h, e: np.polyfit(h, e, 1)[0],
        ),
        Mistake(
            "the logarithm of one of the two is missing",
            "Both axes are logarithmic.",
            lambda h, e: np.polyfit(h, np.log(e), 1)[0],
            lambda h, e: np.polyfit(np.log(h), e, 1)[0],
        ),
        Mistake(
            "the two logarithms have different bases",
            "Take the same logarithm, any one, of both.",
            *(
                lambda h, e, base=base: right(h, e) * base
                for base in (np.log(2), np.log(10), np.log2(10), *(1 / np.log([2, 10])), np.log10(2))
            ),
        ),
        Mistake(
            "the line is forced through the origin",
            "log c is the constant term of the line: fit it too.",
            lambda h, e: (np.log(h) @ np.log(e)) / (np.log(h) @ np.log(h)),
            lambda h, e: np.mean(np.log(e) / np.log(h)),
        ),
        Mistake(
            "the correlation is returned",
            "It says how well a line fits, not how steep it is.",
            lambda h, e: np.corrcoef(np.log(h), np.log(e))[0, 1],
        ),
        Mistake(
            "h and the error are swapped", "The error is over h.", lambda h, e: np.polyfit(np.log(e), np.log(h), 1)[0]
        ),
        Mistake(
            "the constant term of the line is returned",
            "np.polyfit returns the highest power first.",
            lambda h, e: np.polyfit(np.log(h), np.log(e), 1)[1],
        ),
        Mistake(
            "only two of the points are used",
            "One bad point must not decide: fit a line through all.",
            lambda h, e: np.log(e[0] / e[-1]) / np.log(h[0] / h[-1]),
            lambda h, e: np.log(e[0] / e[1]) / np.log(h[0] / h[1]),
            lambda h, e: np.log(e[-2] / e[-1]) / np.log(h[-2] / h[-1]),
        ),
        Mistake(
            "the mean of the slopes between neighbours is returned",
            "Fit one line through all points.",
            lambda h, e: np.mean(np.diff(np.log(e)) / np.diff(np.log(h))),
        ),
    ),
    hints=(
        "If error = c h^p, then log(error) = log(c) + p log(h): a straight line.",
        "np.polyfit(x, y, 1) returns the slope and the constant of the least-squares line.",
        "x is np.log(sizes), y is np.log(errors), and the slope is the first of the two numbers.",
    ),
    library=right,
)
