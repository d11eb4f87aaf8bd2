"""subproblem4: the rotations about an axis that bring a point to a given height along a
direction."""

import numpy as np

from course_lib.checks.answer_types import rows
from course_lib.checks.exercise import Exercise
from course_lib.checks.mistake import Question
from course_lib.checks.special_cases import JUST_WITHIN, OUT_OF_REACH, SMALL_NUMBERS, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import X, Y, Z, distance_of_lists, same_list, unit
from course_lib.lessons.subproblems_damped_ik.exercises import shared
from course_lib.lessons.subproblems_damped_ik.exercises.shared import (
    across,
    angle_about,
    off_axis,
    rotated,
    two,
)
from course_lib.subproblems import subproblem4


def _asking(k, h, p, aside=0.8):
    """The problem with the height at which p is rotated `aside` beyond the direction of h."""
    return k, h, p, float(_height_after(k, h, p, angle_about(k, p, h) + aside))


def _reachable(rng, aside, middle, size, axis=None):
    """A direction h, a point p, and the height at which p is rotated `aside` beyond h."""
    k = unit(rng) if axis is None else axis
    h, p = size * off_axis(k, rng), off_axis(k, rng)
    h = rotated(k, angle_about(k, h, p) + middle, h)
    return _asking(k, h, p, aside)


def _cases(rng):
    tilted = (Z, np.array([0.6, 0, 0.8]), np.array([0.0, 2, -1]), -0.2)
    named = [
        (Z, X, X, 0.5),
        (Z, X, X, 0.5 + 1e-7),  # nearly the same, and answered anew
        (Z, X, Y, 0.0),
        (Z, Y, 2 * X, -1.0),
        (Z, X, 2 * X + Z, 1.0),
        tilted,
        *((Z, h, X, 1.0) for h in shared.by_quarters(Z, 2 * X)),
    ]
    generic = shared.in_general_position(rng, _reachable)
    k, h, p, _ = generic[0]
    low, high = _range(k, h, p)
    close = [(k, h, p, high - 1e-6 * (high - low))]  # where the two solutions are 0.004 apart
    beyond = [(k, h, p, high + 0.1 * (high - low)), (k, h, p, low - 0.1 * (high - low))]
    none = [(Z, X, X, 1.5), (Z, X, X, -1.5), (Z, X, X + 2 * Z, 1.5), *beyond]
    coinciding = [(Z, X, Y, 1.0), (Z, X + Z, Y + Z, 0.0)]
    return named + generic + close + none + coinciding + _whole_points(rng)


def _whole_points(rng):
    """Points in whole numbers about an axis that is not: the parts across it are not whole."""
    k = np.array([0.6, 0.0, 0.8])
    h, p = np.array([1, 2, -1]), np.array([2, -1, 1])
    return [(k, h, p, float(h @ rotated(k, rng.uniform(0.5, 2.5), p)))]


def _height_after(k, h, p, angle):
    return h @ rotated(k, angle, p)


def _special(rng):
    return shared.asking_on_the_grid(
        rng, _height_after, _range, lambda unit_of_length: unit_of_length**2 * np.arange(-4, 5)
    )


def _small(rng, size):
    """An axis with small entries, and two solutions one of which is small."""
    return _reachable(rng, 0.8, 0.8 + 0.7 * size, 1, axis=shared.nearly_along(Z, rng, size))


def _nearly_level(rng, size):
    """A point whose height along the axis is nearly 0."""
    k, h, p, _ = _reachable(rng, 0.8, 1.1, 1)
    p = shared.at_height(k, p, size)
    return _asking(k, h, p)


def _beyond(side):
    """Heights just above the highest, or below the lowest, that p comes to."""

    def case(rng, beyond):
        k = unit(rng)
        h, p = off_axis(k, rng), off_axis(k, rng)
        low, high = _range(k, h, p)
        middle, half = (low + high) / 2, (high - low) / 2
        return k, h, p, float(middle + side * (1 + beyond) * half)

    return Sweep("a height just out of reach", case, OUT_OF_REACH)


def _beyond_near_the_axis(side):
    """The same for a point near the axis, where the range is narrow."""

    def case(rng, distance):
        k = unit(rng)
        h, p = off_axis(k, rng), off_axis(k, rng)
        p = (k @ p) * k + distance * across(k, p)
        low, high = _range(k, h, p)
        return k, h, p, float((low + high) / 2 + side * (1 + 1e-3) * (high - low) / 2)

    return Sweep("a height just out of a narrow range", case, shared.NEAR_THE_AXIS)


