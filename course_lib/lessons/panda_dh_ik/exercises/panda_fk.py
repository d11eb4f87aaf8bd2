"""panda_fk: the poses of the Panda's frames and its flange in the world."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.special_cases import SMALL, Sweep
from course_lib.checks.vocabulary import LAST_ROW, SAME_TWICE, compared, near, products
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
            "there is one pose too many, perhaps that of the base",
            "Which frame does the task name as the first of the eight?",
        )
    if array.shape == (7, 4, 4):
        return Mistake(
            "there is one pose too few",
            "The task asks for eight poses: those of seven frames, and one more. Which one do you "
            "not return?",
        )
    if array.shape == (8, 3):
        return Mistake(
            "only the positions are returned", "Each of the eight is a pose of shape (4, 4)."
        )
    return None


def _cases(rng):
    bent = np.array([0.4, 0.5, -0.3, -1.6, 0.8, 1.9, 0.6])
    one = [np.where(np.arange(7) == i, np.pi / 2 if i % 2 else 0.5, 0.0) for i in range(7)]
    drawn = list(np.round(rng.uniform(shared.LOW, shared.HIGH, (4, 7)), 2))
    whole = np.array([1, -1, 0, -2, 0, 2, 1])
    return [(q,) for q in (shared.READY, np.zeros(7), bent, *one, *drawn, whole, drawn[0])]


def steps(q):
    """Return each frame in the previous frame, and the flange in frame 7, (8, 4, 4)."""
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
        wanted, yours, what = right[k, :3, 3], T[k, :3, 3], "Its position is"
    else:
        i = int(np.argmax(np.abs(T[k] - right[k]).max(0)))
        wanted, yours, what = right[k, :3, i], T[k, :3, i], f"Its {'xyz'[i]} axis is"
    row = f" (modified_table[{k}])" if k < 7 else ""
    difference = f"{what} {compared(wanted, yours)}."
    return f"The first pose that differs is that of {_NAMES[k]}{row}. {difference}"


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
            "frame 1 is on the base, d = 0.333 above it, and rotates with the first angle only",
            lambda T, q: near(T[0], shared.frames(q)[0]),
            says=_off,
            mistake=Mistake(
                "frame 1 is not T_w0 T_1",
                "Compute T_w0 @ dh_modified(*modified_table[0], q[0]), and compare it with your "
                "first "
                "pose.",
            ),
        ),
        Property(
            "the pose of frame i in the world is T_w0 T_1 ... T_i",
            lambda T, q: near(T, shared.frames(q)),
            _off,
            mistake=Mistake(
                "a pose is not the previous pose times its own step",
                "Multiply your previous pose by the step of the pose named below, and compare the "
                "product with your pose. For the flange the step is the pose `flange`.",
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
    sweeps=(Sweep("small angles", lambda rng, size: (shared.READY + size,), SMALL),),
    angles=("q",),
    forbidden=("course_lib.arms.panda", "course_lib.arms.SerialArm"),
)

EXERCISE.mistake(form=_known_form)


@EXERCISE.mistake(
    "the base is left out, so that the poses are seen from the base",
    "Where is the base in the world?",
)
def base_left_out(q):
    return _chain(*steps(q), base=np.eye(4))


@EXERCISE.mistake(
    "only some of the poses are seen from the world, and the others from the base",
    "From which frame does the task want all eight poses to be seen?",
)
def flange_alone_in_the_world(q):
    poses = _chain(*steps(q), base=np.eye(4))
    poses[-1] = shared.T_W0 @ poses[-1]
    return poses


@EXERCISE.mistake(
    "the first pose is that of the base, and the other frames follow one place later",
    "Which frame does the task name as the first of the eight?",
)
def base_first(q):
    right = shared.frames(q)
    return np.array([shared.T_W0, *right[:6], right[-1]])


@EXERCISE.mistake(
    "one array stands in several places, so that its last change shows in all of them",
    "Which line changes T in place, and what does the list hold after it: one array, or several?",
    flange_too=(True, False),
)
def one_array(q, flange_too):
    right = shared.frames(q)
    last = right[-1] if flange_too else right[-2]
    return np.array([last] * 7 + [right[-1]])


@EXERCISE.mistake(
    "the angles are clipped to the joint limits",
    "Does the task restrict the angles for which the poses are wanted?",
)
def clipped(q):
    return shared.frames(np.clip(q, shared.LOW, shared.HIGH))
