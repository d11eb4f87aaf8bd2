"""subproblem3: the rotations about an axis that bring one point to a given distance from another."""

import numpy as np

from course_lib.checks.answer_types import rows
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.subproblems_damped_ik.shared import (
    across,
    all_of_them,
    angle_about,
    mended,
    near,
    predicted,
    too_few,
    turned,
    unless_empty,
    where_two,
    wrong_middles,
)
from course_lib.checks.subproblems_damped_ik.subproblem1 import X, Y, Z, off_axis
from course_lib.checks.vocabulary import unit
from course_lib.subproblems import subproblem3


def _reachable(rng, aside, middle, size):
    """p and q about an axis, and a distance at which p has turned `aside` beyond the direction of q."""
    k = unit(rng)
    p, q = size * off_axis(k, rng), size * off_axis(k, rng)
    q = turned(k, angle_about(k, q, p) + middle, q)
    q = q if (k @ p) * (k @ q) < 0 else q - 2 * (k @ q) * k  # their heights on both sides of 0
    turn = angle_about(k, p, q) + aside
    return k, p, q, float(np.linalg.norm(turned(k, turn, p) - q))


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
    k, p, q, d = generic[1]
    far, close = _reach(k, p, q)
    none = [
        (Z, X, 2 * Y, 4.0),
        (Z, X, 3 * Y, 1.0),
        (Z, X, Y + 2 * Z, 1.5),
        (k, p, q, 1.1 * far),
        (k, p, q, 0.9 * close),
        (Z, X, X, -1.0),
        (k, p, q, -d),
    ]
    return named + generic + none + [(Z, X, 3 * Y, 2.0), (Z, np.array([3.0, 0, 1]), Y + Z, 4.0)]


def _reach(k, p, q):
    """The largest and the smallest distance from q that p comes to."""
    middle = angle_about(k, p, q)
    return [np.linalg.norm(turned(k, middle + aside, p) - q) for aside in (np.pi, 0.0)]


def _count(*case):
    right = subproblem3(*case)
    return int(right.count) if right.exact else 0


def _misses(theta, k, p, q, d):
    return abs(np.linalg.norm(turned(k, theta, p) - q) - d) / max(np.linalg.norm(p), np.linalg.norm(q))


def _tell(theta, k, p, q, d):
    return f"With {theta:.6g} it is {round(np.linalg.norm(turned(k, theta, p) - q), 9):.6g}; d is {d:.6g}."


def _is_empty(found, *case):
    return len(found) == 0


def _nothing_there(found, k, p, q, d):
    far, close = _reach(k, p, q)
    return f"R(k, theta) p comes as near to q as {close:.4g} and goes as far as {far:.4g}; d is {d:.4g}."


def either_side(middle, cosine):
    """middle +- arccos(cosine); a cosine out of range is taken for the nearest in range."""
    aside = np.arccos(np.clip(cosine, -1, 1))
    return [middle - aside, middle + aside]


def _by_cosine(square, product=None, middle=angle_about):
    """The angles of somebody who finds the angle at the axis by |p'|^2 + |q'|^2 - square over twice the product."""

    def angles(k, p, q, d):
        a, b = across(k, p), across(k, q)
        twice = product(a, b, p, q) if product else 2 * np.linalg.norm(a) * np.linalg.norm(b)
        return either_side(middle(k, p, q), (a @ a + b @ b - square(d, k @ (p - q), k @ (p + q))) / twice)

    return angles


def _unprojected(k, p, q, d, middle=angle_about):
    cosine = (p @ p + q @ q - d * d) / (2 * np.linalg.norm(p) * np.linalg.norm(q))
    return either_side(middle(k, p, q), cosine)


def _right_square(d, h, s):
    return d * d - h * h


_ONE = "angle"


def _solutions(k, p, q, d):
    """All solutions as the exercise asks for them; none where there is only a nearest one."""
    answers = subproblem3(k, p, q, d)
    return list(answers.theta[: answers.count]) if answers.exact else []


