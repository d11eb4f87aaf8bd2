"""two_link_angles: the inverse kinematics of the arm with two links of one metre, both elbows.

The two pairs may stand in either order, so its properties ask where each of them brings the tip.
"""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Property
from course_lib.checks.format_numbers import ORDINALS
from course_lib.checks.kinds import tip_on_the_grid
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import BESIDE, SMALL_NUMBERS, Sweep
from course_lib.checks.tolerances import EXACT, HALF_THE_DIGITS
from course_lib.checks.vocabulary import (
    angle_gap,
    compared,
    distance_of_lists,
    other_bend,
    same_list,
    two_link_angles,
    two_link_tip,
)

_ABOVE_ONE = Mistake(
    "the answer holds nan for a tip at the edge of the reach",
    "Which line makes the nan for this tip? Rounding may make a cosine larger than 1 there: what "
    "does arccos, or the root of 1 - cosine^2, make of it?",
)
_ONE = Mistake(
    "only one elbow is returned",
    "There are two solutions, one with a positive theta2 and one with a negative theta2.",
)


def _cases(rng):
    ordinary = [[1.0, 1.0], [1.8, 0.4], [-1.0, 1.0], [-0.5, -1.2], [0.3, -0.4]]
    radii, angles = rng.uniform(0.3, 1.8, 4), rng.uniform(-np.pi, np.pi, 4)
    drawn = np.round(np.stack([radii * np.cos(angles), radii * np.sin(angles)], 1), 2)
    beyond = 2 + 1e-14  # by rounding, as tips are that a program has computed
    edge = [[1.2, 1.595], [2.0, 0.0], [0.0, -2.0], [beyond, 0.0], [0.0, beyond], [-beyond, 0.0]]
    return [(np.array(tip, float),) for tip in [*ordinary, *drawn, [0.0, 1.0], [1, 0], *edge]]


def _nearly_stretched(rng, gap):
    angle = rng.uniform(-np.pi, np.pi)
    return ((2 - gap) * np.array([np.cos(angle), np.sin(angle)]),)


# Metres from the base, where the arm is nearly folded. Nearer, an error of 1e-7 m is no error.
_NEARLY_FOLDED = tuple(gap for gap in BESIDE if gap > HALF_THE_DIGITS)


def _nearly_folded(rng, gap):
    angle = rng.uniform(-np.pi, np.pi)
    return (gap * np.array([np.cos(angle), np.sin(angle)]),)


def _near_an_axis(rng, size):
    """A tip one coordinate of which is nearly 0."""
    tip = [rng.uniform(0.5, 1.5), size]
    return (rng.choice([-1, 1], 2) * rng.permutation(tip),)


def _bend(tip):
    return np.arccos(np.clip((tip[0] ** 2 + tip[1] ** 2 - 2) / 2, -1, 1))


def _off(angles, tip):
    return np.abs(two_link_tip(angles) - tip).max(-1)


def _straight(tip):
    return np.hypot(*tip) > 2 - 1e-9


def _is_within_reach(tip):
    """Return whether a tip is neither out of reach nor nearly at the base."""
    return _NEARLY_FOLDED[0] < np.hypot(*tip) < 2 + EXACT


def _where_the_rows_lead(angles, tip):
    row = int(np.argmax(_off(angles, tip)))
    reached = two_link_tip(angles[row])
    return (
        f"The tip of the arm of your {ORDINALS[row]} row should be " + compared(tip, reached) + "."
    )


