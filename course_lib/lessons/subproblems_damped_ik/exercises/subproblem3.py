"""subproblem3: the rotations about an axis that bring one point to a given distance from another.

Two angles that coincide may be in the list once, twice or not at all, so its properties put each
angle into the equation.
"""

import numpy as np

from course_lib.checks.answer_types import rows
from course_lib.checks.exercise import Exercise
from course_lib.checks.mistake import Question
from course_lib.checks.special_cases import JUST_WITHIN, OUT_OF_REACH, SMALL_NUMBERS, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import X, Y, Z, distance_of_lists, same_list, unit
from course_lib.lessons.subproblems_damped_ik.exercises import shared
from course_lib.lessons.subproblems_damped_ik.exercises.shared import (
    angle_about,
    off_axis,
    rotated,
    two,
)
from course_lib.subproblems import subproblem3, subproblem4


def _asking(k, p, g, aside=0.8):
    """The problem with the distance at which p is rotated `aside` beyond the direction of g."""
    return k, p, g, float(_distance_after(k, p, g, angle_about(k, p, g) + aside))


def _reachable(rng, aside, middle, size, axis=None):
    """p and g about an axis, and a distance at which p is rotated `aside` beyond the direction of
    g."""
    k = unit(rng) if axis is None else axis
    p, g = size * off_axis(k, rng), size * off_axis(k, rng)
    g = rotated(k, angle_about(k, g, p) + middle, g)
    g = g if (k @ p) * (k @ g) < 0 else g - 2 * (k @ g) * k  # their heights on both sides of 0
    return _asking(k, p, g, aside)


def _cases(rng):
    named = [
        (Z, X, X, np.sqrt(2.0)),
        (Z, X, 2 * Y, np.sqrt(3.0)),
        (Z, X, 2 * Y, np.sqrt(3.0) + 1e-7),  # nearly the same, and answered anew
        (Z, 2 * X + Z, 2 * Y + 3 * Z, np.sqrt(8.0)),
        *((Z, X, g, 2.5) for g in shared.by_quarters(Z, 2 * X)),
    ]
    generic = shared.in_general_position(rng, _reachable)
    k, p, g, d = generic[1]
    far, close = _reach(k, p, g)
    none = [
        (Z, X, 2 * Y, 4.0),
        (Z, X, 3 * Y, 1.0),
        (Z, X, Y + 2 * Z, 1.5),
        (k, p, g, 1.1 * far),
        (k, p, g, 0.9 * close),
    ]
    negative = [(Z, X, X, -1.0), (k, p, g, -d)]
    coinciding = [(Z, X, 3 * Y, 2.0), (Z, 3 * X + Z, Y + Z, 4.0)]
    return named + generic + none + negative + coinciding + _whole_points(rng)


def _whole_points(rng):
    """Points in whole numbers, about an axis that makes their parts across it not whole, and about
    a whole one."""
    k = np.array([0.6, 0.0, 0.8])
    p, g = np.array([1, 2, -1]), np.array([2, -1, 1])
    drawn = float(np.linalg.norm(rotated(k, rng.uniform(0.5, 2.5), p) - g))
    # Both are 3 long, and the angles are not whole.
    z, up, down = np.array([0, 0, 1]), np.array([2, 1, 2]), np.array([1, 2, -2])
    return [(k, p, g, drawn), *((z, up, down, d) for d in (5, 5.0, 4.5))]


def _distance_after(k, p, g, angle):
    return np.linalg.norm(rotated(k, angle, p) - g)


def _special(rng):
    return shared.asking_on_the_grid(
        rng, _distance_after, _reach, lambda unit_of_length: unit_of_length * np.arange(5)
    )


# Without their signs, in metres: all of them clearly above 1e-8, to which somebody may compare
# distances.
_NEGATIVE = (0.1, *(0.9 * size for size in SMALL_NUMBERS[:5]))


def _negative(rng, size):
    """A negative distance, however near to 0, between points on one circle."""
    k = unit(rng)
    p = off_axis(k, rng)
    return k, p, rotated(k, rng.uniform(0.5, 2.5), p), -size


def _small(rng, size):
    """An axis with small entries, and two solutions one of which is small."""
    return _reachable(rng, 0.8, 0.8 + 0.7 * size, 1, axis=shared.nearly_along(Z, rng, size))


def _nearly_level(rng, size):
    """Points whose heights along the axis are nearly the same."""
    k, p, g, _ = _reachable(rng, 0.8, 1.1, 1)
    g = shared.at_height(k, g, k @ p + size)
    return _asking(k, p, g)