EXERCISE = Exercise(
    name="subproblem3",
    points=2,
    arguments=("k", "p", "q", "d"),
    cases=_cases,
    returns=unless_empty(rows(1, "a list of angles, empty where there is none"), _count),
    properties=all_of_them(
        "each theta brings p to the distance d from q: |R(k, theta) p - q| = d",
        _ONE,
        _misses,
        _tell,
        _count,
        none=(
            Property(
                "the list is empty where d is below zero: no distance is",
                _is_empty,
                where=lambda k, p, q, d: d < 0,
                mistake=Mistake("a negative d is squared, and its sign lost", "if d < 0: return []"),
            ),
            Property(
                "the list is empty where d is too large or too small",
                _is_empty,
                _nothing_there,
                where=lambda *case: _count(*case) == 0,
                mistake=Mistake(
                    "an angle is returned where there is none",
                    "Where the cosine leaves [-1, 1], or d'^2 is below zero, no rotation does it. Clipping hides that.",
                ),
            ),
        ),
    ),
    mistakes=where_two(
        _count,
        _misses,
        *too_few(_ONE, _misses),
        *mended(("the angles are in degrees", "Angles are in radians."), _misses, np.deg2rad),
        *predicted(
            (
                "the heights along the axis are forgotten: d is not reduced",
                "Seen along the axis the distance is shorter: d'^2 = d^2 - (k . (p - q))^2.",
            ),
            _by_cosine(lambda d, h, s: d * d),
        ),
        *predicted(
            (
                "p and q are not projected across the axis",
                "The triangle lies across the axis: its sides are |p'|, |q'| and d', with p' = p - (k . p) k.",
            ),
            _unprojected,
            lambda k, p, q, d: [np.arccos((p @ p + q @ q - d * d) / (2 * np.linalg.norm(p) * np.linalg.norm(q)))],
            lambda k, p, q, d: _unprojected(k, p, q, d, lambda *case: 0.0),
            lambda k, p, q, d: _unprojected(k, p, q, d, lambda k, p, q: np.arctan2(k @ np.cross(p, q), p @ q)),
            _by_cosine(_right_square, lambda a, b, p, q: 2 * np.linalg.norm(p) * np.linalg.norm(q)),
        ),
        *predicted(
            ("a length is not squared", "The law of cosines has squares: |p'|^2 + |q'|^2 - d'^2."),
            _by_cosine(lambda d, h, s: d - h * h),
            _by_cosine(lambda d, h, s: d * d - abs(h)),
            _by_cosine(lambda d, h, s: np.sqrt(d * d - h * h)),
            _by_cosine(lambda d, h, s: d),
        ),
        *predicted(
            ("d is reduced wrongly", "Pythagoras: d'^2 = d^2 - (k . (p - q))^2."),
            _by_cosine(lambda d, h, s: d * d + h * h),
            _by_cosine(lambda d, h, s: (d - h) ** 2),
            _by_cosine(lambda d, h, s: (d - abs(h)) ** 2),
            _by_cosine(lambda d, h, s: d * d - s * s),
        ),
        *predicted(
            ("the 2 of the law of cosines is missing", "d'^2 = |p'|^2 + |q'|^2 - 2 |p'| |q'| cos(angle)."),
            _by_cosine(_right_square, lambda a, b, p, q: np.linalg.norm(a) * np.linalg.norm(b)),
        ),
        *wrong_middles("q", lambda middle: _by_cosine(_right_square, middle=middle), _misses),
        *predicted(
            (
                "the law of cosines has the wrong sign",
                "d'^2 = |p'|^2 + |q'|^2 - 2 |p'| |q'| cos(angle): solve for the cosine.",
            ),
            _by_cosine(_right_square, lambda a, b, p, q: -2 * np.linalg.norm(a) * np.linalg.norm(b)),
        ),
        Mistake(
            "the angle beside q is returned with one sign for all",
            "theta = subproblem1(k, p, q) +- arccos(...): one to each side of q.",
            seen=lambda found, k, p, q, d: len(found) == 2 and bool(near(found[0], found[1])),
        ),
    ),
    library=_solutions,
    hints=(
        "Square both sides of |R p - q| = d. Which terms depend on theta?",
        "Only q . R p does: it must be a certain height of R p along q. Squaring loses the sign of d: look at d first.",
        "That is subproblem 4 with h = q and the height (|p|^2 + |q|^2 - d^2) / 2.",
    ),
    forbidden=("course_lib.subproblems.subproblem3",),
)
