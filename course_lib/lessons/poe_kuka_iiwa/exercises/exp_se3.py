"""exp_se3: the pose reached by following a constant twist for unit time."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.exercise import Property
from course_lib.checks.kinds import Kind, coarse_axis, nearly_unit_omega, quarters, whole_numbers
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import BESIDE, SMALL, SMALL_NUMBERS
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import (
    LAST_ROW,
    X,
    Y,
    Z,
    away_from_zero,
    compared,
    first_off,
    unit,
)
from course_lib.lessons.poe_kuka_iiwa.exercises.shared import BLOCK, COLUMN
from course_lib.rigid import exp_se3
from course_lib.rotations import exp_so3, length

_GIVEN = 1e-5  # rad: below it the cell has the series
# Where somebody uses the series too far, or a formula that loses its digits, the error shows at one
# of these angles.
_SMALL_ANGLES = (*BESIDE, 9e-4, 4e-4, 1.1e-5, 1e-100, 1e-170)
_QUARTER, _STILL = np.pi / 2, np.zeros(3)


def _rotating(rng, angle):
    """Return a twist with this angle, and v with parts along omega and across."""
    n, along = unit(rng), rng.uniform(0.5, 1)
    across = np.cross(n, unit(rng) + 2 * np.eye(3)[np.argmin(np.abs(n))])
    return np.append(angle * n, across / np.linalg.norm(across) + along * n)


def _named(rng):
    pairs = [
        *((_QUARTER * Z, v) for v in (X, Y, Z)),
        (-_QUARTER * X, Z),
        (Z, np.array([1.0, 2, 3])),
        *((_QUARTER * axis, _STILL) for axis in (X, Y, Z)),
        (_QUARTER * X, Y),
        (_QUARTER * Y, Z),
        (-_QUARTER * Z, Y),
        # v is so large that the error of the series, a^2 / 6 of v, shows from 2.9e-4 rad on.
        (2.9e-4 * X, 1000 * Y),
        (2 * unit(rng), 50 * rng.normal(size=3)),
        (1e-9 * Z, X),
        *((_STILL, v) for v in (X, np.array([1.0, 2, 3]), _STILL)),
    ]
    whole = [np.array([0, 0, 1, 1, 2, 3]), np.array([-2, 1, 0, 0, 3, 1])]
    rotating = [_rotating(rng, angle) for angle in (0.5, 2.0, 5.0, 20.0, 200.0, np.pi)]
    return [*map(np.concatenate, pairs), *rotating, *whole]


TWIST = Kind(
    drawn=lambda rng: _rotating(rng, rng.uniform(0.5, 2.5)),
    named=_named,
    beside=(
        ("a small rotation", _rotating, _SMALL_ANGLES),
        ("nearly half a revolution", lambda rng, gap: _rotating(rng, np.pi - gap), BESIDE),
        ("nearly a revolution", lambda rng, gap: _rotating(rng, 2 * np.pi - gap), BESIDE),
        (
            "a small v",
            lambda rng, size: np.append(2 * unit(rng), size * away_from_zero(rng, 3)),
            SMALL_NUMBERS,
        ),
        ("an omega nearly of length one", nearly_unit_omega, SMALL),
    ),
    coarse=lambda rng: np.append(quarters(rng) * coarse_axis(rng), whole_numbers(rng, 3)),
)


def _angle(twist):
    return float(length(twist[:3]))


def _is_across(twist):
    """Return whether v is perpendicular to omega, in a twist that the given lines do not answer."""
    along = abs(twist[:3] @ twist[3:])
    return _angle(twist) >= _GIVEN and twist[3:].any() and along < 1e-12


def _off(T, twist):
    return np.abs(T[COLUMN] - exp_se3(twist)[COLUMN]).max()


def _found(T, twist):
    both = compared(exp_se3(twist)[COLUMN], T[COLUMN])
    return f"|omega| is {_angle(twist):.4g}. p should be " + both + "."


_PART_ALONG = Mistake(
    "the step of p along the axis is not the part of v along n",
    "The step of p across the axis is right. Print the part of v along n: which direction and "
    "which length does this vector have, and what becomes of it in p?",
)


def _p_across_is_right(T, twist):
    """Return whether p differs from the right one by a step along the axis alone."""
    off = T[COLUMN] - exp_se3(twist)[COLUMN]
    n = twist[:3] / _angle(twist)
    across = off - (n @ off) * n
    return np.abs(across).max() <= 10 * EXACT * max(1.0, np.abs(twist[3:]).max())


def _otherwise(T, twist):
    """Return the Mistake of a p that no known mistake explains: none if p is nearly right."""
    if _off(T, twist) <= 0.01 * np.abs(twist[3:]).max():
        return None
    if not _is_across(twist) and _p_across_is_right(T, twist):
        return _PART_ALONG
    return Question(
        "p is not where the origin arrives",
        "What does your formula give for twists along the same line, from a short omega to the one "
        "below? From which length on does p go wrong, and which term of p is it?",
        of_the_formula=True,
    )


def _p(along=1.0, forward=np.sin, sideways=lambda a: 1 - np.cos(a), bent=lambda v, part: v - part):
    """Return p with other factors; it raises for twists that the given lines answer."""

    def answer(twist):
        a, v = _students_angle(twist), twist[3:]
        n = twist[:3] / a
        part = (n @ v) * n
        return along * part + (forward(a) * bent(v, part) + sideways(a) * np.cross(n, v)) / a

    return answer


def _students_angle(twist):
    a = _angle(twist)
    if a < _GIVEN:
        raise ValueError("so small an angle is not the student's")
    return a


def _with_part(part_of):
    """Return p with part_of(n, v) for the part of v along n."""

    def answer(twist):
        a, v = _students_angle(twist), twist[3:]
        n = twist[:3] / a
        part = part_of(n, v)
        return part + (np.sin(a) * (v - part) + (1 - np.cos(a)) * np.cross(n, v)) / a

    return answer


def _wrapped(wrap):
    def answer(twist):
        a = _angle(twist)
        if a < 2 * np.pi:
            return None
        return _p()(np.append(wrap(a) * twist[:3] / a, twist[3:]))

    return answer


def _series_below(bound):
    def answer(twist):
        if _students_angle(twist) >= bound:
            raise ValueError("this angle is answered by the formula")
        return twist[3:] + np.cross(twist[:3], twist[3:]) / 2

    return answer


EXERCISE = declared(
    "exp_se3",
    points=3,
    arguments={"twist": TWIST},
    tolerance=10 * EXACT,
    library=exp_se3,
    scale=lambda twist: np.abs(twist[3:]).max(),
    says="p is where the origin arrives after unit time with the constant twist, T' = [V] T",
    found=_found,
    otherwise=_otherwise,
    properties=(
        LAST_ROW,
        Property(
            "the upper left 3x3 block is the rotation by |omega| about omega",
            lambda T, twist: np.abs(T[BLOCK] - exp_so3(twist[:3])).max() < 2 * EXACT,
            says=lambda T, twist: first_off(T[BLOCK], exp_so3(twist[:3])),
        ),
        Property(
            "p is at the end of an arc if v is perpendicular to omega",
            lambda T, twist: _off(T, twist) <= 10 * EXACT * max(1.0, np.abs(twist[3:]).max()),
            says=_found,
            where=_is_across,
            otherwise=_otherwise,
            points=1,
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
    mistakes=(
        Mistake(
            "p is v, or R v",
            "This is the velocity at the beginning, or at the end, of the motion. Which velocity "
            "does the origin have in between?",
            *(lambda twist, k=k: exp_so3(k * twist[:3]) @ twist[3:] for k in (0, 1, -1)),
            part=COLUMN,
        ),
        Mistake(
            "the number n @ v stands for the part of v along n",
            "Which vector along n has this length?",
            _with_part(lambda n, v: n @ v),
            part=COLUMN,
        ),
        Mistake(
            "the part of v along n does not have the direction of n",
            "Which vector gives this part its direction, and which number gives it its length?",
            _with_part(lambda n, v: (n @ v) * v),
            _with_part(lambda n, v: n * v),
            part=COLUMN,
        ),
        Mistake(
            "the part of v along n is bent into the arc as well",
            "Which part of v moves the origin straight along the axis?",
            _p(bent=lambda v, part: v),
            _p(along=0, bent=lambda v, part: v),
            part=COLUMN,
        ),
        Mistake(
            "omega stands for n in the part of p along n x v, or this part has another factor",
            "How long is n?",
            _p(sideways=lambda a: a * (1 - np.cos(a))),
            part=COLUMN,
        ),
        Mistake(
            "a factor in the formula of p is wrong, or a term is missing",
            "Compute the three terms of p on paper for a = pi / 2. Which of them differs from "
            "yours?",
            _p(forward=lambda a: a * np.sin(a)),
            _p(forward=lambda a: a * np.sin(a), sideways=lambda a: a * (1 - np.cos(a))),
            _p(along=0),
            _p(forward=lambda a: 0),
            _p(forward=lambda a: 1 - np.cos(a), sideways=np.sin),
            part=COLUMN,
        ),
        Mistake(
            "the step sideways, along n x v, is missing or has another sign",
            "To which side of v does a rotation about n bend the path of the origin?",
            _p(sideways=lambda a: 0),
            _p(sideways=lambda a: np.cos(a) - 1),
            _p(sideways=lambda a: 1 + np.cos(a)),
            part=COLUMN,
        ),
        Mistake(
            "p is left at zero",
            "The given lines fill in the rotation: where do you fill in p?",
            lambda twist: 0.0 * twist[3:] * _students_angle(twist),
            part=COLUMN,
        ),
        Mistake(
            "an angle beyond one revolution is wrapped, and v belongs to the whole angle",
            "How often does the origin go round its circle while omega rotates by 20 rad?",
            _wrapped(lambda a: a % (2 * np.pi)),
            _wrapped(lambda a: np.angle(np.exp(1j * a))),
            part=COLUMN,
        ),
        Mistake(
            "the first terms of the series stand for angles that are too large",
            "Up to which angle is the error of these terms less than the task allows, and with "
            "which number do the given lines compare a?",
            *map(_series_below, (5e-4, 2e-3, 2e-2, 0.2, 0.4)),
            part=COLUMN,
        ),
    ),
)
