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
    return [(np.array([0.1, 0.2]), np.array([0.01, 0.04])), (halves, 3 * halves), *drawn]


def _close(slope, sizes, errors):
    return abs(float(slope) - right(sizes, errors)) < 1e-6


def _exact(sizes, errors):
    fitted = np.polyfit(np.log(sizes), np.log(errors), 1)
    return np.allclose(np.polyval(fitted, np.log(sizes)), np.log(errors), atol=1e-9)


_BOTH = Mistake("both numbers of the fit are returned", "Which of the two numbers of np.polyfit is the slope?")

EXERCISE = Exercise(
    name="convergence_slope",
    points=1,
    arguments=("sizes", "errors"),
    cases=_cases,
    returns=numbers(lambda sizes, errors: (), {(2,): _BOTH}),
    library=right,
    properties=(
        Property("errors that are c h^p have the slope p", _close, where=_exact),
        Property("the slope is that of the least-squares line through all points (log h, log error)", _close),
    ),
    hints=(
        "If error = c h^p, then log(error) = log(c) + p log(h): a straight line.",
        "np.polyfit(x, y, 1) returns the slope and the constant of the least-squares line.",
        "x is np.log(sizes), y is np.log(errors), and the slope is the first of the two numbers.",
    ),
)


@EXERCISE.mistake(of=((np.positive, np.positive), (np.log, np.positive), (np.positive, np.log)))
def no_logarithm(h, e, of):
    """a logarithm is missing, or both. On which axes is a power law a straight line?"""
    return np.polyfit(of[0](h), of[1](e), 1)[0]


@EXERCISE.mistake(factor=[1 / np.log(2), np.log(2), 1 / np.log(10), np.log(10), np.log2(10), np.log10(2)])
def two_bases(h, e, factor):
    """the two logarithms have different bases. What does a change of base do to each axis?"""
    return right(h, e) * factor


@EXERCISE.mistake
def correlation(h, e):
    """the correlation is returned. Does it say how steep a line is, or how well it fits?"""
    return np.corrcoef(np.log(h), np.log(e))[0, 1]


@EXERCISE.mistake
def constant_term(h, e):
    """the constant term of the line is returned. In which order does np.polyfit return the coefficients?"""
    return np.polyfit(np.log(h), np.log(e), 1)[1]


@EXERCISE.mistake(
    slope=(
        lambda x, y: (y[-1] - y[0]) / (x[-1] - x[0]),
        lambda x, y: (y[1] - y[0]) / (x[1] - x[0]),
        lambda x, y: (y[-1] - y[-2]) / (x[-1] - x[-2]),
        lambda x, y: np.mean(np.diff(y) / np.diff(x)),
        lambda x, y: (x @ y) / (x @ x),
        lambda x, y: np.mean(y / x),
    )
)
def another_line(h, e, slope):
    """this is not the line of least squares. Do all points count alike, and may the line pass beside the origin?"""
    return slope(np.log(h), np.log(e))
