"""subproblem4: the rotations about an axis that bring a point to a given height along a direction."""

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
from course_lib.subproblems import subproblem4


def _reachable(rng, aside, middle, size):
    """A direction h, a point p, and the height at which p is rotated `aside` beyond h."""
    k = unit(rng)
    h, p = size * off_axis(k, rng), off_axis(k, rng)
    h = rotated(k, angle_about(k, h, p) + middle, h)
    return k, h, p, float(h @ rotated(k, angle_about(k, p, h) + aside, p))


def _cases(rng):
    named = [
        (Z, X, X, 0.5),
        (Z, X, Y, 0.0),
        (Z, Y, 2 * X, -1.0),
        (Z, X, np.array([2.0, 0, 1]), 1.0),
        (Z, np.array([0.6, 0, 0.8]), np.array([0.0, 2, -1]), -0.2),
        (Z, 2 * X, X, 1.0),
    ]
    generic = [
        _reachable(rng, rng.uniform(0.5, 1.0), rng.uniform(0.4, 1.2), 1),
        _reachable(rng, rng.uniform(2.0, 2.6), rng.uniform(-1.2, -0.4), 1),
        _reachable(rng, rng.uniform(1.2, 1.9), rng.uniform(1.9, 2.7), 0.2),
        _reachable(rng, rng.uniform(1.2, 1.9), rng.uniform(-2.7, -1.9), 30),
    ]
    k, h, p, _ = generic[0]
    low, high = _range(k, h, p)
    none = [
        (Z, X, X, 1.5),
        (Z, X, X, -1.5),
        (Z, X, X + 2 * Z, 1.5),
        (k, h, p, high + 0.1 * (high - low)),
        (k, h, p, low - 0.1 * (high - low)),
    ]
    return named + generic + none + [(Z, X, Y, 1.0), (Z, X + Z, Y + Z, 0.0)]


def _range(k, h, p):
    """The lowest and the highest that p comes."""
    middle = angle_about(k, p, h)
    return [h @ rotated(k, middle + aside, p) for aside in (np.pi, 0.0)]


def _solutions(k, h, p, d):
    """All solutions as the exercise asks for them; none where there is only a nearest one."""
    answers = subproblem4(k, h, p, d)
    return list(answers.theta[: answers.count]) if answers.exact else []


def _misses(theta, k, h, p, d):
    return abs(h @ rotated(k, theta, p) - d) / np.linalg.norm(h) / np.linalg.norm(p)


def _nothing_there(found, k, h, p, d):
    low, high = _range(k, h, p)
    return f"h . R(k, theta) p goes from {low:.4g} to {high:.4g}; d is {d:.4g}."


def _by_cosine(offset, swing=None, middle=None):
    """The angles of somebody who takes offset / swing for the cosine of the angle beside `middle`.

    offset(d, k . h, k . p); swing(h', p', h, p), both vectors across the axis first; middle(k, p, h).
    """

    def angles(k, h, p, d):
        a, b = across(k, h), across(k, p)
        length = swing(a, b, h, p) if swing else np.linalg.norm(a) * np.linalg.norm(b)
        return either_side((middle or angle_about)(k, p, h), offset(d, k @ h, k @ p) / length)

    return angles


def _wave(k, h, A, p, e):
    """The angles of somebody who solves A cos(theta) + B sin(theta) = e."""
    B = h @ np.cross(k, p)
    return either_side(np.arctan2(B, A), e / np.hypot(A, B))


def _right_offset(d, kh, kp):
    return d - kh * kp


def _by_sine(k, h, p, d):
    """The angles of somebody who takes the cosine for a sine."""
    sine = np.clip((d - (k @ h) * (k @ p)) / np.linalg.norm(across(k, h)) / np.linalg.norm(across(k, p)), -1, 1)
    middle = angle_about(k, p, h)
    return [middle + np.arcsin(sine), middle + np.pi - np.arcsin(sine)]


def _both_sides_by_arcsine(k, h, p, d):
    first = _by_sine(k, h, p, d)[0]
    return [first, 2 * angle_about(k, p, h) - first]


