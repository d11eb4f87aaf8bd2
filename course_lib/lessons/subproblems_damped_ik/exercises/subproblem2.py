"""subproblem2: the rotations about two axes that bring two points together."""

import itertools

import numpy as np

from course_lib.checks.answer_types import rows
from course_lib.checks.exercise import Exercise
from course_lib.checks.format_numbers import format_as_needed
from course_lib.checks.kinds import coarse_axis, quarters
from course_lib.checks.mistake import Question
from course_lib.checks.special_cases import JUST_WITHIN, OUT_OF_REACH, SMALL_NUMBERS, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import X, Y, Z, distance_of_lists, same_list, unit
from course_lib.lessons.subproblems_damped_ik.exercises import shared
from course_lib.lessons.subproblems_damped_ik.exercises.shared import rotated, two
from course_lib.subproblems import subproblem2

_ANGLED = np.array([0.6, 0.0, 0.8])


def _axes(rng, cosine):
    """Two axes with this cosine between them, the unit vector perpendicular to both, and one
    perpendicular to that and the first."""
    k1 = unit(rng)
    n = np.cross(k1, unit(rng))
    n /= np.linalg.norm(n)
    e = np.cross(n, k1)
    return k1, cosine * k1 + np.sqrt(1 - cosine**2) * e, n, e


def _meeting(rng, cosine, turns, size):
    """Points on circles that meet twice, well apart."""
    k1, k2, n, e = _axes(rng, cosine)
    beside = rng.uniform(0.3, 0.6) * (rng.choice([-1, 1]) * k1 + rng.choice([-1, 1]) * e)
    meet = size * (beside + rng.uniform(0.5, 1) * n)
    return k1, k2, rotated(k1, -turns[0], meet), rotated(k2, -turns[1], meet)


def _apart(rng, cosine, side):
    """Points on small circles on one sphere, each about its own axis: they do not meet."""
    k1, k2, n, e = _axes(rng, cosine)
    return k1, k2, 2 * rotated(e, 0.3, k1), 2 * side * rotated(n, 0.3, k2)


def _around(rng, reach, size):
    """Points on circles that would touch in the plane of the axes if reach were 1. They do not meet
    if it is above, and meet twice if it is below."""
    k1, k2, n, e = _axes(rng, 0.5)
    in_plane = reach * (np.cos(0.5) * k1 + np.sin(0.5) * e)
    points = [(k @ in_plane) * k + np.sqrt(1 - (k @ in_plane) ** 2) * n for k in (k1, k2)]
    return k1, k2, size * points[0], size * points[1]


def _small(rng, size):
    """Axes with small entries, and points on circles that meet, one of them after a small angle."""
    k1, k2 = shared.nearly_along(Z, rng, size), shared.nearly_along(X, rng, size)
    n = np.cross(k1, k2) / np.linalg.norm(np.cross(k1, k2))
    a, b, c = rng.uniform(0.4, 0.9, 3)
    meet = a * k1 + b * np.cross(n, k1) + c * n
    return k1, k2, rotated(k1, -0.7 * size, meet), rotated(k2, 0.8, meet)


def _near_its_axis(first):
    """Circles that meet twice, the first of which is small, or the second one."""

    def case(rng, size):
        k1, k2, n, _ = _axes(rng, 0.5)
        k = k1 if first else k2
        meet = k + size * (0.6 * np.cross(n, k) + 0.8 * n)
        return k1, k2, rotated(k1, -0.7, meet), rotated(k2, 0.9, meet)

    return Sweep("a point near its axis", case, _SMALL_CIRCLES)


# Radii, as shares of the distance from the origin. The last one makes |p1|^2 - |a k1 + b k2|^2
# 2.6e-10 |p1|^2; the task says that it is above 1e-10 |p1|^2.
_SMALL_CIRCLES = (*shared.NEAR_THE_AXIS[:3], 2e-5)

# Radians. The task says that axes are not nearer to parallel than the last of these.
_BETWEEN_AXES = (0.3, 0.1, 0.03, 0.01)


def _nearly_parallel(rng, angle):
    return _meeting(rng, rng.choice([-1, 1]) * np.cos(angle), (0.7, -0.9), 1.0)


