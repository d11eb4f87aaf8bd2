"""subproblem3: the rotations about an axis that bring one point to a given distance from another."""

import numpy as np

from course_lib.checks.answer_types import rows
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.subproblems_damped_ik.shared import (
    across,
    add_swings,
    add_too_few,
    all_of_them,
    angle_about,
    rotated,
    same_list,
    two,
    unless_empty,
)
from course_lib.checks.exercises.subproblems_damped_ik.subproblem1 import off_axis
from course_lib.checks.vocabulary import X, Y, Z, remembered, unit
from course_lib.subproblems import subproblem3, subproblem4


def _reachable(rng, aside, middle, size):
    """p and g about an axis, and a distance at which p is rotated `aside` beyond the direction of g."""
    k = unit(rng)
    p, g = size * off_axis(k, rng), size * off_axis(k, rng)
    g = rotated(k, angle_about(k, g, p) + middle, g)
    g = g if (k @ p) * (k @ g) < 0 else g - 2 * (k @ g) * k  # their heights on both sides of 0
    angle = angle_about(k, p, g) + aside
    return k, p, g, float(np.linalg.norm(rotated(k, angle, p) - g))


def _cases(rng):
    named = [(Z, X, X, np.sqrt(2.0)), (Z, X, 2 * Y, np.sqrt(3.0)), (Z, 2 * X + Z, 2 * Y + 3 * Z, np.sqrt(8.0))]
    generic = [
        _reachable(rng, rng.uniform(0.5, 1.0), rng.uniform(0.4, 1.2), 1),
        _reachable(rng, rng.uniform(2.0, 2.6), rng.uniform(-1.2, -0.4), 1),
        _reachable(rng, rng.uniform(1.2, 1.9), rng.uniform(1.9, 2.7), 0.2),
        _reachable(rng, rng.uniform(1.2, 1.9), rng.uniform(-2.7, -1.9), 30),
    ]
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
    return named + generic + none + negative + [(Z, X, 3 * Y, 2.0), (Z, 3 * X + Z, Y + Z, 4.0)]


def _reach(k, p, g):
    """The largest and the smallest distance from g that p comes to."""
    middle = angle_about(k, p, g)
    return [np.linalg.norm(rotated(k, middle + aside, p) - g) for aside in (np.pi, 0.0)]


@remembered
def _solutions(k, p, g, d):
    """All solutions as the exercise asks for them; none where there is only a nearest one."""
    answers = subproblem3(k, p, g, d)
    return list(answers.theta[: answers.count]) if answers.exact and d >= 0 else []


def _misses(theta, k, p, g, d):
    return abs(np.linalg.norm(rotated(k, theta, p) - g) - d) / max(np.linalg.norm(p), np.linalg.norm(g))


def _tell(theta, k, p, g, d):
    return f"With {theta:.6g} it is {round(np.linalg.norm(rotated(k, theta, p) - g), 9):.6g}; d is {d:.6g}."


def _is_empty(found, *case):
    return len(found) == 0


def _nothing_there(found, k, p, g, d):
    far, close = _reach(k, p, g)
    return f"R(k, theta) p comes as near to g as {close:.4g} and goes as far as {far:.4g}; d is {d:.4g}."


EXERCISE = Exercise(
    name="subproblem3",
    points=2,
    arguments=("k", "p", "g", "d"),
    cases=_cases,
    returns=unless_empty(rows(1, "a list of angles, empty if there is none"), _solutions),
    library=_solutions,
    alike=same_list,
    properties=all_of_them(
        "each theta brings p to the distance d from g: |R(k, theta) p - g| = d",
        "angle",
        _misses,
        _tell,
        _solutions,
        none=(
            Property(
                "the list is empty if d is negative, because no distance is negative",
                _is_empty,
                where=lambda k, p, g, d: d < 0,
                mistake=Mistake("a negative d is squared, and its sign lost", "Which points are at a distance of -1?"),
            ),
            Property(
                "the list is empty if d is too large or too small",
                _is_empty,
                _nothing_there,
                where=lambda *case: not _solutions(*case),
                mistake=Mistake(
                    "an angle is returned although no angle is right",
                    "How near and how far does p come? Clipping a number hides that it is out of range.",
                ),
            ),
        ),
    ),
    hints=(
        "Square both sides of |R p - g| = d. Which terms depend on theta?",
        "Only g . R p does: it must be a certain height of R p along g. Squaring loses the sign of d: look at d first.",
        "That is subproblem 4 with h = g and the height (|p|^2 + |g|^2 - d^2) / 2.",
    ),
    forbidden=("course_lib.subproblems.subproblem3",),
)

