"""geometric_jacobian: how fast the flange moves for each joint, from the frames alone."""

import numpy as np

from course_lib.arms import DHRow, SerialArm
from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake
from course_lib.checks.special_cases import SIZES, SMALL, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import SAME_TWICE, any_pose, away_from_zero, part_is
from course_lib.lessons.panda_dh_ik.exercises import shared
from course_lib.rigid import transform
from course_lib.rotations import rot_x, rot_y

_FLANGE_TOO = Mistake(
    "the flange's frame is counted as the frame of a joint",
    "Which frames belong to joints, and which frame does no joint move?",
)
_SEVEN = Mistake(
    "the arm is taken to have seven joints", "How many joints does an arm with these frames have?"
)
_ABOVE, _BELOW = slice(0, 3), slice(3, 6)


def _jacobian(z, o, p):
    """Return it from the axes z and origins o of the joints, (n, 3) each, and the flange's origin
    p."""
    return np.vstack([np.cross(z, p - o).T, z.T])


def right(frames):
    """Return the geometric Jacobian (6, n) of the last frame, (v, omega) along the world's axes."""
    return _jacobian(frames[:-1, :3, 2], frames[:-1, :3, 3], frames[-1, :3, 3])


def _known_form(array, frames):
    n, shape = len(frames) - 1, array.shape
    if array.ndim == 2 and len(array) == 6 and shape[1] > n:
        a_flange_s = (
            shape[1] == n + 1 and np.abs(array[:3, -1]).max() < EXACT
        )  # it does not move itself
        return _FLANGE_TOO if a_flange_s else SAME_TWICE.mistake
    return _FLANGE_TOO if shape == (n + 1, 6) else None


def _drawn(rng, n):
    """Return the frames of an arm with n skew joint axes, its base anywhere in the world."""
    arm = SerialArm.from_dh([DHRow(*row) for row in away_from_zero(rng, (n, 4))], end=any_pose(rng))
    return any_pose(rng) @ arm.frames(away_from_zero(rng, n))


def _cases(rng):
    quarter = np.pi / 2
    here, ahead = np.eye(4), transform(np.eye(3), [1.0, 0, 0])
    along_x, along_y = (
        transform(rot_y(quarter), [0, 1.0, 0]),
        transform(rot_x(-quarter), [0, 0, 1.0]),
    )
    simple = [
        [here, ahead],
        [ahead, transform(np.eye(3), [1.0, 2, 0])],
        [along_x, transform(np.eye(3), [0, 1.0, 3])],
        [here, ahead, transform(np.eye(3), [2.0, 0, 0])],
        [here, along_y, transform(rot_x(0.5), [1.0, 0.5, 1])],
    ]
    configurations = [np.zeros(7), shared.READY, *away_from_zero(rng, (2, 7))]
    drawn = [_drawn(rng, n) for n in (1, 2, 3, 5, 6)]
    return [
        (np.array(frames),)
        for frames in (*simple, *drawn, *map(shared.frames, configurations), drawn[1])
    ]


def _short(rng, size):
    """Return the frames of two joints and a flange that are close to each other and the world's."""
    steps = [transform(rot_x(size), size * away_from_zero(rng, 3)) for _ in range(2)]
    first = transform(rot_y(size), size * away_from_zero(rng, 3))
    return (np.array([first, first @ steps[0], first @ steps[0] @ steps[1]]),)


EXERCISE = Exercise(
    name="geometric_jacobian",
    points=2,
    arguments=("frames",),
    cases=_cases,
    returns=numbers(lambda frames: (6, len(frames) - 1)),
    properties=(
        SAME_TWICE,
        part_is(
            "the lower half of each column is the angular velocity if its joint rotates at 1 rad/s",
            right,
            _BELOW,
            Mistake(
                "an axis is not that of its joint",
                "Which column of which frame is the axis of the joint named below, along the "
                "world's axes?",
            ),
            "The lower half of the column of joint {number}",
        ),
        part_is(
            "the upper half of each column is the velocity of the flange's origin if its joint "
            "rotates at 1 rad/s",
            right,
            _ABOVE,
            Mistake(
                "the velocity is not z x (p - o) of its joint",
                "From which point to which point does p - o lead for the joint named below?",
            ),
            "The upper half of the column of joint {number}",
        ),
    ),
    hints=(
        "The last frame is the flange's; all others belong to joints, one each.",
        "A joint's axis z is the third column of its frame's rotation, a point o on it is the "
        "frame's origin.",
        "Column i is z x (p - o), and below it z: np.concatenate([np.cross(z, p - o), z]). "
        "Finally np.column_stack, so that the shape is (6, n).",
    ),
    forbidden=("course_lib.arms.SerialArm",),
    library=right,
    sweeps=(
        Sweep("the number of joints", lambda rng, n: (_drawn(rng, n),), SIZES),
        Sweep("a short, nearly straight arm", _short, SMALL),
    ),
)

EXERCISE.mistake(form=_known_form)
EXERCISE.mistake(_SEVEN, raises=("IndexError", "is out of bounds for axis 0"))


@EXERCISE.mistake(
    "the origin, or the axis too, is that of the next frame, or of the previous frame",
    "On the axis of which joint does frame i lie in the modified convention?",
    z=(0, 1),
    step=(1, -1),
    base=(np.eye(4), shared.T_W0),
)
def another_frame(frames, z, step, base):
    others = frames[1:] if step > 0 else np.concatenate([[base], frames[:-2]])
    return _jacobian((frames[:-1], others)[z][:, :3, 2], others[:, :3, 3], frames[-1, :3, 3])


@EXERCISE.mistake(
    "the velocity has the wrong sign",
    "Let the axis of a joint point at you. In which direction does a positive rotation move the "
    "flange, and in which direction does your cross product point?",
)
def backwards(frames):
    return right(frames) * np.repeat([[-1], [1]], 3, 0)
