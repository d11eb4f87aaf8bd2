"""exp_se3: the pose reached by following a constant twist for unit time."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.special_cases import BESIDE, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import LAST_ROW, X, Y, Z, first_off, unit
from course_lib.lessons.poe_kuka_iiwa.exercises.shared import BLOCK, COLUMN
from course_lib.rigid import exp_se3
from course_lib.rotations import exp_so3, hat, length

_NO_ANGLE, _GIVEN, _SMALL = 1e-100, 1e-5, 1e-3  # below _GIVEN the cell has the series
# Where somebody uses the series too far, or a formula that loses its digits, the error shows at one
# of these angles.
_SMALL_ANGLES = (*BESIDE, 9e-4, 4e-4, 1.1e-5, 1e-100, 1e-170)


def _cases(rng):
    still, quarter = np.zeros(3), np.pi / 2
    named = [
        (quarter * Z, X),
        (quarter * Z, Y),
        (quarter * Z, Z),
        (-quarter * X, Z),
        (Z, np.array([1.0, 2, 3])),
    ]
    named += [(quarter * axis, still) for axis in (X, Y, Z)]
    named += [(quarter * axis, other) for axis, other in ((X, Y), (Y, Z), (-Z, Y))]
    named += [_rotating(rng, angle) for angle in (0.5, 2.0, 5.0, 20.0, np.pi)]
    # v is so large that the error of the series, a^2 / 6 of v, shows from 2.9e-4 rad on.
    named += [(2.9e-4 * X, 1000 * Y), (2 * unit(rng), 50 * rng.normal(size=3)), (1e-9 * Z, X)]
    named += [(still, X), (still, np.array([1.0, 2, 3])), (still, still)]
    whole = [np.array([0, 0, 1, 1, 2, 3]), np.array([-2, 1, 0, 0, 3, 1])]
    return [(twist,) for twist in (*map(np.concatenate, named), *whole)]


def _rotating(rng, angle):
    """Return omega with this length, and v with parts along omega and across."""
    n, along = unit(rng), rng.uniform(0.5, 1)
    across = np.cross(n, unit(rng) + 2 * np.eye(3)[np.argmin(np.abs(n))])
    return angle * n, across / np.linalg.norm(across) + along * n


def _sweep(what, angle, values=BESIDE):
    return Sweep(what, lambda rng, x: (np.concatenate(_rotating(rng, angle(x))),), values)


def _angle(twist):
    return float(length(twist[:3]))


def _is_small(twist):
    return _NO_ANGLE < _angle(twist) < _SMALL


def _is_across(twist):
    """Return whether v is perpendicular to omega, in a twist that the given lines do not answer."""
    along = abs(twist[:3] @ twist[3:])
    return _angle(twist) >= _GIVEN and twist[3:].any() and along < 1e-12


def _p_is_right(T, twist):
    return np.abs(T[COLUMN] - exp_se3(twist)[COLUMN]).max() <= 10 * EXACT * max(
        1.0, np.abs(twist[3:]).max()
    )


def _p_off(T, twist):
    right = exp_se3(twist)[COLUMN]
    return (
        f"|omega| is {_angle(twist):.4g}. p should be {format_tuple(right)}; yours is "
        f"{format_tuple(T[COLUMN])}, off "
        f"by {np.abs(T[COLUMN] - right).max():.2g}."
    )


def _keeps_digits(T, twist):
    """Return whether the part of p along omega x v, which the rotation alone brings about, is right
    to two digits."""
    aside, right = np.cross(twist[:3] / _angle(twist), twist[3:]), exp_se3(twist)[COLUMN]
    allowed = 0.02 * abs(right @ aside) + 2e-15 * np.abs(twist[3:]).max() * np.linalg.norm(aside)
    return abs((T[COLUMN] - right) @ aside) <= allowed


def _p_mistake(T, twist):
    """Return what is said of a p that no known mistake explains: nothing if p is nearly right."""
    off = np.abs(T[COLUMN] - exp_se3(twist)[COLUMN]).max()
    return _NOT_THERE if off > 0.01 * np.abs(twist[3:]).max() else None


_NOT_THERE = Mistake(
    "p is not where the origin arrives",
    "Compute the three terms of p for the twist below by hand: the part of v along omega, the step "
    "along the arc, and the step to its side. Which of them differs from yours?",
)

EXERCISE = Exercise(
    name="exp_se3",
    points=3,
    arguments=("twist",),
    cases=_cases,
    returns=numbers(lambda twist: (4, 4)),
    library=exp_se3,
    tolerance=10 * EXACT,
    sweeps=(
        _sweep("a small rotation", lambda size: size, _SMALL_ANGLES),
        _sweep("nearly half a revolution", lambda gap: np.pi - gap),
        _sweep("nearly a revolution", lambda gap: 2 * np.pi - gap),
    ),
    properties=(
        LAST_ROW,
        Property(
            "the upper left 3x3 block is the rotation by |omega| about omega",
            lambda T, twist: np.abs(T[BLOCK] - exp_so3(twist[:3])).max() < 2 * EXACT,
            says=lambda T, twist: first_off(T[BLOCK], exp_so3(twist[:3])),
        ),
        Property(
            "p is at the end of an arc if v is perpendicular to omega",
            _p_is_right,
            says=_p_off,
            where=_is_across,
            mistake=_p_mistake,
            points=1,
        ),
        Property(
            "p is where the origin arrives after unit time with the constant twist, T' = [V] T",
            _p_is_right,
            says=_p_off,
            mistake=_p_mistake,
        ),
        Property(
            "a tiny rotation is a rotation too: R - I is [omega], to two digits",
            lambda T, twist: (
                np.abs(T[BLOCK] - np.eye(3) - hat(twist[:3])).max() <= 0.02 * _angle(twist)
            ),
            says=lambda T, twist: f"|omega| is {_angle(twist):.3g}.",
            where=_is_small,
        ),
        Property(
            "the part of p along omega x v, small as it is, is right to two digits",
            _keeps_digits,
            says=_p_off,
            where=_is_small,
        ),
    ),
    hints=(
        "a is the length of omega, and n = omega / a. The part of v along n is a vector; the part "
        "across is the rest.",
        "Which of the two parts does the rotation bend into an arc? How far does that lead along "
        "it, how far sideways?",
        "along = (n @ v) * n, across = v - along, p = along + sin(a)/a * across + (1 - cos(a))/a * "
        "np.cross(n, v).",
    ),
    forbidden=("course_lib.rigid.exp_se3",),
)


def _p(
    twist, along=1.0, forward=np.sin, sideways=lambda a: 1 - np.cos(a), across=True, number=False
):
    """Return p with other factors; raises for twists that the given lines answer."""
    a, v = _angle(twist), twist[3:]
    if a < _GIVEN:
        raise ValueError("so small an angle is not the student's")
    n = twist[:3] / a
    part = n @ v if number else (n @ v) * n
    return along * part + (forward(a) * (v - across * part) + sideways(a) * np.cross(n, v)) / a


@EXERCISE.mistake(
    "p is v, or R v",
    "This is the velocity at the beginning, or at the end, of the motion. Which velocity does the "
    "origin have in between?",
    part=COLUMN,
    rotated=(0, 1, -1),
)
def p_is_v(twist, rotated):
    return exp_so3(rotated * twist[:3]) @ twist[3:]


@EXERCISE.mistake(
    "the number n @ v stands for the part of v along n",
    "Which vector along n has this length?",
    part=COLUMN,
)
def number_for_the_part_along_the_axis(twist):
    return _p(twist, number=True)


@EXERCISE.mistake(
    "the part of v along n is bent into the arc as well",
    "Which part of v moves the origin straight along the axis?",
    part=COLUMN,
)
def all_of_v_on_the_arc(twist):
    return _p(twist, across=False)


@EXERCISE.mistake(
    "omega stands for n in the part of p along n x v, or this part has another factor",
    "How long is n?",
    part=COLUMN,
)
def omega_for_n(twist):
    return _p(twist, sideways=lambda a: a * (1 - np.cos(a)))


@EXERCISE.mistake(
    "a factor in the formula of p is wrong, or a term is missing",
    "Compute the three terms of p on paper for a = pi / 2. Which of them differs from yours?",
    part=COLUMN,
    factors=(
        {"forward": lambda a: a * np.sin(a)},
        {"forward": lambda a: a * np.sin(a), "sideways": lambda a: a * (1 - np.cos(a))},
        {"along": 0},
        {"forward": lambda a: 0},
        {"forward": lambda a: 1 - np.cos(a), "sideways": np.sin},
    ),
)
def factor_of_p(twist, factors):
    return _p(twist, **factors)


@EXERCISE.mistake(
    "the step sideways, along n x v, is missing or has another sign",
    "To which side of v does a rotation about n bend the path of the origin?",
    part=COLUMN,
    sideways=(lambda a: 0, lambda a: np.cos(a) - 1, lambda a: 1 + np.cos(a)),
)
def sideways_term(twist, sideways):
    return _p(twist, sideways=sideways)


@EXERCISE.mistake(
    "p is left at zero",
    "The given lines fill in the rotation: where do you fill in p?",
    part=COLUMN,
)
def p_not_written(twist):
    if _angle(twist) < _GIVEN:
        raise ValueError("so small an angle is not the student's")
    return np.zeros(3)


@EXERCISE.mistake(
    "an angle beyond one revolution is wrapped, and v belongs to the whole angle",
    "How often does the origin go round its circle while omega rotates by 20 rad?",
    part=COLUMN,
    wrap=(lambda a: a % (2 * np.pi), lambda a: np.angle(np.exp(1j * a))),
)
def angle_wrapped(twist, wrap):
    a = _angle(twist)
    if a < 2 * np.pi:
        return None
    wrapped = abs(float(wrap(a)))
    n = np.sign(wrap(a)) * twist[:3] / a
    return _p(np.concatenate([wrapped * n, twist[3:]]))


@EXERCISE.mistake(
    "the first terms of the series stand for angles that are too large",
    "Up to which angle is the error of these terms less than the task allows, and with which "
    "number "
    "do the given lines compare a?",
    part=COLUMN,
    below=(5e-4, 2e-3, 2e-2, 0.2, 0.4),
)
def series_too_far(twist, below):
    if not _GIVEN <= _angle(twist) < below:
        raise ValueError("this angle is answered by the formula, or by the given lines")
    return twist[3:] + np.cross(twist[:3], twist[3:]) / 2
