"""hat_se3: the matrix of a twist."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.poe_kuka_iiwa.matrices import BLOCK, COLUMN, FINE, in_part, near, told
from course_lib.rigid import exp_se3, hat_se3
from course_lib.rotations import hat

_NO_ROW = Mistake("the last row is missing", "Start from np.zeros((4, 4)) and fill in the block and the column.")
_BLOCK_ALONE = Mistake("the block [omega] alone is returned", "v belongs in it as well: a fourth column, and a row 0.")


def _cases(rng):
    twists = [*np.eye(6), np.zeros(6), np.array([1.0, 2, 3, 4, 5, 6])]
    twists += [size * rng.normal(size=6) for size in (1, 1, 1e-3, 1e3)]
    return [(twist,) for twist in twists]


def _block(twist):
    return hat(twist[:3])


def _column(twist):
    return twist[3:]


def _made(block, column, row=(0, 0, 0, 0)):
    return np.vstack([np.column_stack([block, column]), row])


_in_block, _in_column = in_part(BLOCK, _block), in_part(COLUMN, _column)


def _fits(part, right):
    """Whether the part is right, in small twists too."""
    return np.abs(part - right).max() <= FINE * np.abs(right).max()


HAT_SE3 = Exercise(
    name="hat_se3",
    points=1,
    arguments=("twist",),
    cases=_cases,
    returns=numbers(lambda *case: (4, 4), {(3, 4): _NO_ROW, (3, 3): _BLOCK_ALONE}),
    properties=(
        Property(
            "the upper left 3x3 block is [omega], with omega = twist[:3]",
            lambda V, twist: _fits(V[BLOCK], _block(twist)),
            seen=told(lambda V: V[BLOCK], _block),
        ),
        Property(
            "the last column begins with v = twist[3:]",
            lambda V, twist: _fits(V[COLUMN], _column(twist)),
            seen=lambda V, twist: f"v is {format_tuple(twist[3:])}; your column begins with {format_tuple(V[COLUMN])}.",
        ),
        Property(
            "the last row is (0, 0, 0, 0)",
            lambda V, twist: not V[3].any(),
            seen=lambda V, twist: f"Yours is {format_tuple(V[3])}.",
            mistake=Mistake("the last row is not zero", "A twist is a velocity: nothing of a point's last 1 changes."),
        ),
    ),
    mistakes=(
        Mistake(
            "v and omega are swapped",
            "A twist is (omega, v): the first three entries are omega.",
            lambda twist: hat_se3(np.roll(twist, 3)),
        ),
        Mistake(
            "the whole matrix is transposed: v stands in the last row",
            "v is a column, above the last row's 0.",
            lambda twist: hat_se3(twist).T,
        ),
        Mistake(
            "v stands in the last row, not in the last column",
            "V[:3, 3] = v fills the column.",
            lambda twist: _made(hat(twist[:3]), np.zeros(3), np.append(twist[3:], 0)),
            lambda twist: _made(hat(twist[:3]), np.zeros(3), np.append(-twist[3:], 0)),
        ),
        Mistake(
            "the matrix is made skew-symmetric: v stands in the last row as well",
            "For all its name, this hat is not skew-symmetric: its last row is zero.",
            lambda twist: _made(hat(twist[:3]), twist[3:], np.append(-twist[3:], 0)),
            lambda twist: _made(hat(twist[:3]), twist[3:], np.append(twist[3:], 0)),
        ),
        Mistake(
            "the identity is added",
            "That is a pose for a small twist, I + [V]; asked for is [V] itself.",
            lambda twist: np.eye(4) + hat_se3(twist),
        ),
        Mistake("the exponential is returned", "[V] is what the exponential is taken of.", exp_se3),
        Mistake(
            "the last row is that of a pose, (0, 0, 0, 1)",
            "A pose maps points to points, which end in 1; this one gives velocities, which end in 0.",
            seen=lambda V, twist: near(V[3], np.eye(4)[3]),
        ),
        _in_block(
            ("the block [omega] is transposed", "[omega] p must be omega x p: your hat does that."),
            lambda twist: hat(-twist[:3]),
        ),
        _in_block(
            ("the block is made of v, not of omega", "A twist is (omega, v): omega is twist[:3]."),
            lambda twist: hat(twist[3:]),
        ),
        _in_block(
            ("omega is divided by its length", "The matrix is linear in the twist: nothing is divided."),
            lambda twist: hat(twist[:3] / np.linalg.norm(twist[:3])) if twist[:3].any() else None,
        ),
        _in_block(
            ("the block is left empty", "V[:3, :3] = hat(omega)"),
            lambda twist: np.zeros((3, 3)),
        ),
        _in_block(
            ("omega stands on the diagonal", "V[:3, :3] = hat(omega): the cross product's matrix."),
            lambda twist: np.diag(twist[:3]),
        ),
        _in_column(
            ("v is taken from omega's place: it is twist[3:], not twist[:3]", "omega is twist[:3] and v is twist[3:]."),
            lambda twist: twist[:3],
        ),
        _in_column(("v has lost its sign", "v stands in the column as it is."), lambda twist: -twist[3:]),
        _in_column(("v is left out", "V[:3, 3] = v"), lambda twist: np.zeros(3)),
        _in_column(
            ("omega x v stands where v belongs", "v stands in the column as it is."),
            lambda twist: np.cross(twist[:3], twist[3:]),
            lambda twist: np.cross(twist[3:], twist[:3]),
        ),
    ),
    hints=(
        "omega, v = twist[:3], twist[3:].",
        "Start from np.zeros((4, 4)). The block [:3, :3] is hat(omega), the column [:3, 3] is v.",
    ),
    forbidden=("course_lib.rigid.hat_se3",),
)
