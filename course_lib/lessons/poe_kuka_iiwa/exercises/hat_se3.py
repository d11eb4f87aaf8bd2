"""hat_se3: the matrix of a twist."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.format_numbers import ORDINALS
from course_lib.checks.kinds import TWIST
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import BESIDE
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import compared
from course_lib.lessons.poe_kuka_iiwa.exercises.shared import BLOCK, COLUMN
from course_lib.rigid import hat_se3
from course_lib.rotations import hat

# An answer that rounds, or takes a slow motion for none, loses slow twists.
_SLOW = ("a slow twist", lambda rng, size: size * rng.normal(size=6), BESIDE)


def _cases(rng):
    whole = [np.arange(1.0, 7), *np.eye(6), np.array([1, -2, 3, 4, 0, 2])]
    lists = [[0, 0, 1, 5, 6, 7], [0, 0, 1, 0.5, 0.25, -0.75]]
    return [(twist,) for twist in (*whole, *lists, 1e3 * rng.normal(size=6))]


def _relative_error(V, right, part):
    size = np.abs(right[part]).max()
    return np.abs(V[part] - right[part]).max() / min(1, size or EXACT)


def _distance(V, right, *case):
    """Return how far the matrix is from the right one; of omega and of v small numbers count."""
    parts = [_relative_error(V, right, part) for part in (BLOCK, COLUMN, 3)]
    return max(parts)


def _found(V, twist):
    gaps = np.abs(V - hat_se3(twist))
    k = int(np.argmax(gaps.max(0)))
    both = compared(hat_se3(twist)[:, k], V[:, k])
    return f"The {ORDINALS[k]} column should be " + both + "."


def _otherwise(V, twist):
    right = hat_se3(twist)
    if _relative_error(V, right, BLOCK) > EXACT:
        return Question(
            "the block is not [omega]",
            "Write down hat(omega) for the omega below, and compare it with your block, entry by "
            "entry.",
        )
    if _relative_error(V, right, COLUMN) > EXACT:
        return Question(
            "v does not stand in the last column",
            "Which three entries of the twist are v? Compare the last column with them, entry by "
            "entry, for the twist below. Which line of yours writes it for this twist?",
        )
    return Question(
        "the last row is not zero",
        "A twist is a velocity, and the 1 at the end of a point does not change with time. Which "
        "line of yours writes the last row?",
    )


def _axis_for_omega(twist):
    length = np.linalg.norm(twist[:3])
    return hat(twist[:3] / length) if length > 0 else np.zeros((3, 3))


EXERCISE = declared(
    "hat_se3",
    points=1,
    arguments={"twist": TWIST.but(beside=(*TWIST.beside, _SLOW))},
    cases=_cases,
    library=hat_se3,
    distance=_distance,
    says="the upper left 3x3 block is [omega], with omega = twist[:3], the last column begins with "
    "v = twist[3:], and the last row is (0, 0, 0, 0)",
    found=_found,
    otherwise=_otherwise,
    hints=(
        "The product [V] (p, 1) must be (omega x p + v, 0). What has to stand in the last column?",
        "Start from zeros of shape (4, 4): fill in a block and a column, and leave the last row.",
        "The block is V[:3, :3], made by hat from the first half of the twist; the column is V[:3, "
        "3], the second half.",
    ),
    forbidden=("course_lib.rigid.hat_se3",),
    mistakes=(
        Mistake(
            "the block is made of v, not of omega",
            "A twist is (omega, v): which three entries come first?",
            lambda twist: hat(twist[3:]),
            part=BLOCK,
        ),
        Mistake(
            "omega is divided by its length",
            "Does the task ask for the axis of the rotation, or for its angular velocity?",
            _axis_for_omega,
            part=BLOCK,
        ),
        Mistake(
            "a small omega, or a small twist, counts as 0",
            "May a motion be so slow that the formula does not hold for it?",
            seen=lambda V, twist: 0 < np.linalg.norm(twist[:3]) < 0.1 and not V[BLOCK].any(),
        ),
    ),
)
