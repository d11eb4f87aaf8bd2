"""exp_se3: the pose reached by following a constant twist for unit time."""

import numpy as np

from course_lib.checks.answer_types import NOT_A_NUMBER, numbers
from course_lib.checks.exercise import Exercise, Mistake, Property, Unreadable
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.poe_kuka_iiwa.exp_se3_mistakes import MISTAKES
from course_lib.checks.exercises.poe_kuka_iiwa.shared import BLOCK, COLUMN, worst_column
from course_lib.checks.vocabulary import FINE, unit
from course_lib.rigid import exp_se3
from course_lib.rotations import exp_so3, hat, length

_NO_FACTOR_V = Mistake(
    "the factor v is missing",
    "I a + (1 - cos a) [n] + (a - sin a) [n]^2 is a matrix. p is a vector: what is the matrix multiplied by?",
)
_NO_LENGTH = Mistake(
    "something is divided by zero: for omega = 0 there is no axis",
    "Treat omega = 0 before you divide: what is the motion then?",
)
_UNDERFLOW = Mistake(
    "the length of omega, or a power of it, comes out as 0, and something is divided by it: |omega| is 1e-170 here",
    "The square of 1e-170 is 0 for a computer. Compare what you divide by with 0, not omega.",
)
_LOST = Mistake(
    "the part of p along omega x v is lost for tiny angles",
    "1 - cos(a) is rounded to 0 for a below 1e-8. Use terms of the series for small a, or 1 - cos(a) = 2 sin(a/2)^2.",
)
_TINY = 1e-100
_matrix = numbers(lambda: (4, 4), dict.fromkeys(((4, 6), (3, 6), (3, 3)), _NO_FACTOR_V))


def _cases(rng):
    x, y, z = np.eye(3)
    still, quarter, n = np.zeros(3), np.pi / 2, unit(rng)
    named = [(quarter * z, x), (quarter * z, y), (quarter * z, z), (-quarter * x, z), (z, np.array([1.0, 2, 3]))]
    named += [(quarter * axis, still) for axis in (x, y, z)]
    for angle in (0.5, 2.0, 5.0, 20.0, np.pi - 3e-4, np.pi, 3e-4, 1e-5, 1e-9, 1e-12):
        n, along = unit(rng), rng.uniform(0.5, 1)
        across = np.cross(n, unit(rng) + 2 * np.eye(3)[np.argmin(np.abs(n))])
        named.append((angle * n, across / np.linalg.norm(across) + along * n))
    named += [(2 * unit(rng), 50 * rng.normal(size=3)), (1e-9 * z, x)]
    named += [(still, x), (still, np.array([1.0, 2, 3])), (1e-170 * n, n + 1), (still, still)]
    return [(np.concatenate(twist),) for twist in named]


def _angle(twist):
    return float(length(twist[:3]))


def _no_rotation(twist):
    return _angle(twist) < _TINY


def _pose(value, twist):
    """The answer as a matrix; what is no number has its reason in this twist."""
    try:
        return _matrix(value)
    except Unreadable as wrong:
        if wrong.mistake is NOT_A_NUMBER and _no_rotation(twist):
            raise Unreadable(str(wrong), _UNDERFLOW if twist[:3].any() else _NO_LENGTH) from None
        raise


def _right_p(twist):
    return exp_se3(twist)[COLUMN]


def _p_is_right(T, twist):
    return np.abs(T[COLUMN] - _right_p(twist)).max() <= FINE * max(1.0, np.abs(twist[3:]).max())


def _p_seen(T, twist):
    right, p = _right_p(twist), T[COLUMN]
    off = np.abs(p - right).max()
    return (
        f"|omega| is {_angle(twist):.4g}. p should be {format_tuple(right)}; yours is {format_tuple(p)}, off "
        f"by {off:.2g}."
    )


def _across(p, twist):
    """The part of p along omega x v, which the rotation alone brings about."""
    aside = np.cross(twist[:3] / _angle(twist), twist[3:])
    return float(p @ aside) / max(np.linalg.norm(aside), 1e-300)


def _keeps_digits(T, twist):
    right = _across(_right_p(twist), twist)
    return abs(_across(T[COLUMN], twist) - right) <= 0.02 * abs(right) + 2e-15 * np.abs(twist[3:]).max()


def _digits_seen(T, twist):
    right, yours = _across(_right_p(twist), twist), _across(T[COLUMN], twist)
    return f"|omega| is {_angle(twist):.3g}. That part should be {right:.4g}; yours is {yours:.4g}."


EXERCISE = Exercise(
    name="exp_se3",
    points=3,
    arguments=("twist",),
    cases=_cases,
    returns=_pose,
    properties=(
        Property(
            "the last row is (0, 0, 0, 1)",
            lambda T, twist: np.abs(T[3] - np.eye(4)[3]).max() < FINE,
            says=lambda T, twist: f"Yours is {format_tuple(T[3])}.",
        ),
        Property(
            "the upper left 3x3 block is the rotation by |omega| about omega",
            lambda T, twist: np.abs(T[BLOCK] - exp_so3(twist[:3])).max() < 2 * FINE,
            says=worst_column(lambda T: T[BLOCK], lambda twist: exp_so3(twist[:3])),
            points=1,
        ),
        Property(
            "for v = 0 the origin stays where it is: p = 0",
            lambda T, twist: np.abs(T[COLUMN]).max() < FINE,
            says=lambda T, twist: f"Your p is {format_tuple(T[COLUMN])}.",
            where=lambda twist: not twist[3:].any(),
            mistake=_NO_FACTOR_V,
        ),
        Property(
            "p is where the origin arrives after unit time, with v fixed in the rotating body",
            _p_is_right,
            says=_p_seen,
            where=lambda twist: not _no_rotation(twist),
        ),
        Property(
            "without a rotation, omega = 0, the motion is a translation by v: R = I and p = v",
            _p_is_right,
            says=_p_seen,
            where=_no_rotation,
            mistake=Mistake("the branch for omega = 0 is wrong", "What is the motion if nothing rotates?"),
        ),
        Property(
            "a tiny rotation is none the less there: R - I is [omega], to two digits",
            lambda T, twist: np.abs(T[BLOCK] - np.eye(3) - hat(twist[:3])).max() <= 0.02 * _angle(twist),
            says=lambda T, twist: f"|omega| is {_angle(twist):.3g}.",
            where=lambda twist: _TINY < _angle(twist) < 1e-3,
            mistake=Mistake("tiny rotations are cut off", "An angle of 1e-9 is small, not 0."),
        ),
        Property(
            "the part of p along omega x v, small as it is, is right to two digits",
            _keeps_digits,
            says=_digits_seen,
            where=lambda twist: 0 < _angle(twist) < 1e-3 and not _no_rotation(twist),
            mistake=_LOST,
        ),
    ),
    mistakes=MISTAKES,
    hints=(
        "omega and v are the halves of the twist; a is the length of omega, n = omega / a, N = hat(n).",
        "For a = 0 there is no axis to divide by: treat it first. For a small a, say below 1e-5, use the first "
        "terms of "
        "the series: R = I + [omega] + ... and p = v + (omega x v) / 2 + ...",
        "For all other a: R by Rodrigues' formula, and p is (I a + (1 - cos a) N + (a - sin a) N N) times v / a.",
    ),
    library=exp_se3,
    forbidden=("course_lib.rigid.exp_se3",),
)