EXERCISE = Exercise(
    name="two_link_angles",
    points=3,
    arguments=("tip",),
    tolerance=HALF_THE_DIGITS,
    cases=_cases,
    special=lambda rng: (tip_on_the_grid(rng),),
    admits=_is_within_reach,
    returns=numbers(lambda tip: (2, 2)),
    properties=(
        Property(
            "with the angles of either row the arm's tip is at `tip`",
            lambda angles, tip: _off(angles, tip).max() < HALF_THE_DIGITS,
            says=_where_the_rows_lead,
            otherwise=other_bend,
            points=1,
        ),
        Property(
            "the two rows are different solutions: the elbow is bent to one side and to the other",
            lambda angles, tip: angle_gap(*angles) > angle_gap(*two_link_angles(tip)) / 2,
            where=lambda tip: not _straight(tip),
            otherwise=Question(
                "the same elbow is returned twice",
                "For this tip there are two solutions, with theta2 of either sign, as everywhere "
                "within the reach. Which line gives the theta2 of each row its sign and size?",
            ),
        ),
    ),
    library=two_link_angles,
    hints=(
        "Base, elbow and tip form a triangle with two sides of 1 m. The law of cosines, with the "
        "squared distance "
        "x^2 + y^2 = 2 + 2 cos(theta2), gives the cosine of theta2, and so theta2 up to its sign.",
        "Seen from the first link, the tip is at (1 + cos theta2, sin theta2). Its direction from "
        "there, plus theta1, "
        "is its direction from the world. At the edge of the reach the cosine may exceed 1 by "
        "rounding: np.clip.",
        "theta1 = arctan2(y, x) - arctan2(sin theta2, 1 + cos theta2), once with each sign of "
        "theta2.",
    ),
    alike=same_list,
    distance=distance_of_lists,
    sweeps=(
        Sweep("a tip near the edge of the reach", _nearly_stretched),
        Sweep("a tip near the base", _nearly_folded, _NEARLY_FOLDED),
        Sweep("a tip near an axis", _near_an_axis, SMALL_NUMBERS),
    ),
    forbidden=("course_lib.ik.solve",),
)

EXERCISE.mistake(_ONE, form=(2,))
EXERCISE.mistake(
    Mistake(
        "a tip that rounding has put beyond 2 m has no answer",
        "Print the distance of this tip from the base with all its digits. What does the task say "
        "of such a tip?",
    ),
    form=lambda array, tip: array.size == 0 and np.hypot(*tip) > 2,
)
EXERCISE.mistake(_ABOVE_ONE, nan=_straight)


def _solutions(tip, two, first=lambda direction, two: direction - two / 2):
    """Both solutions with this theta2; first(direction of the tip, theta2) is another formula of
    theta1."""
    return np.array(
        [[first(np.arctan2(tip[1], tip[0]), sign * two), sign * two] for sign in (1, -1)]
    )


@EXERCISE.mistake(
    "theta1 differs from the direction of the tip by the wrong part of theta2, or to the wrong "
    "side",
    "In the triangle of base, elbow and tip two sides are equal: how large is the angle at the "
    "base?",
    share=(0, 1, -0.5),
)
def first_link_wrong(tip, share):
    return _solutions(tip, _bend(tip), lambda direction, two: direction - share * two)


@EXERCISE.mistake(
    "the arm is taken for stretched although the tip is not at the edge of the reach",
    "How far is this tip from the base? Below which distance does your function bend the arm?",
    short=(1e-2, 1e-4, 1e-6),
)
def stretched_too_early(tip, short):
    return None if np.hypot(*tip) < 2 - short or _straight(tip) else _solutions(tip, 0.0)


@EXERCISE.mistake(
    "theta2 is measured from the x axis of the world",
    "From which direction does the arm of this notebook measure theta2?",
)
def from_the_world(tip):
    return two_link_angles(tip) @ [[1, 1], [0, 1]]


@EXERCISE.mistake(
    "theta2 is the angle inside the triangle",
    "Draw the triangle of base, elbow and tip: where in it does theta2 stand?",
    theta1_too=(True, False),
)
def inside_the_triangle(tip, theta1_too):
    angles = _solutions(tip, np.pi - _bend(tip))
    return angles if theta1_too else np.column_stack([two_link_angles(tip)[:, 0], angles[:, 1]])
