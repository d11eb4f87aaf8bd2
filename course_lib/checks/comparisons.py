"""Compare an answer with another, and call what may raise: what checks and mistakes stand on."""

import copy

import numpy as np

from course_lib.checks.tolerances import EXACT, PREDICTED
from course_lib.checks.wire import Seed, write


def same(value, predicted, *arguments, tolerance=PREDICTED):
    """Return whether two answers are equal within a tolerance, absolute and relative to the size of
    `predicted`.

    Complex numbers, and anything that is not numbers, are equal to nothing. The arguments of the
    case are not used; see `alike` of an Exercise.
    """
    try:
        if np.iscomplexobj(value):
            return False
        value, predicted = np.asarray(value, float), np.asarray(predicted, float)
    except (TypeError, ValueError, OverflowError):
        return False
    if value.shape != predicted.shape:
        return False
    if not np.isfinite(predicted).all():
        return np.allclose(value, predicted, rtol=tolerance, atol=tolerance, equal_nan=True)
    with np.errstate(invalid="ignore", over="ignore"):
        return bool((np.abs(value - predicted) <= tolerance + tolerance * np.abs(predicted)).all())


def difference(value, predicted, *arguments):
    """Return the largest difference of two answers; inf if their shapes differ or nan stands
    elsewhere.

    The arguments of the case are not used; see `distance` of an Exercise.
    """
    value, predicted = np.asarray(value, float), np.asarray(predicted, float)
    if value.shape != predicted.shape:
        return np.inf
    if not np.array_equal(np.isfinite(value), np.isfinite(predicted)):
        return np.inf
    return largest_gap(value, predicted)


def largest_gap(value, other):
    """Return the largest difference of two answers, in which nan and inf stand at the same
    entries."""
    return np.nan_to_num(np.abs(np.asarray(value, float) - other), posinf=0).max(initial=0)


def first_otherwise(values, cases):
    """Return the position of the first case that was asked before and answered otherwise, or
    None."""
    first = {}
    for k, case in enumerate(cases):
        # The same to the type: an answer that is wrong for whole numbers only keeps nothing.
        earlier = first.setdefault(write(list(case)), k)
        before, now = values[earlier], values[k]
        if earlier != k and difference(now, before) > EXACT * max(1, largest_gap(before, 0)):
            return k
    return None


def attempt(formula, *arguments):
    """Return the value of a formula, or None if it raises: answers, and mistakes, may be numbers of
    any size."""
    try:
        return formula(*arguments)
    except Exception:
        return None


def predict(answer, case):
    """Return what a student with this mistake answers: None where the function raises, or does not
    apply."""
    return attempt(answer, *(_given(argument) for argument in case))


def _given(argument):
    return (
        np.random.default_rng(argument.number)
        if isinstance(argument, Seed)
        else copy.deepcopy(argument)
    )
