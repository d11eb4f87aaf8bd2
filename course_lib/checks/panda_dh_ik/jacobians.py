"""geometric_jacobian: how fast the flange moves when each joint turns, from the frames alone."""

import numpy as np

from course_lib.arms import DHRow, SerialArm
from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.panda_dh_ik import tables
from course_lib.checks.panda_dh_ik.jacobian_mistakes import MISTAKES, jacobian
from course_lib.checks.poe_kuka_iiwa.chains import SAME_TWICE, away_from_zero, turned_hand
from course_lib.checks.poe_kuka_iiwa.matrices import near
from course_lib.rigid import transform
from course_lib.rotations import rot_x, rot_y

_SIDE_BY_SIDE = "np.vstack([v.T, z.T]) for v and z with a row for each joint; or np.column_stack of the columns."
_TRANSPOSED = Mistake(
    "rows and columns are swapped", "One column for each joint: the shape is (6, n). Transpose with .T."
)
_FLANGE_TOO = Mistake(
    "the flange's frame is counted as a joint's",
    "No joint moves the flange against frame n: the axes are those of frames[:-1].",
)
_HALF = Mistake("only one half of the Jacobian is returned", "Each column has six numbers: v above, omega below.")
_SEVEN = Mistake("the arm is taken to have seven joints", "Any number may come: n = len(frames) - 1, or frames[:-1].")
_APART = Mistake("v and omega do not stand in one column", _SIDE_BY_SIDE)
_ONE_LEFT_OUT = Mistake(
    "one joint is left out", "The joints are frames[0] to frames[n - 1]: frames[:-1] has all of them."
)
_ONE_COLUMN = Mistake(
    "only one column is returned", "One column for each joint, also where there is one: shape (6, n)."
)


def _joints(frames):
    return len(frames) - 1


def _known_form(array, frames):
    n, shape = _joints(frames), array.shape
    if _grown(array, n):
        return SAME_TWICE.mistake
    if shape in ((n, 6), (n, 6, 1)):
        return _TRANSPOSED
    if shape in ((6, n + 1), (n + 1, 6)):
        return _FLANGE_TOO
    if shape == (6, n - 1):
        return _ONE_LEFT_OUT
    if shape in ((3, n), (n, 3)):
        return _HALF
    if shape == (6,):
        return _ONE_COLUMN
    apart = ((2, 3, n), (2, n, 3), (n, 2, 3), (3, 2 * n), (2 * n, 3), (6 * n,))
    return _APART if shape in apart else None


def _grown(array, n):
    """Whether the columns are those of earlier calls too: then the last one is not the flange's, which has v = 0."""
    if array.ndim != 2 or len(array) != 6:
        return False
    more = array.shape[1] - n
    return more > 1 or (more == 1 and np.abs(array[:3, -1]).max() > 1e-9)


def _drawn(rng, n):
    """The frames of an arm with n joints askew, at any angles, its base anywhere in the world."""
    numbers = away_from_zero(rng, (n, 4))
    arm = SerialArm.from_dh([DHRow(*row) for row in numbers], end=turned_hand(rng))
    return turned_hand(rng) @ arm.frames(away_from_zero(rng, n))


def _cases(rng):
    quarter = np.pi / 2
    here, ahead = np.eye(4), transform(np.eye(3), [1.0, 0, 0])
    along_x = transform(rot_y(quarter), [0, 1.0, 0])
    along_y = transform(rot_x(-quarter), [0, 0, 1.0])
    simple = [
        [here, ahead],
        [ahead, transform(np.eye(3), [1.0, 2, 0])],
        [along_x, transform(np.eye(3), [0, 1.0, 3])],
        [here, ahead, transform(np.eye(3), [2.0, 0, 0])],
        [here, along_y, transform(rot_x(0.5), [1.0, 0.5, 1])],
    ]
    postures = [np.zeros(7), np.array([0, -quarter / 2, 0, -1.5 * quarter, 0, quarter, quarter / 2])]
    postures += list(away_from_zero(rng, (3, 7)))
    drawn = [_drawn(rng, n) for n in (1, 2, 3, 4, 5, 6, 7)]
    return [(np.array(frames),) for frames in (*simple, *drawn, *map(tables.frames, postures), drawn[1])]


def _off(J, frames, rows):
    """The first column that is wrong in these rows, in words."""
    right, first = jacobian(frames), 3 * (rows is BELOW)
    i = next((k for k in range(_joints(frames)) if not near(J[rows, k], right[rows, k])), 0)
    return (
        f"For joint {i + 1}, column {i}, that is {format_tuple(right[rows, i])}; "
        f"J[{first}:{first + 3}, {i}] of yours is {format_tuple(J[rows, i])}."
    )


ABOVE, BELOW = slice(0, 3), slice(3, 6)

GEOMETRIC_JACOBIAN = Exercise(
    name="geometric_jacobian",
    points=2,
    arguments=("frames",),
    cases=_cases,
    returns=numbers(lambda frames: (6, _joints(frames)), _known_form),
    properties=(
        SAME_TWICE,
        Property(
            "below, each column has the angular velocity when its joint turns with 1 rad/s: "
            "z, the third column of the joint's frame",
            lambda J, frames: near(J[BELOW], jacobian(frames)[BELOW]),
            seen=lambda J, frames: _off(J, frames, BELOW),
        ),
        Property(
            "above, each column has the velocity of the flange's origin p when its joint turns with 1 rad/s: "
            "z x (p - o), o being the origin of the joint's frame",
            lambda J, frames: near(J[ABOVE], jacobian(frames)[ABOVE]),
            seen=lambda J, frames: _off(J, frames, ABOVE),
        ),
    ),
    mistakes=MISTAKES,
    hints=(
        "The last frame is the flange's: p = frames[-1, :3, 3]. All others are joints': frames[:-1].",
        "Of each joint's frame: its axis z = frame[:3, 2], a point on it o = frame[:3, 3].",
        "Column i is z x (p - o), and below it z: np.concatenate([np.cross(z, p - o), z]). "
        "At last np.column_stack, so that the shape is (6, n).",
    ),
    forbidden=("course_lib.arms.SerialArm",),
    errors=(("IndexError", "index 7 is out of bounds", _SEVEN),),
)
