"""planar_jacobian: how fast the tip of the planar arm moves for each joint's velocity."""

import itertools

import numpy as np

from course_lib.arms import planar_arm
from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.naming import difference
from course_lib.checks.tolerances import SOLVED
from course_lib.checks.vocabulary import first_off, remembered

_ARM = planar_arm([1, 1, 1, 1])

# What would do the work, also by an arm of the notebook: refused in all exercises with this arm.
ARMS = ("course_lib.arms.planar_arm", "course_lib.arms.SerialArm")

_WITH_ANGLE = Mistake(
    "the Jacobian of a whole pose is returned",
    "The task asks for the Jacobian of the tip's position only.",
)


@remembered
def tip(q):
    """Return where the arm's tip is, (2,)."""
    return _ARM.fk(q)[:2, 3]


@remembered
def jacobian(q):
    """Return the derivative (2, 4) of the tip's position by the joint angles."""
    return _ARM.position_jacobian(q)[:2]


def _cases(rng):
    quarter = np.pi / 2
    named = [
        [0, 0, 0, 0],
        [quarter, 0, 0, 0],
        [0, 0, 0, quarter],
        [0, quarter, 0, 0],
        [0.3, 0, 0, 0],
    ]
    drawn = [
        rng.uniform(0.2, 1.2, 4) * signs
        for signs in itertools.product((1, -1), repeat=4)
        if signs[0] == 1
    ]
    beyond = [rng.uniform(-9, 9, 4) for _ in range(3)]
    return [(np.array(q, float),) for q in [*named, *drawn, *beyond]] + [(np.array([1, -1, 2, 0]),)]


EXERCISE = Exercise(
    name="planar_jacobian",
    points=2,
    arguments=("q",),
    tolerance=SOLVED,
    cases=_cases,
    small=("q",),
    angles=("q",),
    returns=numbers(lambda q: (2, 4)),
    library=jacobian,
    properties=(
        Property(
            "column j is the velocity of the tip when joint j alone moves, at 1 rad/s",
            lambda J, q: difference(J, jacobian(q)) < SOLVED,
            lambda J, q: first_off(J, jacobian(q)),
        ),
    ),
    hints=(
        "Link i points along a_i = q1 + ... + qi: a = np.cumsum(q). Its end moves at (-sin a_i, "
        "cos a_i) for each "
        "rad/s of a joint up to i.",
        "Joint j rotates the links j, ..., 4: column j is the sum of (-sin a_i, cos a_i) over i = "
        "j, ..., 4.",
        "Two loops, or a cumulative sum from the back: np.cumsum(x[::-1])[::-1].",
    ),
    forbidden=ARMS,
)

EXERCISE.mistake(_WITH_ANGLE, form=(3, 4))
EXERCISE.mistake(_WITH_ANGLE, form=(6, 4))

_AFTER = np.triu(np.ones((4, 4)))  # joint j moves the links from j on


def _of_links(directions, moved_by=_AFTER):
    """The Jacobian of links that point along `directions`, where joint j moves the links with
    moved_by[j]."""
    return np.array([-np.sin(directions), np.cos(directions)]) @ np.transpose(moved_by)


@EXERCISE.mistake(
    "the angles are not summed",
    "Each joint angle is measured from the previous link: in which direction does link i point?",
    moved_by=(_AFTER, np.eye(4), np.ones((4, 4))),
)
def angles_not_summed(q, moved_by):
    return _of_links(q, moved_by)


@EXERCISE.mistake(
    "the sum for joint j is over other links than those that it moves",
    "Which links move if only joint 2 does?",
    moved_by=(
        np.eye(4),
        _AFTER * [0, 0, 0, 1],
        _AFTER * [1, 1, 1, 0],
        _AFTER.T,
        _AFTER - np.eye(4),
        np.ones((4, 4)),
    ),
)
def other_links(q, moved_by):
    return _of_links(np.cumsum(q), moved_by)


@EXERCISE.mistake(
    "sine and cosine are not differentiated, or their rows are swapped",
    "Row 1 is the velocity along x: what is the derivative of the x coordinate?",
    signs=([[-1], [1]], [[1], [1]], [[1], [-1]]),
)
def not_differentiated(q, signs):
    return jacobian(q)[::-1] * signs
