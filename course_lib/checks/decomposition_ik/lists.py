"""Exercises whose one argument may be a list: the check works with arrays, and asks one case as a list at the end."""

from dataclasses import replace

import numpy as np

from course_lib.checks.exercise import Mistake

_A_LIST = Mistake(
    "the argument is taken for an array, and it may be a list",
    "Begin with q = np.asarray(q, float): that takes arrays and lists.",
)


def with_a_list(exercise, position):
    """Return the exercise, which asks its case at this position once more, as a list."""

    def cases(rng):
        asked = exercise.cases(rng)
        return [*asked, (asked[position][0].tolist(),)]

    def of_array(function):
        return function and (lambda value, q: function(value, np.asarray(q, float)))

    def of_argument(function):
        return function and (lambda q: function(np.asarray(q, float)))

    def mistake(known):
        if known is None:
            return None
        answers = map(of_argument, known.answers)
        return Mistake(
            known.name,
            known.hint,
            *answers,
            seen=of_array(known.seen),
            alike=known.alike,
            shadowed_by=known.shadowed_by,
        )

    properties = tuple(
        replace(
            each,
            holds=of_array(each.holds),
            seen=of_array(each.seen),
            where=of_argument(each.where),
            mistake=mistake(each.mistake),
        )
        for each in exercise.properties
    )
    errors = (
        *exercise.errors,
        ("TypeError", "list indices must be integers", _A_LIST),
        ("AttributeError", "'list' object has no attribute", _A_LIST),
        ("TypeError", "unsupported operand type(s) for", _A_LIST),
    )
    return replace(
        exercise,
        cases=cases,
        returns=of_array(exercise.returns),
        properties=properties,
        mistakes=tuple(map(mistake, exercise.mistakes)),
        errors=errors,
    )
