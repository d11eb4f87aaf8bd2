"""hat_se3: the matrix of a twist."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.poe_kuka_iiwa.shared import BLOCK, COLUMN, in_part, worst_column
from course_lib.checks.vocabulary import FINE, transposed
from course_lib.rigid import exp_se3, hat_se3
from course_lib.rotations import hat

_NO_ROW = Mistake("the last row is missing", "The matrix is 4 x 4: below [omega] and v stands a row of zeros.")
_BLOCK_ALONE = Mistake("the block [omega] alone is returned", "v belongs in it as well, in a fourth column.")


def _cases(rng):
    twists = [np.array([1.0, 2, 3, 4, 5, 6]), *np.eye(6), *(size * rng.normal(size=6) for size in (1, 1e-3, 1e3))]
    return [(twist,) for twist in (*twists, np.array([1, -2, 3, 4, 0, 2]), np.zeros(6))]


def _with_row(twist, row, column=None):
    V = hat_se3(twist)
    V[3] = row
    if column is not None:
        V[COLUMN] = column
    return V


def _fits(part, right):
    """Return whether the part is right, in small twists too."""
    return np.abs(part - right).max() <= FINE * np.abs(right).max()


_in_block, _in_column = in_part(hat_se3, BLOCK), in_part(hat_se3, COLUMN)

EXERCISE = Exercise(
    name="hat_se3",
    points=1,
    arguments=("twist",),
    cases=_cases,
    returns=numbers(lambda *case: (4, 4), {(3, 4): _NO_ROW, (3, 3): _BLOCK_ALONE}),
    properties=(
        Property(
            "the upper left 3x3 block is [omega], with omega = twist[:3]",
            lambda V, twist: _fits(V[BLOCK], hat(twist[:3])),
            says=worst_column(lambda V: V[BLOCK], lambda twist: hat(twist[:3])),
        ),
        Property(
            "the last column begins with v = twist[3:]",
            lambda V, twist: _fits(V[COLUMN], twist[3:]),
            says=lambda V, twist: f"v is {format_tuple(twist[3:])}; your column begins with {format_tuple(V[COLUMN])}.",
        ),
        Property(
            "the last row is (0, 0, 0, 0)",
            lambda V, twist: not V[3].any(),
            says=lambda V, twist: f"Yours is {format_tuple(V[3])}.",
            mistake=Mistake("the last row is not zero", "A twist is a velocity: the 1 at the end of a point is fixed."),
        ),
    ),
    mistakes=(
        Mistake(
            "v and omega are swapped",
            "A twist is (omega, v): which three entries come first?",
            lambda twist: hat_se3(np.roll(twist, 3)),
        ),
        transposed(hat_se3, "the whole matrix is transposed: v stands in the last row", "v is a column."),
        Mistake(
            "v stands in the last row, not in the last column",
            "Rows come first in an index: V[row, column].",
            lambda twist: _with_row(twist, np.append(twist[3:], 0), 0),
            lambda twist: _with_row(twist, np.append(-twist[3:], 0), 0),
        ),
        Mistake(
            "the matrix is made skew-symmetric: v stands in the last row as well",
            "Only its block [omega] is skew-symmetric. What does the last row do to a point (p, 1)?",
            lambda twist: _with_row(twist, np.append(-twist[3:], 0)),
            lambda twist: _with_row(twist, np.append(twist[3:], 0)),
        ),
        Mistake(
            "the identity is added",
            "That is a pose after a small motion, I + [V]; asked for is [V] itself.",
            lambda twist: np.eye(4) + hat_se3(twist),
        ),
        Mistake(
            "digits after the point are cut off",
            "The matrix is made to hold whole numbers: np.zeros((4, 4)), without int, has room for digits.",
            lambda twist: None if np.all(twist == np.trunc(twist)) else np.trunc(hat_se3(twist)),
        ),
        Mistake("the exponential is returned", "[V] is what the exponential is taken of.", exp_se3),
        Mistake(
            "the last row is that of a pose, (0, 0, 0, 1)",
            "A pose maps points to points, which end in 1; this one gives velocities, which end in 0.",
            lambda twist: _with_row(twist, (0, 0, 0, 1)),
        ),
        _in_block(
            "the block [omega] is transposed",
            "[omega] p must be omega x p: try p = (1, 0, 0).",
            lambda twist: hat(-twist[:3]),
        ),
        _in_block(
            "the block is made of v, not of omega",
            "A twist is (omega, v): which three entries come first?",
            lambda twist: hat(twist[3:]),
        ),
        _in_block(
            "omega is divided by its length",
            "The matrix is linear in the twist: nothing is divided.",
            lambda twist: hat(twist[:3] / np.linalg.norm(twist[:3])) if twist[:3].any() else None,
        ),
        _in_block("the block [omega] is left empty", "The block makes omega x p.", lambda twist: np.zeros((3, 3))),
        _in_block(
            "the entries of omega do not stand where the cross product needs them",
            "Column k of the block is omega x e_k: write down omega x (1, 0, 0).",
            lambda twist: np.diag(twist[:3]),
            lambda twist: np.abs(hat(twist[:3])),
            lambda twist: hat(twist[2::-1]),
            lambda twist: hat(twist[[0, 2, 1]]),
            lambda twist: hat(twist[[1, 0, 2]]),
        ),
        _in_column(
            "v is taken from the slice of omega",
            "omega is the first half of the twist, v the second.",
            lambda twist: twist[:3],
        ),
        _in_column("v has its sign changed", "v stands in the column as it is.", lambda twist: -twist[3:]),
        _in_column("v is left out", "The last column begins with v.", lambda twist: np.zeros(3)),
        _in_column(
            "omega x v stands where v belongs",
            "v stands in the column as it is.",
            lambda twist: np.cross(twist[:3], twist[3:]),
            lambda twist: np.cross(twist[3:], twist[:3]),
        ),
    ),
    hints=(
        "The product [V] (p, 1) must be (omega x p + v, 0). What has to stand in the last column?",
        "Start from zeros of shape (4, 4): fill in a block and a column, and leave the last row.",
        "The block is V[:3, :3], made by hat from the first half of the twist; the column is V[:3, 3], the "
        "second half.",
    ),
    library=hat_se3,
    forbidden=("course_lib.rigid.hat_se3",),
)
