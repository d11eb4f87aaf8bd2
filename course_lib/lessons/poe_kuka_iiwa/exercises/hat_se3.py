"""hat_se3: the matrix of a twist."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.special_cases import Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import compared, first_off
from course_lib.lessons.poe_kuka_iiwa.exercises.shared import BLOCK, COLUMN
from course_lib.rigid import hat_se3
from course_lib.rotations import hat


def _cases(rng):
    twists = [
        np.array([1.0, 2, 3, 4, 5, 6]),
        *np.eye(6),
        *(size * rng.normal(size=6) for size in (1, 1, 1e3)),
    ]
    return [
        (twist,)
        for twist in (*twists, np.array([1, -2, 3, 4, 0, 2]), np.zeros(6), [0, 0, 1, 5, 6, 7])
    ]


def _fits(part, right):
    """Return whether the part is right, in small twists too."""
    return np.abs(part - right).max() <= EXACT * np.abs(right).max()


EXERCISE = Exercise(
    name="hat_se3",
    points=1,
    arguments=("twist",),
    cases=_cases,
    returns=numbers(lambda twist: (4, 4)),
    library=hat_se3,
    # An answer that rounds, or takes a slow motion for none, loses slow twists.
    sweeps=(Sweep("a slow twist", lambda rng, size: (size * rng.normal(size=6),)),),
    properties=(
        Property(
            "the upper left 3x3 block is [omega], with omega = twist[:3]",
            lambda V, twist: _fits(V[BLOCK], hat(twist[:3])),
            says=lambda V, twist: first_off(V[BLOCK], hat(twist[:3])),
            mistake=Mistake(
                "the block is not [omega]",
                "Write down hat(omega) for the omega below, and compare it with your block, "
                "entry by "
                "entry.",
            ),
        ),
        Property(
            "the last column begins with v = twist[3:]",
            lambda V, twist: _fits(V[COLUMN], twist[3:]),
            says=lambda V, twist: f"v is {compared(twist[3:], V[COLUMN])}.",
            mistake=Mistake(
                "v does not stand in the last column",
                "Which three entries of the twist are v?",
            ),
        ),
        Property(
            "the last row is (0, 0, 0, 0)",
            lambda V, twist: not V[3].any(),
            mistake=Mistake(
                "the last row is not zero",
                "A twist is a velocity, and the 1 at the end of a point does not change with time.",
            ),
        ),
    ),
    hints=(
        "The product [V] (p, 1) must be (omega x p + v, 0). What has to stand in the last column?",
        "Start from zeros of shape (4, 4): fill in a block and a column, and leave the last row.",
        "The block is V[:3, :3], made by hat from the first half of the twist; the column is V[:3, "
        "3], the second "
        "half.",
    ),
    forbidden=("course_lib.rigid.hat_se3",),
)


@EXERCISE.mistake(
    "the block is made of v, not of omega",
    "A twist is (omega, v): which three entries come first?",
    part=BLOCK,
)
def block_of_v(twist):
    return hat(twist[3:])


@EXERCISE.mistake(
    "omega is divided by its length",
    "Does the task ask for the axis of the rotation, or for its angular velocity?",
    part=BLOCK,
)
def axis_for_omega(twist):
    length = np.linalg.norm(twist[:3])
    return hat(twist[:3] / length) if length > 0 else np.zeros((3, 3))


@EXERCISE.mistake(
    "a small omega, or a small twist, counts as 0",
    "May a motion be so slow that the formula does not hold for it?",
    recognises=True,
)
def slow_is_still(V, twist):
    return 0 < np.linalg.norm(twist[:3]) < 0.1 and not V[BLOCK].any()
