"""subproblem1: the rotation about an axis that brings one point to another."""

import numpy as np

from course_lib.checks.answer_types import NOT_A_NUMBER, Unreadable
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.kinds import quarters
from course_lib.checks.mistake import Question
from course_lib.checks.special_cases import ON_BOTH_SIDES, SMALL_NUMBERS, Sweep
from course_lib.checks.tolerances import EXACT, HALF_THE_DIGITS, PREDICTED
from course_lib.checks.vocabulary import X, Y, Z, angle_gap, compared, distance_of_angles, unit
from course_lib.lessons.subproblems_damped_ik.exercises.shared import (
    NEAR_THE_AXIS,
    across,
    angle_about,
    nearly_along,
    of_all_lengths,
    off_axis,
    on_the_grid,
    one_near,
    rotated,
    single,
)
from course_lib.subproblems import subproblem1


def some_angle(rng, sign):
    """Return a random angle with this sign, neither small nor near pi/2."""
    return sign * rng.uniform(0.3, 1.2)


def _cases(rng):
    plain = [(Z, X, Y), (Z, Y, X), (Z, X, X), (Z, X, 0 - X), (Y, Z, X), (0 - X, Y, Z)]
    plain += [(0 - Z, X, Y)]
    there = 2 * X + 3 * Y  # |there|^2 / (|there| |there|) comes out above 1
    heights = [(Z, X + 2 * Z, Y + 2 * Z), (Z, there, there)]
    # Points in whole numbers, whose parts across the axis are not whole.
    whole = [(np.array([0.6, 0.8, 0]), np.array([1.0, 2, 3]), np.array([3.0, 1, 2]))]
    reached = []
    for angle in (
        some_angle(rng, 1),
        np.pi - some_angle(rng, 1),
        some_angle(rng, -1),
        some_angle(rng, 1) - np.pi,
    ):
        k = unit(rng)
        p = off_axis(k, rng)
        reached.append((k, p, rotated(k, angle, p)))
    k, p, g = reached[3]
    missed = [
        (Z, 2 * X, np.array([0.0, 3, 1])),
        (k, p, g + 0.8 * k),
        (k, p, g + 1.5 * across(k, g)),
    ]
    missed += [(k, 100 * p, 30 * unit(rng) + 70 * across(k, g)), (k, g + 2 * k, p - 2 * k)]
    return plain + heights + whole + reached + missed + [(Z, 2 * Z, X), (Z, X, 0 - Z)]


def _special(rng):
    """Points of which one is the other, rotated by some quarters of a revolution, or any two."""
    drawn = on_the_grid(rng)
    if drawn is None:
        return None
    k, p, g, _ = drawn
    return k, p, rotated(k, quarters(rng), p) if rng.random() < 0.5 else g


def _both_near_the_axis(rng, size):
    k = unit(rng)
    p, g = (across(k, off_axis(k, rng)) for _ in range(2))
    return k, size * p + 1.5 * k, 0.3 * size * g - 0.8 * k


def _rotating_by(angle):
    def case(rng, gap):
        k = unit(rng)
        p = off_axis(k, rng)
        return k, p, rotated(k, angle + gap, p)

    return Sweep(f"theta near {angle:.4g}", case, ON_BOTH_SIDES)


def _nearly_vertical(rng, size):
    """A reachable point g, with an axis that is nearly vertical."""
    k = nearly_along(Z, rng, size)
    p = off_axis(k, rng)
    return k, p, rotated(k, some_angle(rng, 1), p)


def _reached_by(angle):
    """Return a problem that this angle solves."""

    def case(rng):
        k = unit(rng)
        p = off_axis(k, rng)
        return k, p, rotated(k, angle, p)

    return case


# The points of subproblem 1 may be as near to the axis as they like, and as near to the origin.
_NEAR = (*NEAR_THE_AXIS, 9e-7, 9e-8)
# Both points are so near to the axis that the product of their distances is tiny, and that of their
# heights is not.
_BOTH_NEAR = (1e-3, 1e-4, 1e-5)
_TINY = (1e-6, 1e-7, 3e-9)  # below 1e-8, which np.allclose takes for 0


def _free(k, p, g):
    return not across(k, p).any() or not across(k, g).any()


def _off(theta, k, p, g):
    """Return the vector from where p should end to where it ends."""
    return rotated(k, theta, p) - rotated(k, angle_about(k, p, g), p)


def _reached(k, p, g):
    return not _free(k, p, g) and np.linalg.norm(rotated(k, angle_about(k, p, g), p) - g) < EXACT


def _nearest(k, p, g):
    return not _free(k, p, g) and not _reached(k, p, g)


