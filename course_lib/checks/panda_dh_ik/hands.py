"""panda_fk: the Panda's frames and its flange, seen from the world."""

import numpy as np

from course_lib.arms import panda
from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.panda_dh_ik.hand_mistakes import MISTAKES
from course_lib.checks.panda_dh_ik.tables import FLANGE, STAND, TABLE, frames, steps
from course_lib.checks.poe_kuka_iiwa.chains import SAME_TWICE
from course_lib.checks.poe_kuka_iiwa.matrices import near

_ALL = "All eight are asked for: frames 1 to 7, then the flange. Append each T to a list; at last np.array(list)."
_SHAPES = {
    (4, 4): Mistake("only one pose is returned", _ALL),
    (7, 4, 4): Mistake(
        "one of the eight is left out, most likely the flange",
        "Behind frame 7 comes the flange, 0.107 m along z: one more pose, T @ rigid.transform(np.eye(3), "
        "[0, 0, 0.107]).",
    ),
    (9, 4, 4): Mistake(
        "there is one pose too many, most likely the base", "The first of the eight is frame 1, not the base."
    ),
    (8, 3): Mistake("only the places are returned", "Each of the eight is a whole pose, 4 x 4."),
    (3,): Mistake("only one place is returned", _ALL),
    (8, 3, 3): Mistake("only the rotations are returned", "Each of the eight is a whole pose, 4 x 4."),
    (8, 3, 4): Mistake("the last rows are missing", "Each pose ends with the row 0, 0, 0, 1."),
    (32, 4): Mistake(
        "the poses are joined into one tall matrix", "np.array(list) or np.stack(list), not np.vstack(list)."
    ),
    (4, 4, 8): Mistake(
        "the poses are stacked along the last axis", "np.array(list) or np.stack(list), without an axis."
    ),
    (4, 32): Mistake(
        "the poses are joined into one wide matrix", "np.array(list) or np.stack(list), not np.hstack(list)."
    ),
}

_NAMES = (*(f"frame {i}" for i in range(1, 8)), "the flange")


def _known_form(array, q):
    """The mistake of an array with another shape, or None; a list of more than nine has grown with each call."""
    if array.shape[1:] == (4, 4) and len(array) > 9:
        return SAME_TWICE.mistake
    return _SHAPES.get(array.shape)


def _cases(rng):
    zero, ready = np.zeros(7), np.array([0, -np.pi / 4, 0, -3 * np.pi / 4, 0, np.pi / 2, np.pi / 4])
    one = [np.where(np.arange(7) == i, np.pi / 2 if i % 2 else 0.5, 0.0) for i in range(7)]
    low, high = panda().limits.T
    drawn = list(np.round(rng.uniform(low, high, (5, 7)), 2))
    all_of_them = np.array([0.4, 0.5, -0.3, -1.6, 0.8, 1.9, 0.6])
    return [(q,) for q in (zero, *one, ready, all_of_them, *drawn, drawn[0])]


def _in_the_one_before(T):
    """Each of the eight poses seen from the one before it, the first from the base."""
    return np.linalg.solve(np.concatenate([STAND[None], T[:-1]]), T)


def _column_off(ours, yours):
    """The place where it is wrong, else the axis that is, in words."""
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


PANDA_FK = Exercise(
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
            seen=lambda T, q: f"Yours are {format_tuple(T[0, 3])} in the first, {format_tuple(T[-1, 3])} in the last.",
        ),
        Property(
            "with all angles 0 the frames stand where the table puts them, the flange at (-0.112, 0.13, 1.526)",
            lambda T, q: near(T, frames(q)),
            seen=_off,
            where=lambda q: not q.any(),
        ),
        Property(
            "frame 1 stands on the base, d = 0.333 above it, and turns with the first angle alone",
            lambda T, q: near(T[0], frames(q)[0]),
            seen=_off,
        ),
        Property(
            "each frame, seen from the one before, is the step of its row: dh_modified(a, alpha, d, q[i])",
            lambda T, q: not _regular(T) or near(_in_the_one_before(T)[:7], steps(q)[:7]),
            seen=_off_from_the_one_before,
        ),
        Property(
            f"the flange is {FLANGE} m along the z axis of frame 7, and turned as frame 7",
            lambda T, q: not _regular(T) or near(_in_the_one_before(T)[7], steps(q)[7]),
            seen=_off_from_the_one_before,
        ),
        Property(
            "frame i stands in the world at T_world_base T_1 ... T_i",
            lambda T, q: near(T, frames(q)),
            seen=_off,
        ),
    ),
    mistakes=MISTAKES,
    hints=(
        "Begin where the base stands: T = rigid.transform(np.eye(3), [-0.2, 0.13, 0.6]).",
        "For each row of the table and its angle: T = T @ dh_modified(a, alpha, d, theta), and append T to a list.",
        "The flange: append T @ rigid.transform(np.eye(3), [0, 0, 0.107]). Return np.array(list), shape (8, 4, 4).",
    ),
    forbidden=("course_lib.arms.panda", "course_lib.arms.SerialArm"),
)
