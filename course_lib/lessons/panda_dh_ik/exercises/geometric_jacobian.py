"""geometric_jacobian: how fast the flange moves for each joint, from the frames alone."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.kinds import QUARTER, Kind, coarse_pose, leaning_axis
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.naming import KEPT_FOR_THE_NEXT_CALL
from course_lib.checks.special_cases import SIZES, SMALL
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import (
    SAME_TWICE,
    any_pose,
    away_from_zero,
    part_is,
    products,
)
from course_lib.lessons.panda_dh_ik.exercises import shared
from course_lib.rigid import transform
from course_lib.rotations import rot_x, rot_y

# Metres. Differences of positions lose their last digits there, and a right answer keeps 1e-12.
_DISTANCES = (100.0, 1000.0, 1500.0)


def _drawn(rng, n):
    """Return the frames of an arm with n skew joint axes, its base anywhere in the world."""
    steps = [shared.modified(*row) for row in away_from_zero(rng, (n, 4))]
    return np.array(products([any_pose(rng), *steps, any_pose(rng)])[2:])


def _named(rng):
    here, ahead = np.eye(4), transform(np.eye(3), [1.0, 0, 0])
    along_x = transform(rot_y(QUARTER), [0, 1.0, 0])
    along_y = transform(rot_x(-QUARTER), [0, 0, 1.0])
    simple = [
        [here, ahead],
        [ahead, transform(np.eye(3), [1.0, 2, 0])],
        [along_x, transform(np.eye(3), [0, 1.0, 3])],
        [here, ahead, transform(np.eye(3), [2.0, 0, 0])],
        [here, along_y, transform(rot_x(0.5), [1.0, 0.5, 1])],
        [here, along_x, transform(rot_x(0.5), [0, 1.0, 0])],  # joint 2 only rotates the flange
    ]
    panda = [shared.frames(q) for q in (np.zeros(7), shared.READY, *away_from_zero(rng, (2, 7)))]
    moved = _drawn(rng, 3), _drawn(rng, 3)  # two configurations with one pose of the flange
    moved[1][-1] = moved[0][-1]
    return [*map(np.array, simple), *panda, *moved]


def _short(rng, size):
    """Return the frames of two joints and a flange that are close to each other and the world's."""
    steps = [transform(rot_x(size), size * away_from_zero(rng, 3)) for _ in range(2)]
    first = transform(rot_y(size), size * away_from_zero(rng, 3))
    return np.array([first, first @ steps[0], first @ steps[0] @ steps[1]])


def _far(rng, distance):
    """Return the frames of an arm of usual size, so far from the world's origin."""
    frames = _drawn(rng, 4)
    frames[:, :3, 3] += distance * leaning_axis(rng)
    return frames


_FRAMES = Kind(
    drawn=lambda rng: _drawn(rng, int(rng.integers(1, 7))),
    named=_named,
    beside=(
        ("the number of joints", _drawn, SIZES),
        ("a short, straight arm", _short, SMALL),
        ("an arm far from the world's origin", _far, _DISTANCES),
    ),
    coarse=lambda rng: np.array([coarse_pose(rng) for _ in range(rng.integers(2, 6))]),
)


def _jacobian(z, o, p):
    """Return it from the axes z and origins o of the joints, (n, 3) each, and the flange's origin
    p."""
    return np.vstack([np.cross(z, p - o).T, z.T])


def _right(frames):
    """Return the geometric Jacobian (6, n) of the last frame, (v, omega) along the world's axes."""
    return _jacobian(frames[:-1, :3, 2], frames[:-1, :3, 3], frames[-1, :3, 3])


def _of_other_frames(others, axis_too):
    """Return the answer with the origins of others(frames), and perhaps their axes."""

    def answer(frames):
        o = others(frames)
        axes = o if axis_too else frames[:-1]
        return _jacobian(axes[:, :3, 2], o[:, :3, 3], frames[-1, :3, 3])

    return answer


def _next(frames):
    return frames[1:]


def _previous(base):
    return lambda frames: np.concatenate([[base], frames[:-2]])


def _counts_the_flange(array, frames):
    """Return whether the flange has a column, which does not move itself, or a row."""
    n = len(frames) - 1
    column = array.shape == (6, n + 1) and np.abs(array[:3, -1]).max() < EXACT
    return column or array.shape == (n + 1, 6)


def _has_grown(array, frames):
    return array.ndim == 2 and len(array) == 6 and array.shape[1] >= len(frames)


EXERCISE = declared(
    "geometric_jacobian",
    points=2,
    arguments={"frames": _FRAMES},
    library=_right,
    properties=(
        SAME_TWICE,
        part_is(
            "the lower half of each column is the angular velocity if its joint rotates at 1 rad/s",
            _right,
            slice(3, 6),
            Question(
                "an axis is not that of its joint",
                "Which column of which frame is the axis of this joint, along the world's axes, "
                "and what does your code put there?",
                of_the_formula=True,
            ),
            "The lower half of the column of joint {number}",
        ),
    ),
    says="the upper half of each column is the velocity of the flange's origin if its joint "
    "rotates at 1 rad/s",
    otherwise=Question(
        "the velocity is not z x (p - o) of its joint",
        "Compute z, o, p and z x (p - o) for the joint whose column is named. Which of them "
        "differs in your code?",
    ),
    hints=(
        "The last frame is the flange's; all others belong to joints, one each.",
        "A joint's axis z is the third column of its frame's rotation, a point o on it is the "
        "frame's origin.",
        "Column i is z x (p - o), and below it z: np.concatenate([np.cross(z, p - o), z]). "
        "Finally np.column_stack, so that the shape is (6, n).",
    ),
    forbidden=("course_lib.arms.SerialArm",),
    mistakes=(
        Mistake(
            "the flange's frame is counted as the frame of a joint",
            "Which frames belong to joints, and which frame does no joint move?",
            form=_counts_the_flange,
        ),
        Mistake(
            "the arm is taken to have seven joints",
            "How many joints does an arm with these frames have?",
            raises=("IndexError", "is out of bounds for axis 0"),
            form=(6, 7),
        ),
        Mistake(KEPT_FOR_THE_NEXT_CALL.name, KEPT_FOR_THE_NEXT_CALL.hint, form=_has_grown),
        Mistake(
            "the origin, or the axis too, is that of the next frame, or of the previous frame",
            "On the axis of which joint does frame i lie in the modified convention?",
            *(
                _of_other_frames(others, axis_too)
                for others in (_next, _previous(np.eye(4)), _previous(shared.T_W0))
                for axis_too in (False, True)
            ),
        ),
        Mistake(
            "the velocity has the wrong sign",
            "Let the axis of a joint point at you. In which direction does a positive rotation "
            "move the flange, and in which direction does your cross product point?",
            lambda frames: _right(frames) * np.repeat([[-1], [1]], 3, 0),
        ),
    ),
)