def _right(theta, k, p, g):
    return np.linalg.norm(_off(theta, k, p, g)) < HALF_THE_DIGITS * np.linalg.norm(across(k, p))


def _angle(theta, k, p, g):
    try:
        return single(theta, "one angle, a number")
    except Unreadable as wrong:
        if wrong.mistake is NOT_A_NUMBER and not _reached(k, p, g):
            return np.nan  # a wrong formula in the ordinary cases says more
        raise


def _same(theta, predicted, k, p, g):
    """Return whether two answers are the same angle; where every angle is right, any number is."""
    return (
        bool(np.isfinite(theta))
        if _free(k, p, g)
        else bool(angle_gap(theta, predicted) < PREDICTED)
    )


EXERCISE = Exercise(
    name="subproblem1",
    points=2,
    sets=2,
    arguments=("k", "p", "g"),
    free=("k", "p", "g"),
    tolerance=HALF_THE_DIGITS,  # an arccos with a sign has no more, near 0 and pi
    cases=_cases,
    returns=_angle,
    library=lambda k, p, g: subproblem1(k, p, g).theta,
    alike=_same,
    distance=distance_of_angles,
    special=_special,
    sweeps=(
        _rotating_by(0.0),
        _rotating_by(np.pi),
        Sweep("an axis with small entries", _nearly_vertical, SMALL_NUMBERS),
        of_all_lengths(_reached_by(0.8), 0, 1, 1),
        Sweep("both points near the axis", _both_near_the_axis, _BOTH_NEAR),
        *one_near(lambda k, p, g: (k, p, g), axis=_NEAR, origin=_TINY),
    ),
    properties=(
        Property(
            "R(k, theta) p = g",
            _right,
            lambda theta, k, p, g: (
                "R(k, theta) p should be " + compared(g, rotated(k, theta, p)) + "."
            ),
            where=_reached,
            otherwise=Question(
                "theta is not the angle about k from p to g",
                "Follow these points through your function, or points like them that you can draw. "
                "Which number on the way to the angle differs from what you expect?",
            ),
        ),
        Property(
            "the answer is a number, even if no angle brings p to g",
            lambda theta, *case: np.isfinite(theta),
            where=_nearest,
            otherwise=Question(
                "nothing is returned where no angle brings p to g",
                "Which angle brings p nearest to g, and which line of yours makes it nan or inf?",
            ),
        ),
        Property(
            "if no angle brings p to g, R(k, theta) p is as near to g as possible",
            _right,
            lambda theta, k, p, g: (
                "The point nearest to g should be "
                + compared(rotated(k, angle_about(k, p, g), p), rotated(k, theta, p))
                + "."
            ),
            where=_nearest,
        ),
        Property(
            "the answer is a number, even if a point lies on the axis",
            lambda theta, *case: np.isfinite(theta),
            where=_free,
            otherwise=Question(
                "something is divided by a length that is 0 for a point on the axis",
                "A point lies on the axis here. Which line makes the answer nan or inf? Which "
                "function finds an angle from its sine and cosine without a division?",
            ),
        ),
    ),
    hints=(
        (
            "A rotation about k moves only the part perpendicular to k. Take p' = p - (k . p) k and"
            " g' = g - (k . g) k."
        ),
        "p' . g' = |p'| |g'| cos(theta), and k . (p' x g') = |p'| |g'| sin(theta).",
        (
            "theta = np.arctan2(k @ np.cross(p', g'), p' @ g'): no division, all four quadrants."
            " Where g cannot be reached it is the nearest, without a further line."
        ),
    ),
    forbidden=("course_lib.subproblems.subproblem1",),
)


LOST_SIGN_HINT = (
    "Neither arccos nor the length of a cross product tells one direction of rotation from the "
    "other: what does?"
)


@EXERCISE.mistake("the sign of the angle is lost", LOST_SIGN_HINT)
def sign_lost(k, p, g):
    return abs(angle_about(k, p, g))


@EXERCISE.mistake(
    "the sign of the angle is lost, and p and g are not projected onto the plane perpendicular to "
    "the axis",
    LOST_SIGN_HINT,
)
def sign_lost_and_not_projected(k, p, g):
    return np.arctan2(np.linalg.norm(np.cross(p, g)), p @ g)


@EXERCISE.mistake(
    "p and g are not projected onto the plane perpendicular to the axis",
    "Which part of a point does the rotation move?",
    sine=(np.dot, lambda k, n: np.sign(k @ n) * np.linalg.norm(n)),
)
def not_projected(k, p, g, sine):
    return np.arctan2(sine(k, np.cross(p, g)), p @ g)
