"""exp_se3: the pose reached by following a constant twist for unit time."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.poe_kuka_iiwa.shared import BLOCK, COLUMN
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.vocabulary import FINE, LAST_ROW, X, Y, Z, first_off, unit
from course_lib.rigid import exp_se3
from course_lib.rotations import exp_so3, hat, length

_NO_LENGTH = Mistake("something is divided by zero: for omega = 0 there is no axis", "What is the motion then?")
_UNDERFLOW = Mistake(
    "something is divided by the length of omega, or a power of it, which comes out as 0: |omega| is 1e-170 here",
    "The square of 1e-170 is 0 for a computer. Do you compare omega with 0, or what you divide by?",
)
_NO_ANGLE, _SMALL = 1e-100, 1e-3


def _cases(rng):
    still, quarter = np.zeros(3), np.pi / 2
    named = [(quarter * Z, X), (quarter * Z, Y), (quarter * Z, Z), (-quarter * X, Z), (Z, np.array([1.0, 2, 3]))]
    named += [(quarter * axis, still) for axis in (X, Y, Z)]
    for angle in (0.5, 2.0, 5.0, 20.0, np.pi - 3e-4, np.pi, 9e-4, 1e-5, 1.2e-8, 1e-9, 1e-12):
        n, along = unit(rng), rng.uniform(0.5, 1)
        across = np.cross(n, unit(rng) + 2 * np.eye(3)[np.argmin(np.abs(n))])
        named.append((angle * n, across / np.linalg.norm(across) + along * n))
    named += [(2 * unit(rng), 50 * rng.normal(size=3)), (1e-9 * Z, X)]
    named += [(still, X), (still, np.array([1.0, 2, 3])), (1e-170 * n, n + 1), (still, still)]
    return [(np.concatenate(twist),) for twist in named]


def _angle(twist):
    return float(length(twist[:3]))


def _is_small(twist):
    return _NO_ANGLE < _angle(twist) < _SMALL


def _divides_by_nothing(twist):
    return None if _angle(twist) > _NO_ANGLE else _UNDERFLOW if twist[:3].any() else _NO_LENGTH


def _p_is_right(T, twist):
    return np.abs(T[COLUMN] - exp_se3(twist)[COLUMN]).max() <= 10 * FINE * max(1.0, np.abs(twist[3:]).max())


def _p_off(T, twist):
    right = exp_se3(twist)[COLUMN]
    return (
        f"|omega| is {_angle(twist):.4g}. p should be {format_tuple(right)}; yours is {format_tuple(T[COLUMN])}, off "
        f"by {np.abs(T[COLUMN] - right).max():.2g}."
    )


def _across(T, twist):
    """Return the part of p along omega x v, which the rotation alone brings about; and what it should be."""
    aside = np.cross(twist[:3] / _angle(twist), twist[3:])
    return tuple(float(pose[COLUMN] @ aside) / max(np.linalg.norm(aside), 1e-300) for pose in (T, exp_se3(twist)))


def _keeps_digits(T, twist):
    yours, right = _across(T, twist)
    return abs(yours - right) <= 0.02 * abs(right) + 2e-15 * np.abs(twist[3:]).max()


_TOO_EARLY = Mistake(
    "a formula for small angles is used too early, or has too few terms",
    "Below which angle does it hold to nine digits, and is R - I then [omega]?",
)
_OTHER_ROTATION = Mistake("the block is another rotation than that by |omega| about omega", "How long is omega?")

EXERCISE = Exercise(
    name="exp_se3",
    points=3,
    arguments=("twist",),
    cases=_cases,
    returns=numbers(lambda twist: (4, 4), nan=_divides_by_nothing),
    library=exp_se3,
    properties=(
        LAST_ROW,
        Property(
            "the upper left 3x3 block is the rotation by |omega| about omega",
            lambda T, twist: np.abs(T[BLOCK] - exp_so3(twist[:3])).max() < 2 * FINE,
            says=lambda T, twist: first_off(T[BLOCK], exp_so3(twist[:3])),
            mistake=lambda T, twist: _TOO_EARLY if _angle(twist) < 0.1 else _OTHER_ROTATION,
            points=1,
        ),
        Property(
            "for v = 0 the origin stays where it is: p = 0",
            lambda T, twist: np.abs(T[COLUMN]).max() < FINE,
            where=lambda twist: not twist[3:].any(),
        ),
        Property(
            "p is where the origin arrives after unit time, with v fixed in the rotating body",
            _p_is_right,
            says=_p_off,
            where=lambda twist: _angle(twist) > _NO_ANGLE,
            mistake=Mistake(
                "p is not where the origin arrives",
                "The part of v along omega moves the origin all the way, the rest along an arc. Which term is which?",
            ),
        ),
        Property(
            "without a rotation, omega = 0, the motion is a translation by v: R = I and p = v",
            _p_is_right,
            says=_p_off,
            mistake=Mistake("the branch for omega = 0 is wrong", "What is the motion if nothing rotates?"),
        ),
        Property(
            "a tiny rotation is none the less there: R - I is [omega], to two digits",
            lambda T, twist: np.abs(T[BLOCK] - np.eye(3) - hat(twist[:3])).max() <= 0.02 * _angle(twist),
            says=lambda T, twist: f"|omega| is {_angle(twist):.3g}.",
            where=_is_small,
        ),
        Property(
            "the part of p along omega x v, small as it is, is right to two digits",
            _keeps_digits,
            says=lambda T, twist: "|omega| is {:.3g}. Yours is {:.4g}; it should be {:.4g}.".format(
                _angle(twist), *_across(T, twist)
            ),
            where=_is_small,
        ),
    ),
    hints=(
        "omega and v are the halves of the twist; a is the length of omega, n = omega / a, N = hat(n).",
        "For a = 0 there is no axis to divide by: treat it first. For a small a, say below 1e-5, use the first "
        "terms of the series: R = I + [omega] + ... and p = v + (omega x v) / 2 + ...",
        "For all other a: R by Rodrigues' formula, and p is (I a + (1 - cos a) N + (a - sin a) N N) times v / a.",
    ),
    forbidden=("course_lib.rigid.exp_se3",),
)


def _versine(a):
    return 1 - np.cos(a)


def _lag(a):
    return a - np.sin(a)


def _axis(twist):
    """Return a and [n]; raises for twists without a rotation, of which the formulas say nothing."""
    a = _angle(twist)
    if a < _NO_ANGLE:
        raise ZeroDivisionError
    return a, hat(twist[:3] / a)


def _p(a, N, v, straight=lambda a: a, first=_versine, second=_lag, power=1):
    return (straight(a) * np.eye(3) + first(a) * N + second(a) * N @ N) @ v / a**power


@EXERCISE.mistake(part=BLOCK, below=(_SMALL, 2e-5, 1e-7))
def tiny_rotations_cut_off(twist, below):
    """tiny rotations are cut off. An angle of 1e-9 is small, not 0: which is the first term of the series after I?"""
    return np.eye(3) if _NO_ANGLE < _angle(twist) < below else None


@EXERCISE.mistake(part=COLUMN, rotated=(0, 1, -1))
def p_is_v(twist, rotated):
    """p is v, or R v. That is the velocity at the beginning, or at the end, of the motion: what is it on the way?"""
    return exp_so3(rotated * twist[:3]) @ twist[3:]


@EXERCISE.mistake(
    part=COLUMN,
    factors=(
        {"power": 0},
        {"straight": lambda a: 1},
        {"first": lambda a: np.cos(a) - 1},
        {"first": np.sin, "second": _versine},
        {"second": lambda a: 0},
        {"second": lambda a: np.sin(a) - a},
        {"first": lambda a: a * _versine(a), "second": lambda a: a * a * _lag(a)},  # with [omega] in place of [n]
    ),
)
def factor_of_p(twist, factors):
    """a factor in the formula of p is wrong, or a term is missing. As a goes to 0, p goes to v: is that so in yours?"""
    return _p(*_axis(twist), twist[3:], **factors)


@EXERCISE.mistake(part=COLUMN, factor=(1, -0.5, -1))
def second_term(twist, factor):
    """for tiny angles the term omega x v / 2 has the wrong sign or factor. Which of the two vectors comes first?"""
    return twist[3:] + factor * np.cross(twist[:3], twist[3:]) if _NO_ANGLE < _angle(twist) < 5e-6 else None


@EXERCISE.seen
def digits_lost(T, twist):
    """the part of p along omega x v is lost, or loses its digits, for tiny angles. What is 1 - cos(a) for a computer if
    a is 1e-8?"""
    yours, right = _across(T, twist)
    return _is_small(twist) and not _keeps_digits(T, twist) and -0.4 < yours / right < 1.9
