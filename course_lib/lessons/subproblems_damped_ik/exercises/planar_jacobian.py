"""planar_jacobian: how fast the tip of the planar arm moves for each joint's velocity."""

import numpy as np

from course_lib.arms import planar_arm
from course_lib.checks.declared import declared
from course_lib.checks.kinds import QUARTER, joint_angles
from course_lib.checks.mistake import Mistake
from course_lib.checks.special_cases import SMALL, Sweep
from course_lib.checks.tolerances import SOLVED
from course_lib.checks.vocabulary import away_from_zero, remembered

_ARM = planar_arm([1, 1, 1, 1])

# What would do the work, also by an arm of the notebook: refused in all exercises with this arm.
ARMS = ("course_lib.arms.planar_arm", "course_lib.arms.SerialArm")

_AFTER = np.triu(np.ones((4, 4)))  # joint j moves the links from j on
_OTHER_LINKS = (
    np.eye(4),
    _AFTER.T,
    _AFTER - np.eye(4),
    _AFTER * [1, 1, 1, 0],
    _AFTER * [0, 0, 0, 1],
    np.ones((4, 4)),
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
    simple = np.zeros(4), [QUARTER, 0, 0, 0], [0, 0, 0, QUARTER], [0, QUARTER, 0, 0]
    # Each angle is less than the 1e-8 of np.allclose, and their sum is not.
    return [*((np.array(q),) for q in simple), (np.full(4, 9e-9),)]


def _nearly_at_a_joint(rng, gap):
    """An arm whose tip is nearly at joint 3: its last two links lie on each other."""
    return (np.array([*away_from_zero(rng, 3), rng.choice([-1, 1]) * np.pi + gap]),)


def _of_links(directions, moved_by=_AFTER):
    """Return the Jacobian of links that point along directions(q), where joint j moves the links
    with moved_by[j]."""

    def answer(q):
        along = directions(q)
        return np.array([-np.sin(along), np.cos(along)]) @ np.transpose(moved_by)

    return answer


def _with_rows_swapped(*signs):
    return lambda q: jacobian(q)[::-1] * np.reshape(signs, (2, 1))


EXERCISE = declared(
    "planar_jacobian",
    points=2,
    arguments={"q": joint_angles(4, small=True)},
    cases=_cases,
    tolerance=SOLVED,
    library=jacobian,
    sweeps=(Sweep("the tip is nearly at a joint", _nearly_at_a_joint, SMALL),),
    says="column j is the velocity of the tip when joint j alone moves, at 1 rad/s",
    hints=(
        "Link i points along a_i = q1 + ... + qi: a = np.cumsum(q). Its end moves at (-sin a_i, "
        "cos a_i) for each rad/s of a joint up to i.",
        "Joint j rotates the links j, ..., 4: column j is the sum of (-sin a_i, cos a_i) over i = "
        "j, ..., 4.",
        "Two loops, or a cumulative sum from the back: np.cumsum(x[::-1])[::-1].",
    ),
    forbidden=ARMS,
    mistakes=(
        Mistake(
            "the Jacobian of a whole pose is returned",
            "The task asks for the Jacobian of the tip's position only.",
            form=lambda array, q: array.shape in ((3, 4), (6, 4)),
        ),
        Mistake(
            "the angles are not summed",
            "Each joint angle is measured from the previous link: in which direction does link i "
            "point?",
            *(_of_links(np.array, by) for by in (_AFTER, np.eye(4), np.ones((4, 4)))),
        ),
        Mistake(
            "the sum for joint j is over other links than those that it moves",
            "Which links move if only joint 2 does?",
            *(_of_links(np.cumsum, by) for by in _OTHER_LINKS),
        ),
        Mistake(
            "sine and cosine are not differentiated, or their rows are swapped",
            "Row 1 is the velocity along x: what is the derivative of the x coordinate?",
            *map(_with_rows_swapped, (-1, 1, 1), (1, 1, -1)),
        ),
    ),
)
