"""subproblem3: the rotations about an axis that bring one point to a given distance from another."""

import numpy as np

from course_lib.checks.answer_types import rows
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.subproblems_damped_ik.shared import (
    across,
    all_of_them,
    angle_about,
    either_side,
    rotated,
    same_list,
    swing_mistakes,
    too_few,
    unless_empty,
    where_two,
)
from course_lib.checks.exercises.subproblems_damped_ik.subproblem1 import X, Y, Z, off_axis
from course_lib.checks.vocabulary import unit
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
    named = [
        (Z, X, X, np.sqrt(2.0)),
        (Z, X, 2 * Y, np.sqrt(3.0)),
        (Z, np.array([2.0, 0, 1]), np.array([0.0, 2, 3]), np.sqrt(8.0)),
    ]
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
        (Z, X, X, -1.0),
        (k, p, g, -d),
    ]
    return named + generic + none + [(Z, X, 3 * Y, 2.0), (Z, np.array([3.0, 0, 1]), Y + Z, 4.0)]


def _reach(k, p, g):
    """The largest and the smallest distance from g that p comes to."""
    middle = angle_about(k, p, g)
    return [np.linalg.norm(rotated(k, middle + aside, p) - g) for aside in (np.pi, 0.0)]


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


def _by_height(height):
    """The angles of somebody who asks subproblem 4 for height(|p|, |g|, d) along g."""

    def angles(k, p, g, d):
        found = subproblem4(k, g, p, height(np.linalg.norm(p), np.linalg.norm(g), d))
        return list(found.theta) if found.exact else None

    return angles


def _by_cosine(square, twice=lambda a, b, p, g: 2 * np.linalg.norm(a) * np.linalg.norm(b), middle=angle_about):
    """The angles by the law of cosines: square(d, p, g along k), twice(p', g', p, g); middle(k, p, g)."""

    def angles(k, p, g, d):
        a, b = across(k, p), across(k, g)
        return either_side(middle(k, p, g), (a @ a + b @ b - square(d, k @ p, k @ g)) / twice(a, b, p, g))

    return angles


def _unprojected(middle):
    def angles(k, p, g, d):
        cosine = (p @ p + g @ g - d * d) / (2 * np.linalg.norm(p) * np.linalg.norm(g))
        return either_side(middle(k, p, g), cosine)

    return angles


def _right_square(d, x, y):
    return d * d - (x - y) ** 2


EXERCISE = Exercise(
    name="subproblem3",
    points=2,
    arguments=("k", "p", "g", "d"),
    cases=_cases,
    returns=unless_empty(rows(1, "a list of angles, empty if there is none"), _solutions),
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
                mistake=Mistake(
                    "a negative d is squared, and its sign lost",
                    "Treat a negative d before you square it: which points are at a negative distance?",
                ),
            ),
            Property(
                "the list is empty if d is too large or too small",
                _is_empty,
                _nothing_there,
                where=lambda *case: not _solutions(*case),
                mistake=Mistake(
                    "an angle is returned although no angle is right",
                    "If the cosine leaves [-1, 1], or d'^2 is negative, no rotation does it. Clipping hides that.",
                ),
            ),
        ),
    ),
    mistakes=where_two(
        _solutions,
        _misses,
        *too_few("angle", _misses),
        Mistake(
            "the height has the wrong sign",
            "d^2 = |p|^2 + |g|^2 - 2 g . R p: solve for g . R p.",
            _by_height(lambda p, g, d: (d * d - p * p - g * g) / 2),
        ),
        Mistake(
            "the 1/2 of the height is missing",
            "d^2 = |p|^2 + |g|^2 - 2 g . R p: solve for g . R p.",
            _by_height(lambda p, g, d: p * p + g * g - d * d),
        ),
        Mistake(
            "d itself is taken for the height",
            "Which height along g does R p have if it is at the distance d from g?",
            _by_height(lambda p, g, d: d),
        ),
        Mistake(
            "a length is not squared",
            "Square both sides: |p|^2 + |g|^2 - 2 g . R p = d^2.",
            _by_height(lambda p, g, d: (p * p + g * g - d) / 2),
            _by_height(lambda p, g, d: (p + g - d * d) / 2),
            _by_height(lambda p, g, d: (p + g - d) / 2),
            _by_cosine(lambda d, x, y: d - (x - y) ** 2),
            _by_cosine(lambda d, x, y: d * d - abs(x - y)),
            _by_cosine(lambda d, x, y: np.sqrt(d * d - (x - y) ** 2)),
            _by_cosine(lambda d, x, y: d),
        ),
        Mistake(
            "the heights along the axis are forgotten: d is not reduced",
            "Seen along the axis the distance is shorter: d'^2 = d^2 - (k . (p - g))^2.",
            _by_cosine(lambda d, x, y: d * d),
        ),
        Mistake(
            "p and g are not projected onto the plane perpendicular to the axis",
            "The triangle is perpendicular to the axis: its sides are |p'|, |g'| and d', with p' = p - (k . p) k.",
            _unprojected(angle_about),
            _unprojected(lambda *case: 0.0),
            _unprojected(lambda k, p, g: np.arctan2(k @ np.cross(p, g), p @ g)),
            _by_cosine(_right_square, lambda a, b, p, g: 2 * np.linalg.norm(p) * np.linalg.norm(g)),
        ),
        Mistake(
            "d is reduced wrongly",
            "Pythagoras: d'^2 = d^2 - (k . (p - g))^2.",
            _by_cosine(lambda d, x, y: d * d + (x - y) ** 2),
            _by_cosine(lambda d, x, y: (d - x + y) ** 2),
            _by_cosine(lambda d, x, y: (d - abs(x - y)) ** 2),
            _by_cosine(lambda d, x, y: d * d - (x + y) ** 2),
        ),
        Mistake(
            "the 2 of the law of cosines is missing",
            "d'^2 = |p'|^2 + |g'|^2 - 2 |p'| |g'| cos(angle).",
            _by_cosine(_right_square, lambda a, b, p, g: np.linalg.norm(a) * np.linalg.norm(b)),
        ),
        *swing_mistakes("g", _solutions, _misses, lambda middle: _by_cosine(_right_square, middle=middle)),
        Mistake(
            "the law of cosines has the wrong sign",
            "d'^2 = |p'|^2 + |g'|^2 - 2 |p'| |g'| cos(angle): solve for the cosine.",
            _by_cosine(_right_square, lambda a, b, p, g: -2 * np.linalg.norm(a) * np.linalg.norm(b)),
        ),
    ),
    alike=same_list,
    library=_solutions,
    hints=(
        "Square both sides of |R p - g| = d. Which terms depend on theta?",
        "Only g . R p does: it must be a certain height of R p along g. Squaring loses the sign of d: look at d first.",
        "That is subproblem 4 with h = g and the height (|p|^2 + |g|^2 - d^2) / 2.",
    ),
    forbidden=("course_lib.subproblems.subproblem3",),
)