add_too_few(EXERCISE, _solutions, _misses)


@EXERCISE.mistake(
    height=(
        lambda p, g, d: (d * d - p * p - g * g) / 2,
        lambda p, g, d: p * p + g * g - d * d,
        lambda p, g, d: d,
        lambda p, g, d: (p * p + g * g - d) / 2,
        lambda p, g, d: (p + g - d * d) / 2,
        lambda p, g, d: (p + g - d) / 2,
    )
)
def height_wrong(k, p, g, d, height):
    """the height along g is wrong at which p should be. Square |R p - g| = d, multiply it out, and solve for g . R p:
    which lengths are squared, and what about the factor and the signs?"""
    two(_solutions, k, p, g, d)
    found = subproblem4(k, g, p, height(np.linalg.norm(p), np.linalg.norm(g), d))
    return list(found.theta) if found.exact else None


def _by_cosine(case, square, product=None):
    """The two angles of somebody with another d'^2, or another |p'| |g'|, in the law of cosines."""
    two(_solutions, *case)
    k, p, g, _ = case
    a, b = across(k, p), across(k, g)
    product = np.linalg.norm(a) * np.linalg.norm(b) if product is None else product
    aside = np.arccos(np.clip((a @ a + b @ b - square) / (2 * product), -1, 1))
    return [angle_about(k, p, g) - aside, angle_about(k, p, g) + aside]


@EXERCISE.mistake
def distance_not_reduced(k, p, g, d):
    """the heights along the axis are forgotten: d is not reduced. How long is the distance, seen along the axis?"""
    return _by_cosine((k, p, g, d), d * d)


@EXERCISE.mistake(
    square=(
        lambda d, x, y: d - (x - y) ** 2,
        lambda d, x, y: np.sqrt(d * d - (x - y) ** 2),
        lambda d, x, y: d * d + (x - y) ** 2,
        lambda d, x, y: (d - abs(x - y)) ** 2,
        lambda d, x, y: d * d - (x + y) ** 2,
    )
)
def distance_reduced_wrongly(k, p, g, d, square):
    """d is reduced wrongly. Seen along the axis, which right triangle do d, the difference of the heights, and the
    reduced distance make?"""
    return _by_cosine((k, p, g, d), square(d, k @ p, k @ g))


@EXERCISE.mistake(sides=(0, 1), middle=(angle_about, lambda *case: 0.0))
def not_projected(k, p, g, d, sides, middle):
    """p and g are not projected onto the plane perpendicular to the axis. In which plane does the triangle lie, and
    how long are its sides there?"""
    product = np.linalg.norm(p) * np.linalg.norm(g)
    lost = (k @ (p - g)) ** 2 if sides else (k @ p) ** 2 + (k @ g) ** 2
    return _by_cosine((k, p, g, d), d * d - lost, product) - angle_about(k, p, g) + middle(k, p, g)


@EXERCISE.mistake(factor=(0.5, -1))
def law_of_cosines_wrong(k, p, g, d, factor):
    """the law of cosines has a wrong sign or a wrong factor. What does it say of an angle of 90 degrees, and of 0?"""
    product = np.linalg.norm(across(k, p)) * np.linalg.norm(across(k, g))
    return _by_cosine((k, p, g, d), d * d - (k @ (p - g)) ** 2, factor * product)


add_swings(EXERCISE, _solutions, lambda k, p, g, d: (k, p, g))
