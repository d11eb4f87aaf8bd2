"""panda_fk: the poses of the Panda's frames and its flange in the world."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.panda_dh_ik.panda_fk_mistakes import MISTAKES
from course_lib.checks.exercises.panda_dh_ik.shared import FLANGE, HIGH, LOW, READY, T_W0, TABLE, frames, steps
from course_lib.checks.vocabulary import SAME_TWICE, near

_ALL = "All eight are asked for: frames 1 to 7, then the flange."
_JOINED = Mistake("the poses are joined into one large matrix", "np.array(list) stacks them along a new first axis.")
_SHAPES = {
    (4, 4): Mistake("only one pose is returned", _ALL),
    (7, 4, 4): Mistake("one of the eight is left out, most likely the flange", _ALL),
    (9, 4, 4): Mistake("there is one pose too many, most likely the base", "The first of the eight is frame 1."),
    (8, 3): Mistake("only the positions are returned", "Each of the eight is a whole pose, 4 x 4."),
    (3,): Mistake("only one position is returned", _ALL),
    (8, 3, 3): Mistake("only the rotations are returned", "Each of the eight is a whole pose, 4 x 4."),
    (8, 3, 4): Mistake("the last rows are missing", "The last row of each pose is 0, 0, 0, 1."),
} | dict.fromkeys(((32, 4), (4, 4, 8), (4, 32)), _JOINED)

_NAMES = (*(f"frame {i}" for i in range(1, 8)), "the flange")


def _known_form(array, q):
    """Return the mistake of an array of another shape, or None; a list of more than nine has grown with each call."""
    if array.shape[1:] == (4, 4) and len(array) > 9:
        return SAME_TWICE.mistake
    return _SHAPES.get(array.shape)


def _cases(rng):
    bent = np.array([0.4, 0.5, -0.3, -1.6, 0.8, 1.9, 0.6])
    one = [np.where(np.arange(7) == i, np.pi / 2 if i % 2 else 0.5, 0.0) for i in range(7)]
    drawn = list(np.round(rng.uniform(LOW, HIGH, (4, 7)), 2))
    return [(q,) for q in (READY, np.zeros(7), bent, *one, *drawn, drawn[0])]


def _in_the_one_before(T):
    """Return each of the eight poses seen from the one before it, the first from the base."""
    return np.linalg.solve(np.concatenate([T_W0[None], T[:-1]]), T)


def _column_off(ours, yours):
    """Return in words which position is wrong, else which axis."""
    if not near(yours[:3, 3], ours[:3, 3]):
        return f"is at {format_tuple(ours[:3, 3])}; yours at {format_tuple(yours[:3, 3])}."
    i = int(np.argmax(np.abs(ours - yours).max(0)))
    return (
        f"has its {'xyz'[i]} axis along {format_tuple(ours[:3, i])}; yours has it along {format_tuple(yours[:3, i])}."
    )


def _first_off(T, right):
    return next((k for k in range(8) if not near(T[k], right[k])), 0)


def _off(T, q):
    k = _first_off(T, frames(q))
    return f"With these angles {_NAMES[k]}, pose {k} of yours, {_column_off(frames(q)[k], T[k])}"


def _off_from_the_one_before(T, q):
    seen, wanted = _in_the_one_before(T), steps(q)
    k = _first_off(seen, wanted)
    if k == 7:
        return f"From frame 7 the flange {_column_off(wanted[7], seen[7])}"
    a, alpha, d = TABLE[k]
    row = f"a = {a:g}, alpha = {np.rad2deg(alpha):.0f} degrees, d = {d:g}"
    return f"In row {k + 1} of the table, {row}: from frame {k} frame {k + 1} {_column_off(wanted[k], seen[k])}"


def _regular(T):
    return np.linalg.norm(T[:, :3, :3], axis=(1, 2)).max() < 10 and np.abs(np.linalg.det(T[:, :3, :3]) - 1).max() < 0.1


EXERCISE = Exercise(
    name="panda_fk",
    points=2,
    arguments=("q",),
    cases=_cases,
    returns=numbers(lambda q: (8, 4, 4), _known_form),
    properties=(
        SAME_TWICE,
        Property(
            "the last row of each pose is (0, 0, 0, 1)",
            lambda T, q: near(T[:, 3], np.tile([0, 0, 0, 1], (8, 1))),
            says=lambda T, q: f"Yours are {format_tuple(T[0, 3])} in the first, {format_tuple(T[-1, 3])} in the last.",
        ),
        Property(
            "frame 1 is on the base, d = 0.333 above it, and rotates with the first angle alone",
            lambda T, q: near(T[0], frames(q)[0]),
            says=_off,
        ),
        Property(
            "each frame, seen from the one before, is the step of its row of the table",
            lambda T, q: not _regular(T) or near(_in_the_one_before(T)[:7], steps(q)[:7]),
            says=_off_from_the_one_before,
        ),
        Property(
            f"the flange is {FLANGE} m along the z axis of frame 7, with the same axes",
            lambda T, q: not _regular(T) or near(_in_the_one_before(T)[7], steps(q)[7]),
            says=_off_from_the_one_before,
        ),
        Property(
            "the pose of frame i in the world is T_world_base T_1 ... T_i",
            lambda T, q: near(T, frames(q)),
            says=_off,
        ),
    ),
    mistakes=MISTAKES,
    hints=(
        "Begin with the pose of the base in the world, and multiply by one step for each row of the table.",
        "In the loop: T = T @ dh_modified(a, alpha, d, theta). Append each T to a list.",
        "The flange is T @ rigid.transform(np.eye(3), [0, 0, 0.107]). Return np.array(list), shape (8, 4, 4).",
    ),
    library=frames,
    forbidden=("course_lib.arms.panda", "course_lib.arms.SerialArm"),
)
