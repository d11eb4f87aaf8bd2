"""number_distance: find the bug. The cases of a distance are distinguished by signs, and 0 has none."""

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Property


def right(a, b):
    """Return the distance between two numbers."""
    return abs(a - b)


def _by_signs(a, b):
    """The broken function: it has no case for a zero, and returns None."""
    if a * b > 0:
        return abs(abs(a) - abs(b))
    if a * b < 0:
        return abs(a) + abs(b)
    return None


def _has_zero(a, b):
    return a * b == 0


def _holds(answer, a, b):
    return abs(float(answer) - right(a, b)) < 1e-9


def _cases(rng):
    named = [(3.0, -2.0), (1.0, 1.0), (0.0, 5.0), (5.0, 0.0), (0.0, -4.0), (-4.0, 0.0), (0.0, 0.0), (-1.5, -4.0)]
    sizes = rng.uniform(0.5, 9, (4, 2)).round(3)
    return named + [(float(a), float(b)) for a, b in sizes * [[1, 1], [-1, 1], [1, -1], [-1, -1]]]


EXERCISE = Exercise(
    name="number_distance",
    points=1,
    arguments=("a", "b"),
    cases=_cases,
    returns=numbers(lambda a, b: ()),
    library=right,
    broken=_by_signs,
    properties=(
        Property(
            "the distance between two numbers, neither of them 0, is as on a number line",
            _holds,
            where=lambda a, b: not _has_zero(a, b),
        ),
        Property("the distance of a number from 0 is its size", _holds, where=_has_zero),
    ),
    hints=(
        "Which pairs of numbers have the same sign, which have opposite signs, and which have neither?",
        "Call the broken function with 0 and 5. Which of its two cases applies?",
        "No case is needed: the distance is the size of the difference.",
    ),
)


@EXERCISE.mistake(sign=(1, -1))
def with_its_sign(a, b, sign):
    """the difference is returned with its sign. Can a distance be negative?"""
    return sign * (a - b)


@EXERCISE.mistake
def squared(a, b):
    """the difference is squared. Which unit has a distance between numbers of metres?"""
    return (a - b) ** 2


@EXERCISE.mistake(combined=(lambda a, b: abs(a - b), lambda a, b: a + b))
def without_signs(a, b, combined):
    """the signs of a and b are ignored. How far is -2 from 3 on a number line, and how far is 1 from 3?"""
    return combined(abs(a), abs(b))


@EXERCISE.mistake(answer=(lambda a, b: 0.0, lambda a, b: a + b))
def another_distance_from_zero(a, b, answer):
    """the distance from 0 is 0, or the other number with its sign. How far are 5, and -4, from 0?"""
    return answer(a, b) if _has_zero(a, b) else right(a, b)
