"""ik_2r: both pairs of joint angles that bring the tip of a planar arm with two links of one metre
to a position."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.format_numbers import ORDINALS, format_tuple
from course_lib.checks.kinds import tip_on_the_grid
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import BESIDE, SMALL, Sweep
from course_lib.checks.tolerances import EXACT, PREDICTED, SIX_DIGITS
from course_lib.checks.vocabulary import compared, other_bend, two_link_angles, two_link_tip

_EDGE = 2 - 1e-3  # metres: from here on a position is near the edge
_REACH = 2 + 1e-12  # metres: where rounding may take a position that is 2 m from the base
_OUT = 2 + SIX_DIGITS  # metres: from _REACH up to here the task accepts either answer
_FOLDED = 0.01  # metres: nearer to the base, arccos loses digits, as it does near the edge

# Metres from the edge, or from the base, where the arm is nearly stretched, or nearly folded.
_JUST_OUT_OF_REACH = tuple(gap for gap in BESIDE if gap > 2 * SIX_DIGITS)
_JUST_WITHIN = tuple(gap for gap in BESIDE if gap > 1e-12)
_NEARLY_FOLDED = tuple(gap for gap in BESIDE if gap > SIX_DIGITS)

_NO_ROWS = Mistake(
    "the answer for a position out of reach has another shape",
    "Every answer has the shape (2, 2). Which four values does the task ask for here?",
)
_DIVIDED = Mistake(
    "y is divided by x, which may be 0", "Which function takes y and x without dividing them?"
)
_NO_COSINE = Mistake(
    "arccos gets a number outside [-1, 1], because the position is out of reach or because of "
    "rounding at the edge",
    "Which positions have no solution? What is your cosine for xy = [np.nextafter(2, 3), 0], which "
    "lies at 2 m to rounding?",
)


_NEARLY_STRETCHED = 2e-3  # rad: rounding by 1e-6 m at the edge changes q2 by the root of this


def _cases(rng):
    named = [[1.0, 1.0], [0.0, 1.0], [-1.0, 0.0], [0.0, -1.2], [1.6, 0.0]]
    angles = np.array([0.3, 1.2, 2.0, 2.8, 3.5, 4.4, 5.0, 6.0]) + rng.uniform(-0.2, 0.2, 8)
    sizes = np.concatenate([rng.uniform(0.2, 1.3, 4), rng.uniform(1.5, 1.95, 4)])[
        [0, 4, 1, 5, 6, 2, 7, 3]
    ]
    within = [np.round(r * _direction(a), 3) for r, a in zip(sizes, angles, strict=True)]
    beyond = 2 + 1e-14  # to rounding, on every processor
    edge = [[2.0, 0], [0, -2.0], [beyond, 0], [0, beyond], [-beyond, 0], [1.9999, 0.0]]
    edge += [2 * _direction(a) for a in rng.uniform(-3, 3, 6)]
    far = [[3.0, 0], [0, -2.5], [1.6, 1.6], [-2.001, 0]]
    far += [r * _direction(a) for r, a in rng.uniform(2.1, 6, (3, 2))]
    middle = [[0.0, 0.0], [0.01, -0.02]]
    whole = [np.array([1, 1]), np.array([0, -1]), np.array([-1, 1]), np.array([3, 0])]
    return [(np.array(xy),) for xy in [*named, *within, *middle, *edge, *far, *whole]]


def _special(rng):
    """A position on a coarse grid, or at the edge; None if it is nearly at the base."""
    xy = tip_on_the_grid(rng)
    return None if 0 < np.linalg.norm(xy) < _FOLDED else (xy,)


def _at(radius):
    """Return the case(rng, gap) of a position at the distance radius(gap) from the base."""
    return lambda rng, gap: (radius(gap) * _direction(rng.uniform(-3, 3)),)


def _direction(angle):
    return np.array([np.cos(angle), np.sin(angle)])


def _inside(xy):
    return np.linalg.norm(xy) < _EDGE


def _outside(xy):
    return np.linalg.norm(xy) > _OUT


def _at_edge(xy):
    return _EDGE <= np.linalg.norm(xy) <= _REACH


def _reaches(q, xy):
    """Return whether both rows lead to xy, to as many digits as arccos has there."""
    within = EXACT if _FOLDED < np.linalg.norm(xy) < _EDGE else SIX_DIGITS
    return (np.linalg.norm(two_link_tip(q) - xy, axis=-1) < within).all()


def _in_order(q, xy):
    """Whether the row with q2 >= 0 is the first; at q2 = pi the sign has no meaning."""
    bend = np.angle(np.exp(1j * q[:, 1]))
    slack = _NEARLY_STRETCHED if _at_edge(xy) else 0
    folded = (np.abs(bend) > np.pi - SIX_DIGITS).all()
    return folded or (bend[0] >= -slack and bend[1] <= slack)


def _tell_tip(q, xy):
    if np.isnan(q).any():
        return (
            f"The position xy = {xy.tolist()} is {float(np.linalg.norm(xy))} m from the base. Your "
            f"answer holds NaN."
        )
    row = int(np.argmax(np.linalg.norm(two_link_tip(q) - xy, axis=-1)))
    tip = two_link_tip(q[row])
    return f"With your {ORDINALS[row]} row the tip should be at " + compared(xy, tip) + "."


def _alike(q, predicted, xy):
    """Whether the angles are the same up to multiples of 2 pi, and NaN stands at the same
    places."""
    gap = np.abs(np.angle(np.exp(1j * (q - predicted))))
    same_gaps = np.array_equal(np.isnan(q), np.isnan(predicted))
    return same_gaps and np.nanmax(gap, initial=0) < PREDICTED


def ik_2r(xy):
    """Return both solutions (..., 2, 2) for positions (..., 2), q2 >= 0 first; NaN out of reach."""
    xy = np.asarray(xy, float)
    in_reach = np.linalg.norm(xy, axis=-1) <= _REACH
    return np.where(in_reach[..., None, None], two_link_angles(xy), np.nan)


EXERCISE = Exercise(
    name="ik_2r",
    points=2,
    arguments=("xy",),
    cases=_cases,
    returns=numbers(lambda xy: (2, 2), gaps=True),
    library=ik_2r,
    tolerance=EXACT,
    special=_special,
    sweeps=(
        Sweep("just out of reach", _at(lambda gap: 2 + gap), _JUST_OUT_OF_REACH),
        Sweep("nearly stretched", _at(lambda gap: 2 - gap), _JUST_WITHIN),
        Sweep("nearly folded", _at(lambda gap: gap), _NEARLY_FOLDED),
        Sweep("near an axis", lambda rng, y: (np.array([rng.uniform(0.5, 1.5), y]),), SMALL),
        Sweep("a small q1", lambda rng, q1: (two_link_tip([q1, rng.uniform(0.8, 1.8)]),), SMALL),
    ),
    alike=_alike,
    properties=(
        Property(
            "each row brings the tip to xy",
            _reaches,
            _tell_tip,
            where=_inside,
            otherwise=other_bend,
        ),
        Property(
            "the first row has q2 >= 0, the second q2 <= 0",
            _in_order,
            lambda q, xy: (
                f"Your q2 are {format_tuple(np.angle(np.exp(1j * q[:, 1])))}, up to multiples of 2 "
                f"pi."
            ),
            where=_inside,
        ),
        Property(
            "the tip reaches xy near the edge of the workspace too, where the arm is nearly "
            "stretched",
            lambda q, xy: _reaches(q, xy) and _in_order(q, xy),
            _tell_tip,
            where=_at_edge,
            otherwise=Question(
                "a position near the edge of the workspace gets the answer of the stretched arm",
                "By which angle is the elbow bent at this position, and which of your lines "
                "computes that angle?",
            ),
        ),
        Property(
            "a position out of reach, farther than 2 m from the base, has two rows of NaN",
            lambda q, xy: np.isnan(q).all(),
            lambda q, xy: f"This position lies {np.linalg.norm(xy) - 2:.3g} m beyond 2 m.",
            where=_outside,
            otherwise=Question(
                "a position out of reach has an answer",
                "How far beyond 2 m may rounding take a position, according to the task? Which "
                "line of yours decides what a position beyond that gets?",
            ),
        ),
    ),
    hints=(
        "r^2 = x^2 + y^2 = 2 + 2 cos q2 gives cos q2, and arccos gives q2 >= 0; -q2 is the other "
        "one.",
        "The direction to the position, np.arctan2(y, x), halves the angle q2 between the links: "
        "q1 is half of q2 "
        "less, for each of the two q2.",
        "Out of reach is r > 2: return np.full((2, 2), np.nan). By rounding, r may be 2 + 4e-16 at "
        "the edge "
        "and arccos's argument may leave [-1, 1]: let r > 2 + 1e-9 be out of reach, and np.clip "
        "before arccos.",
    ),
    forbidden=("course_lib.arms.SerialArm", "course_lib.arms.planar_arm", "course_lib.ik.solve"),
)

EXERCISE.mistake(_NO_ROWS, form=lambda array, xy: _outside(xy))
EXERCISE.mistake(_DIVIDED, raises=("ZeroDivisionError", ""))
EXERCISE.mistake(_NO_COSINE, raises=("ValueError", "math domain error"))
EXERCISE.mistake(_NO_COSINE, raises=("ValueError", "expected a number in range"))


@EXERCISE.mistake(
    "positions at the edge of the workspace count as out of reach",
    "Which distance from the base does your code compare with 2, and may it be exactly 2? May "
    "rounding make the cosine exceed 1?",
    recognises=True,
)
def edge_out_of_reach(q, xy):
    return _at_edge(xy) and np.isnan(q).any()


@EXERCISE.mistake(
    "a position near the edge of the workspace gets the answer of the stretched arm",
    "By which angle is the elbow bent at this position, and which of your lines computes "
    "that angle?",
    recognises=True,
)
def stretched_too_early(q, xy):
    return 1.5 < np.linalg.norm(xy) < 2 and not np.isnan(q).any() and not q[:, 1].any()


@EXERCISE.mistake(
    "the angle between the first link and the direction to the tip has another size or sign",
    "Which angles of the triangle of both links are equal, and what is their sum?",
    factor=(1, 0.5, -0.5),
)
def another_half(xy, factor):
    return np.column_stack([ik_2r(xy)[:, 0] + factor * ik_2r(xy)[:, 1], ik_2r(xy)[:, 1]])


@EXERCISE.mistake(
    "q2 is the angle inside the triangle",
    "What is q2 of a stretched arm?",
    q1=(lambda q, q2: q[:, 0], lambda q, q2: q.sum(1) - q[:, 1] / 2 - q2 / 2),
)
def inner_angle(xy, q1):
    q = ik_2r(xy)
    q2 = np.sign(q[:, 1]) * np.pi - q[:, 1]
    return np.column_stack([q1(q, q2), q2])
