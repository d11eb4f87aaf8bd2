"""geometric_jacobian: how fast the flange moves for each joint, from the frames alone."""

import numpy as np

from course_lib.arms import DHRow, SerialArm
from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.panda_dh_ik import shared
from course_lib.checks.exercises.panda_dh_ik.geometric_jacobian_mistakes import MISTAKES, jacobian
from course_lib.checks.vocabulary import SAME_TWICE, any_pose, away_from_zero, near
from course_lib.rigid import transform
from course_lib.rotations import rot_x, rot_y

_COLUMNS = "One column for each joint, six numbers each: the shape is (6, n)."
_TRANSPOSED = Mistake("rows and columns are swapped", _COLUMNS)
_FLANGE_TOO = Mistake("the flange's frame is counted as a joint's", "The last frame belongs to no joint.")
_HALF = Mistake("only one half of the Jacobian is returned", _COLUMNS)
_SEVEN = Mistake("the arm is taken to have seven joints", "The number of joints is len(frames) - 1.")
_APART = Mistake("v and omega are not in one column", _COLUMNS)
_ONE_LEFT_OUT = Mistake("one joint is left out", "Every frame but the last belongs to a joint.")
_ONE_COLUMN = Mistake("only one column is returned", _COLUMNS)


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
    """Return whether the columns of earlier calls are there too: a column of the flange would have v = 0."""
    if array.ndim != 2 or len(array) != 6:
        return False
    more = array.shape[1] - n
    return more > 1 or (more == 1 and np.abs(array[:3, -1]).max() > 1e-9)


def _drawn(rng, n):
    """Return the frames of an arm with n skew joint axes, its base anywhere in the world."""
    numbers = away_from_zero(rng, (n, 4))
    arm = SerialArm.from_dh([DHRow(*row) for row in numbers], end=any_pose(rng))
    return any_pose(rng) @ arm.frames(away_from_zero(rng, n))


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
    configurations = [np.zeros(7), shared.READY, *away_from_zero(rng, (2, 7))]
    drawn = [_drawn(rng, n) for n in (1, 2, 3, 5, 6)]
    return [(np.array(frames),) for frames in (*simple, *drawn, *map(shared.frames, configurations), drawn[1])]


def _off(J, frames, rows):
    """Return in words the first column that is wrong in these rows."""
    right, first = jacobian(frames), 3 * (rows is BELOW)
    i = next((k for k in range(_joints(frames)) if not near(J[rows, k], right[rows, k])), 0)
    return (
        f"For joint {i + 1}, column {i}, that is {format_tuple(right[rows, i])}; "
        f"J[{first}:{first + 3}, {i}] of yours is {format_tuple(J[rows, i])}."
    )


ABOVE, BELOW = slice(0, 3), slice(3, 6)

EXERCISE = Exercise(
    name="geometric_jacobian",
    points=2,
    arguments=("frames",),
    cases=_cases,
    returns=numbers(lambda frames: (6, _joints(frames)), _known_form),
    properties=(
        SAME_TWICE,
        Property(
            "the lower half of each column is the angular velocity if its joint rotates at 1 rad/s: "
            "the z axis of the joint's frame",
            lambda J, frames: near(J[BELOW], jacobian(frames)[BELOW]),
            says=lambda J, frames: _off(J, frames, BELOW),
        ),
        Property(
            "the upper half of each column is the velocity of the flange's origin p if its joint rotates at 1 rad/s: "
            "z x (p - o), with o the origin of the joint's frame",
            lambda J, frames: near(J[ABOVE], jacobian(frames)[ABOVE]),
            says=lambda J, frames: _off(J, frames, ABOVE),
        ),
    ),
    mistakes=MISTAKES,
    hints=(
        "The last frame is the flange's; all others belong to joints, one each.",
        "A joint's axis z is the third column of its frame's rotation, a point o on it is the frame's origin.",
        "Column i is z x (p - o), and below it z: np.concatenate([np.cross(z, p - o), z]). "
        "Finally np.column_stack, so that the shape is (6, n).",
    ),
    forbidden=("course_lib.arms.SerialArm",),
    library=jacobian,
    errors=(("IndexError", "is out of bounds for axis 0", _SEVEN),),
)