def _special(rng):
    """Points in whole numbers of a unit of length: those which quarters of a revolution take to
    where their circles meet, or two that are equally far from the origin."""
    drawn = shared.on_the_grid(rng)
    k2, order = coarse_axis(rng), rng.permutation(3)
    if drawn is None:
        return None
    k1, meet, *_ = drawn
    p1, p2 = (rotated(k, quarters(rng), meet) for k in (k1, k2))
    if rng.random() < 0.5:
        p1, p2 = meet, rng.choice([-1, 1], 3) * meet[order]
    return k1, k2, p1, p2


def _admits(k1, k2, p1, p2):
    """Return whether the axes are not parallel, and the circles on one sphere, and far from
    touching."""
    if np.linalg.norm(np.cross(k1, k2)) < 0.1 or abs(p1 @ p1 / (p2 @ p2) - 1) > EXACT:
        return False
    a, b = np.linalg.solve([[1, k1 @ k2], [k1 @ k2, 1]], [k1 @ p1, k2 @ p2])
    middle = a * k1 + b * k2
    return abs(1 - middle @ middle / (p1 @ p1)) > 1e-6


def _cases(rng):
    def small(sign):
        return sign * rng.uniform(0.3, 1.2)

    def large(sign):
        return sign * rng.uniform(1.9, 2.8)

    whole = np.array([3.0, 4, 2])
    there = np.array([2.0, 1, 2])
    meeting = [
        (Z, X, np.array([1.0, 2, 2]), np.array([2.0, -2, 1])),
        (Z, _ANGLED, np.array([0.0, 5, 2]), rotated(_ANGLED, 1.0, np.array([3.0, 4, 2]))),
        (Z, _ANGLED, rotated(Z, 0.8, rotated(_ANGLED, 1.0, whole)), whole),
        *zip(4 * [Z], 4 * [X], *(shared.by_quarters(k, there) for k in (Z, X)), strict=True),
        _meeting(rng, 0.0, (small(1), small(-1)), 1.0),
        _meeting(rng, 0.5, (large(1), small(1)), 1.0),
        _meeting(rng, 0.7, (small(-1), large(1)), 2.0),
        _meeting(rng, -0.6, (large(-1), small(-1)), 0.3),
        _meeting(rng, -0.3, (small(1), large(-1)), 40.0),
    ]
    apart = [
        (Z, X, Y + 3 * Z, 3 * X - Y),
        _apart(rng, 0.4, 1),
        _apart(rng, -0.2, -1),
        _around(rng, 1.01, 0.3),
    ]
    apart += [_around(rng, 1 + 1e-7, 2.0)]
    return meeting + apart


solutions = shared.exact_solutions(subproblem2)


def pairs_by_the_text(k1, k2, p1, p2, power=2, axes_are_perpendicular=False):
    """Return the pairs for z = a k1 + b k2 + c (k1 x k2): two, or none if c^2 is negative, however
    little, or if the points are not equally far from the origin.

    power: of the length of k1 x k2 by which c^2 is divided; 2 is right.
    axes_are_perpendicular: whether |a k1 + b k2|^2 is taken for a^2 + b^2.
    """
    lengths = np.linalg.norm(p1), np.linalg.norm(p2)
    if abs(lengths[0] - lengths[1]) > EXACT * max(lengths):
        return []
    cosine, n = k1 @ k2, shared.cross(k1, k2)
    a, b = np.linalg.solve([[1, cosine], [cosine, 1]], [k1 @ p1, k2 @ p2])
    middle = a * k1 + b * k2
    squared = a**2 + b**2 if axes_are_perpendicular else middle @ middle
    c_squared = (p1 @ p1 - squared) / np.linalg.norm(n) ** power
    if c_squared <= 0:
        return []
    points = [middle + sign * np.sqrt(c_squared) * n for sign in (1, -1)]
    return [(shared.angle_about(k1, p1, z), shared.angle_about(k2, p2, z)) for z in points]


def _misses(pair, k1, k2, p1, p2):
    return np.linalg.norm(rotated(k1, pair[0], p1) - rotated(k2, pair[1], p2)) / np.linalg.norm(p1)


