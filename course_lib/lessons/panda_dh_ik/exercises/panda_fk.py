"""panda_fk: the poses of the Panda's frames and its flange in the world."""

import numpy as np

from course_lib.checks.answer_types import OTHER_FORM, numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.vocabulary import LAST_ROW, SAME_TWICE, near, products
from course_lib.lessons.panda_dh_ik.exercises import shared

_FLANGE = shared.about_z(0.0, 0.107)
_NAMES = (*(f"frame {i}" for i in range(1, 8)), "the flange")


def _known_form(array, q):
    """Return the mistake of an array of another shape, or None; a list of more than nine has grown
    with each call."""
    if array.shape[1:] == (4, 4) and len(array) > 9:
        return SAME_TWICE.mistake
    if array.shape == (9, 4, 4):
        return Mistake(
            "there is one pose too many, most likely the base",
            "Which frame is the first of the eight?",
        )
    if array.shape == (8, 3):
        return Mistake(
            "only the positions are returned", "Each of the eight is a whole pose, 4 x 4."
        )
    return None


def _cases(rng):
    bent = np.array([0.4, 0.5, -0.3, -1.6, 0.8, 1.9, 0.6])
    one = [np.where(np.arange(7) == i, np.pi / 2 if i % 2 else 0.5, 0.0) for i in range(7)]
    drawn = list(np.round(rng.uniform(shared.LOW, shared.HIGH, (4, 7)), 2))
    return [(q,) for q in (shared.READY, np.zeros(7), bent, *one, *drawn, drawn[0])]


def steps(q):
    """Return each frame in the one before, and the flange in the last: (8, 4, 4)."""
    return np.array(
        [shared.modified(*row, theta) for row, theta in zip(shared.TABLE, q, strict=True)]
        + [_FLANGE]
    )


def _chain(*steps, base=shared.T_W0):
    return np.array(products([base, *steps])[2:])


def _off(T, q):
    """Return in words which of your poses is the first that is wrong, and in what."""
    right = shared.frames(q)
    k = next(k for k in range(8) if not near(T[k], right[k]))
    if not near(T[k, :3, 3], right[k, :3, 3]):
        wanted, yours, what = right[k, :3, 3], T[k, :3, 3], "is at"
    else:
        i = int(np.argmax(np.abs(T[k] - right[k]).max(0)))
        wanted, yours, what = right[k, :3, i], T[k, :3, i], f"has its {'xyz'[i]} axis along"
    row = f" (row {k + 1} of the table)" if k < 7 else ""
    return (
        f"The first that differs is {_NAMES[k]}{row}: it {what} {format_tuple(wanted)}, yours "
        f"{format_tuple(yours)}."
    )


EXERCISE = Exercise(
    name="panda_fk",
    points=2,
    arguments=("q",),
    cases=_cases,
    returns=numbers(lambda q: (8, 4, 4)),
    properties=(
        SAME_TWICE,
        LAST_ROW,
        Property(
            "frame 1 is on the base, d = 0.333 above it, and rotates with the first angle alone",
            lambda T, q: near(T[0], shared.frames(q)[0]),
            says=_off,
            mistake=Mistake(
                "frame 1 is not T_w0 T_1",
                "On which side does T_1 stand, and is your row (a, alpha, d)?",
            ),
        ),
        Property(
            "the pose of frame i in the world is T_w0 T_1 ... T_i",
            lambda T, q: near(T, shared.frames(q)),
            _off,
            mistake=Mistake(
                "a pose is not the one before it times its own step",
                "T = T @ dh_modified(...) makes a new array. Which frame is the first that is off, "
                "and by which row?",
            ),
        ),
    ),
    hints=(
        "Begin with the pose of the base in the world, and multiply by one step for each row of "
        "the table.",
        "In the loop: T = T @ dh_modified(a, alpha, d, theta). Append each T to a list.",
        "The flange is T @ rigid.transform(np.eye(3), [0, 0, 0.107]). Return np.array(list), shape "
        "(8, 4, 4).",
    ),
    library=shared.frames,
    forbidden=("course_lib.arms.panda", "course_lib.arms.SerialArm"),
)

EXERCISE.mistake(OTHER_FORM, form=_known_form)


@EXERCISE.mistake(
    "the base is left out: these are poses seen from the base",
    "Where is the base in the world?",
)
def base_left_out(q):
    return _chain(*steps(q), base=np.eye(4))
