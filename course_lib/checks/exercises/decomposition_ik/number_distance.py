"""number_distance: find the bug. The cases of a distance are told apart by signs, and 0 has none."""

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property


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
    properties=(
        Property(
            "the distance between two numbers, neither of them 0, is as on a number line",
            _holds,
            where=lambda a, b: not _has_zero(a, b),
        ),
        Property("the distance of a number from 0 is its size", _holds, where=_has_zero),
    ),
    mistakes=(
        Mistake(
            "the difference is returned with its sign",
            "A distance is never negative: which of a and b is larger must not matter.",
            lambda a, b: a - b,
            lambda a, b: b - a,
        ),
        Mistake("the difference is squared", "A distance has the unit of a and b.", lambda a, b: (a - b) ** 2),
        Mistake("a and b are added", "The distance from 1 to 1 is 0.", lambda a, b: abs(a + b), lambda a, b: a + b),
        Mistake(
            "the sizes of a and b are compared, without their signs",
            "-2 and 3 lie on different sides of 0: they are 5 apart, not 1.",
            lambda a, b: abs(abs(a) - abs(b)),
        ),
        Mistake(
            "the sizes of a and b are added, whatever their signs",
            "3 and 1 lie on the same side of 0: they are 2 apart, not 4.",
            lambda a, b: abs(a) + abs(b),
        ),
        Mistake(
            "the distance from 0 is always 0",
            "Only 0 itself is at the distance 0 from 0. How far is 5?",
            lambda a, b: 0 if _has_zero(a, b) else right(a, b),
        ),
        Mistake(
            "one of the two numbers is returned if the other is 0, with its sign",
            "A distance is never negative: -4 is 4 away from 0.",
            lambda a, b: a + b if _has_zero(a, b) else right(a, b),
            lambda a, b: b if a == 0 else a if b == 0 else right(a, b),
        ),
    ),
    hints=(
        "Which pairs of numbers have the same sign, which have opposite signs, and which have neither?",
        "Call the broken function with 0 and 5. Which of its two cases applies?",
        "No case is needed: the distance is the size of the difference.",
    ),
    library=right,
    broken=_by_signs,
)
