"""hat_se3: the matrix of a twist."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import first_off
from course_lib.lessons.poe_kuka_iiwa.exercises.shared import BLOCK, COLUMN
from course_lib.rigid import hat_se3
from course_lib.rotations import hat


def _cases(rng):
    twists = [
        np.array([1.0, 2, 3, 4, 5, 6]),
        *np.eye(6),
        # A slow twist is one, too: an answer that rounds to a fixed number of decimals loses it.
        *(size * rng.normal(size=6) for size in (1, 1e-3, 1e3, 1e-7, 1e-13)),
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
    properties=(
        Property(
            "the upper left 3x3 block is [omega], with omega = twist[:3]",
            lambda V, twist: _fits(V[BLOCK], hat(twist[:3])),
            says=lambda V, twist: first_off(V[BLOCK], hat(twist[:3])),
            mistake=Mistake(
                "the block is not [omega]",
                "Is omega the first half of the twist, with its own length?",
            ),
        ),
        Property(
            "the last column begins with v = twist[3:]",
            lambda V, twist: _fits(V[COLUMN], twist[3:]),
            says=lambda V, twist: (
                f"v is {format_tuple(twist[3:])}; your column begins with "
                f"{format_tuple(V[COLUMN])}."
            ),
            mistake=Mistake(
                "v does not stand in the last column",
                "Which entries of the twist are v, as they are?",
            ),
        ),
        Property(
            "the last row is (0, 0, 0, 0)",
            lambda V, twist: not V[3].any(),
            mistake=Mistake(
                "the last row is not zero",
                "A twist is a velocity: the 1 at the end of a point is fixed.",
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