def _beyond(side):
    """Distances just below the smallest, or just above the largest, that p comes to."""

    def case(rng, beyond):
        k = unit(rng)
        p, g = off_axis(k, rng), off_axis(k, rng)
        height = (k @ p) * (k @ g)
        radii = np.linalg.norm(p - (k @ p) * k) * np.linalg.norm(g - (k @ g) * k)
        square = p @ p + g @ g - 2 * (height + side * (1 + beyond) * radii)
        return (k, p, g, float(np.sqrt(square))) if square > 0 else None

    return Sweep("a distance just out of reach", case, OUT_OF_REACH)


def _within(side):
    """Distances just above the smallest, or below the largest, which two nearly equal angles
    give."""
    return Sweep(
        "a distance just within reach", lambda rng, gap: _beyond(side).case(rng, -gap), JUST_WITHIN
    )


def _reach(k, p, g):
    """The largest and the smallest distance from g that p comes to."""
    return shared.extremes(lambda point: np.linalg.norm(point - g), k, p, g)


_solutions = shared.exact_solutions(subproblem3, applies=lambda k, p, g, d: d >= 0)


def _misses(theta, k, p, g, d):
    return abs(np.linalg.norm(rotated(k, theta, p) - g) - d) / max(
        np.linalg.norm(p), np.linalg.norm(g)
    )


def _tell(theta, k, p, g, d):
    return shared.reached(theta, "distance", np.linalg.norm(rotated(k, theta, p) - g), d)


def _nothing_there(found, k, p, g, d):
    far, close = _reach(k, p, g)
    return (
        f"R(k, theta) p comes as near to g as {close:.8g} and goes as far as {far:.8g}; d is "
        f"{d:.8g}."
    )


EXERCISE = Exercise(
    name="subproblem3",
    points=2,
    arguments=("k", "p", "g", "d"),
    free=("k", "p", "g", "d"),
    tolerance=EXACT,
    cases=_cases,
    returns=rows(1, "a list of angles, empty if there is none"),
    library=_solutions,
    alike=same_list,
    distance=distance_of_lists,
    special=_special,
    sweeps=(
        _beyond(1),
        _beyond(-1),
        _within(1),
        _within(-1),
        Sweep("a negative distance, nearly 0", _negative, _NEGATIVE),
        Sweep("an axis with small entries, and a small angle", _small, SMALL_NUMBERS),
        Sweep("points nearly at one height", _nearly_level, SMALL_NUMBERS),
        shared.of_all_lengths(lambda rng: _reachable(rng, 0.8, 1.1, 1), 0, 1, 1, 1),
        shared.of_all_lengths(lambda rng: _nearly_level(rng, 3e-4), 0, 1, 1, 1),
        *shared.one_near(_asking),
    ),
    properties=shared.all_of_them(
        "each theta brings p to the distance d from g: |R(k, theta) p - g| = d",
        "angle",
        _misses,
        _tell,
        _solutions,
        none=(
            shared.empty_list(
                "the list is empty if d is negative, because no distance is negative",
                None,
                where=lambda k, p, g, d: d < 0,
                otherwise=Question(
                    "a negative d is squared, and its sign lost",
                    "Which points are at a distance of -1? What does your code do with the sign "
                    "of d?",
                ),
            ),
            shared.empty_list(
                "the list is empty if d is too large or too small",
                _nothing_there,
                where=lambda *case: not _solutions(*case),
                otherwise=Question(
                    "an angle is returned although no angle is right",
                    "How near and how far does p come, and what does your code do with a d beyond "
                    "that? Clipping a number hides that it is out of range.",
                ),
            ),
        ),
    ),
    hints=(
        "Square both sides of |R p - g| = d. Which terms depend on theta?",
        "Only g . R p does: it must be a certain height of R p along g. Squaring loses the sign of "
        "d: look at d first.",
        "That is subproblem 4 with h = g and the height (|p|^2 + |g|^2 - d^2) / 2.",
    ),
    forbidden=("course_lib.subproblems.subproblem3",),
)

shared.add_too_few(EXERCISE, _solutions, _misses)


@EXERCISE.mistake(
    "the height that p should have along g is wrong",
    "Square |R p - g| = d, multiply it out, and solve for g . R p: which lengths are squared, and "
    "what about the factor and the signs?",
    height=(
        lambda p, g, d: (d * d - p * p - g * g) / 2,
        lambda p, g, d: p * p + g * g - d * d,
        lambda p, g, d: d,
        lambda p, g, d: (p * p + g * g - d) / 2,
    ),
)
def height_wrong(k, p, g, d, height):
    two(_solutions, k, p, g, d)
    found = subproblem4(k, g, p, height(np.linalg.norm(p), np.linalg.norm(g), d))
    return list(found.theta) if found.exact else None