EXERCISE = Exercise(
    name="subproblem4",
    points=2,
    arguments=("k", "h", "p", "d"),
    cases=_cases,
    returns=unless_empty(rows(1, "a list of angles, empty if there is none"), _solutions),
    properties=all_of_them(
        "each theta brings p to the height d along h: h . R(k, theta) p = d",
        "angle",
        _misses,
        lambda theta, k, h, p, d: f"With {theta:.6g} it is {round(h @ rotated(k, theta, p), 9):.6g}; d is {d:.6g}.",
        _solutions,
        none=(
            Property(
                "the list is empty if p never comes to the height d",
                lambda found, *case: len(found) == 0,
                _nothing_there,
                where=lambda *case: not _solutions(*case),
                mistake=Mistake(
                    "an angle is returned although no angle is right",
                    "If |e| > r, no rotation does it. Clipping hides that.",
                ),
            ),
        ),
    ),
    mistakes=where_two(
        _solutions,
        _misses,
        *too_few("angle", _misses),
        Mistake(
            "the height along the axis is forgotten",
            "(k . h)(k . p) of the height never changes: d and h . p both contain it.",
            _by_cosine(lambda d, kh, kp: d),
            lambda k, h, p, d: _wave(k, h, h @ p, p, d),
            _by_cosine(lambda d, kh, kp: d, lambda a, b, h, p: np.linalg.norm(h) * np.linalg.norm(p)),
        ),
        Mistake(
            "the height along the axis is subtracted wrongly",
            "The constant (k . h)(k . p) is subtracted twice: from d, giving e, and from h . p, giving A.",
            _by_cosine(lambda d, kh, kp: d + kh * kp),
            _by_cosine(lambda d, kh, kp: d - kh),
            lambda k, h, p, d: _wave(k, h, h @ p, p, d - (k @ h) * (k @ p)),
            lambda k, h, p, d: _wave(k, h, h @ p + (k @ h) * (k @ p), p, d - (k @ h) * (k @ p)),
            _by_cosine(lambda d, kh, kp: d - kp),
        ),
        Mistake(
            "lengths are divided out that are not those of the parts perpendicular to the axis",
            "The height swings by |h'| |p'|, with h' = h - (k . h) k and p' = p - (k . p) k.",
            _by_cosine(_right_offset, lambda a, b, h, p: np.linalg.norm(h) * np.linalg.norm(p)),
            _by_cosine(_right_offset, lambda a, b, h, p: np.linalg.norm(h) * np.linalg.norm(b)),
            _by_cosine(_right_offset, lambda a, b, h, p: np.linalg.norm(a) * np.linalg.norm(p)),
            _by_cosine(_right_offset, lambda a, b, h, p: np.linalg.norm(b)),
            _by_cosine(_right_offset, lambda a, b, h, p: np.linalg.norm(a)),
            _by_cosine(_right_offset, lambda a, b, h, p: 1.0),
            _by_cosine(_right_offset, lambda a, b, h, p: np.linalg.norm(a) * np.linalg.norm(b) / np.linalg.norm(h)),
            _by_cosine(_right_offset, lambda a, b, h, p: (np.linalg.norm(a) * np.linalg.norm(b)) ** 2),
        ),
        Mistake(
            "h is divided by its length, and d is not",
            "h need not have length one: leave it as it is.",
            lambda k, h, p, d: _by_cosine(_right_offset)(k, h / np.linalg.norm(h), p, d),
        ),
        *swing_mistakes("h", _solutions, _misses, lambda middle: _by_cosine(_right_offset, middle=middle)),
        Mistake(
            "sine and cosine are swapped",
            "At theta = subproblem1(k, p, h) the height is greatest: cos(0) = 1 belongs to it.",
            _by_sine,
            _both_sides_by_arcsine,
        ),
        Mistake(
            "r is not the root of A^2 + B^2",
            "A cos(theta) + B sin(theta) swings between -r and r, with r = np.hypot(A, B).",
            lambda k, h, p, d: _by_cosine(_right_offset, lambda a, b, h, p: (a @ b) + k @ np.cross(b, a))(k, h, p, d),
        ),
        Mistake(
            "the height is taken to be -d",
            "Where R p points along h, d is positive.",
            _by_cosine(lambda d, kh, kp: kh * kp - d),
            _by_cosine(lambda d, kh, kp: -d - kh * kp),
        ),
    ),
    alike=same_list,
    library=_solutions,
    hints=(
        "The text writes h . R p as a constant, A cos(theta) and B sin(theta). Compute the constant, A and B first.",
        "Then r and phi from A and B, and e from d and the constant. If |e| > r there is no solution: an empty list.",
        "phi is np.arctan2(B, A). The two solutions lie on either side of phi, both at the same distance from it.",
        "theta = phi + arccos(e / r) and theta = phi - arccos(e / r), with r = np.hypot(A, B).",
    ),
    forbidden=("course_lib.subproblems.subproblem4",),
)