def _gap(pair, k1, k2, p1, p2):
    def gap_of(angles):
        return _misses(angles, k1, k2, p1, p2) * np.linalg.norm(p1)

    gap = gap_of(pair)

    def are_as_far_apart(written):
        return abs(gap_of(written) - gap) < gap / 1000

    angles = format_as_needed(pair, are_as_far_apart, digits=6)
    return f"With {angles} the points are {gap:.3g} apart."


def _gap_of_the_first(pairs, *case):
    return _gap(pairs[0], *case)


EXERCISE = Exercise(
    name="subproblem2",
    points=3,
    arguments=("k1", "k2", "p1", "p2"),
    tolerance=EXACT,
    cases=_cases,
    returns=rows(2, "a list of pairs (theta1, theta2), empty if there is none"),
    library=solutions,
    alike=same_list,
    distance=distance_of_lists,
    special=_special,
    admits=_admits,
    sweeps=(
        Sweep(
            "circles that just miss",
            lambda rng, beyond: _around(rng, 1 + beyond, 1.0),
            OUT_OF_REACH,
        ),
        Sweep(
            "circles that meet twice, and nearly touch",
            lambda rng, gap: _around(rng, 1 - gap, 1.0),
            (*JUST_WITHIN, 1e-9, 1e-10),
        ),
        Sweep(
            "the same with points as near to the origin as the task allows",
            lambda rng, gap: _around(rng, 1 - gap, 1e-5),
            (0.1, 1e-2, 1e-3, 1e-4),
        ),
        Sweep("axes with small entries, and a small angle", _small, SMALL_NUMBERS),
        shared.of_all_lengths(lambda rng: _meeting(rng, 0.5, (0.7, -0.9), 1.0), 0, 0, 1, 1),
        shared.of_all_lengths(lambda rng: _apart(rng, rng.uniform(0.2, 0.6), 1), 0, 0, 1, 1),
        _near_its_axis(first=True),
        _near_its_axis(first=False),
        Sweep("nearly parallel axes", _nearly_parallel, _BETWEEN_AXES),
    ),
    properties=shared.all_of_them(
        "each pair brings the points together: R(k1, theta1) p1 = R(k2, theta2) p2",
        "pair",
        _misses,
        _gap,
        solutions,
        none=(
            shared.empty_list(
                "the list is empty if the circles do not meet",
                _gap_of_the_first,
                where=lambda *case: not solutions(*case),
                otherwise=Question(
                    "a pair is returned although the circles miss",
                    "The circles miss here. Which number in your code shows it, and what does your "
                    "function return then?",
                ),
            ),
        ),
    ),
    hints=(
        "p1 moves on a circle about k1, p2 on one about k2. Where they meet there is a point z "
        "with |z| = |p1| = |p2|, "
        "k1 . z = k1 . p1 and k2 . z = k2 . p2.",
        "z = a k1 + b k2 + c (k1 x k2), and the given lines find a and b. Pythagoras gives c^2, as "
        "in the text. If it "
        "is negative there is no solution: an empty list.",
        "For each of the two z: theta1 = subproblem1(k1, p1, z), theta2 = subproblem1(k2, p2, z).",
    ),
    forbidden=("course_lib.subproblems.subproblem2",),
)

shared.add_too_few(EXERCISE, solutions, _misses)


@EXERCISE.mistake(
    "each theta1 is combined with each theta2",
    "How many points z are there, and which theta1 and theta2 belong to each of them?",
)
def all_combinations(k1, k2, p1, p2):
    pairs = two(solutions, k1, k2, p1, p2)
    return list(itertools.product(pairs[:, 0], pairs[:, 1]))


@EXERCISE.mistake(
    "c is that for an axis k1 x k2 of length one",
    "How long is k1 x k2 if the axes are not perpendicular, and how long is c (k1 x k2)?",
    power=(0, 1),
)
def c_of_perpendicular_axes(k1, k2, p1, p2, power):
    two(solutions, k1, k2, p1, p2)
    return pairs_by_the_text(k1, k2, p1, p2, power)


@EXERCISE.mistake(
    "|a k1 + b k2|^2 is taken for a^2 + b^2",
    "That holds for perpendicular axes. Multiply (a k1 + b k2) . (a k1 + b k2) out: which term "
    "does your sum leave out?",
)
def middle_of_perpendicular_axes(k1, k2, p1, p2):
    return pairs_by_the_text(k1, k2, p1, p2, axes_are_perpendicular=True)