def _within(side):
    """Heights just below the highest, or above the lowest, which two nearly equal angles reach."""

    return Sweep(
        "a height just within reach", lambda rng, gap: _beyond(side).case(rng, -gap), JUST_WITHIN
    )


def _range(k, h, p):
    """The smallest and the largest height that p comes to."""
    return shared.extremes(lambda point: h @ point, k, p, h)


_solutions = shared.exact_solutions(subproblem4)


def _misses(theta, k, h, p, d):
    return abs(h @ rotated(k, theta, p) - d) / np.linalg.norm(h) / np.linalg.norm(p)


def _tell(theta, k, h, p, d):
    return shared.reached(theta, "height", h @ rotated(k, theta, p), d)


def _nothing_there(found, k, h, p, d):
    low, high = _range(k, h, p)
    return f"h . R(k, theta) p goes from {low:.8g} to {high:.8g}; d is {d:.8g}."


EXERCISE = Exercise(
    name="subproblem4",
    points=2,
    arguments=("k", "h", "p", "d"),
    free=("k", "h", "p", "d"),
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
        _beyond_near_the_axis(1),
        _beyond_near_the_axis(-1),
        Sweep("an axis with small entries, and a small angle", _small, SMALL_NUMBERS),
        Sweep("a point nearly at height 0", _nearly_level, SMALL_NUMBERS),
        *shared.one_near(_asking),
        shared.of_all_lengths(lambda rng: _reachable(rng, 0.8, 1.1, 1), 0, 1, 1, 2),
        shared.of_all_lengths(lambda rng: _nearly_level(rng, 3e-4), 0, 1, 1, 2),
        shared.of_all_lengths(lambda rng: _beyond(1).case(rng, 1e-3), 0, 1, 1, 2),
    ),
    properties=shared.all_of_them(
        "each theta brings p to the height d along h: h . R(k, theta) p = d",
        "angle",
        _misses,
        _tell,
        _solutions,
        none=(
            shared.empty_list(
                "the list is empty if p never comes to the height d",
                _nothing_there,
                where=lambda *case: not _solutions(*case),
                otherwise=Question(
                    "an angle is returned although no angle is right",
                    "How far can the height swing, and what does your code do with a d beyond "
                    "that? Clipping a number hides that it is out of range.",
                ),
            ),
        ),
    ),
    hints=(
        (
            "The text writes h . R p as a constant, A cos(theta) and B sin(theta). Compute the "
            "constant, A and B first."
        ),
        "Then r and phi from A and B. If |d - constant| > r there is no solution: an empty list.",
        (
            "phi is np.arctan2(B, A). The two solutions lie on either side of phi, both at the same"
            " distance from it."
        ),
        "theta = phi plus or minus arccos((d - constant) / r), with r = np.hypot(A, B).",
    ),
    forbidden=("course_lib.subproblems.subproblem4",),
)

shared.add_too_few(EXERCISE, _solutions, _misses)


def _either_side(case, e, A=None):
    """The two angles of a student with another e or A; a cosine out of range is replaced by the
    nearest in range."""
    two(_solutions, *case)
    k, h, p, _ = case
    A, B = across(k, h) @ p if A is None else A, h @ np.cross(k, p)
    middle, aside = np.arctan2(B, A), np.arccos(np.clip(e / np.hypot(A, B), -1, 1))
    return [middle - aside, middle + aside]


@EXERCISE.mistake(
    "the constant part of the height is not subtracted where it should be, or is another one",
    "Which part of h . R p does not depend on theta? Is that part in d, and is it in h . p?",
    of_d=(lambda x, y: 0, lambda x, y: -x * y, lambda x, y: x, lambda x, y: y),
    of_A=(True, False),
)
def constant_wrong(k, h, p, d, of_d, of_A):
    e = d - of_d(k @ h, k @ p)
    return _either_side((k, h, p, d), e) if of_A else _either_side((k, h, p, d), e, A=h @ p)


@EXERCISE.mistake(
    "the constant is not taken out of A",
    "Which part of h . p does not change with theta?",
)
def constant_in_A(k, h, p, d):
    return _either_side((k, h, p, d), d - (k @ h) * (k @ p), A=h @ p)


shared.add_swings(EXERCISE, _solutions, lambda k, h, p, d: (k, p, h))
