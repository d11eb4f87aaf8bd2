"""panda_fk: the poses of the Panda's frames and its flange in the world."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.kinds import joint_angles
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.naming import KEPT_FOR_THE_NEXT_CALL
from course_lib.checks.special_cases import SMALL
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import LAST_ROW, SAME_TWICE, compared, near, products
from course_lib.lessons.panda_dh_ik.exercises import shared

_FLANGE = shared.about_z(0.0, 0.107)
_NAMES = (*(f"frame {i}" for i in range(1, 8)), "the flange")


def _has_grown(array, q):
    """Return whether a list holds more poses than one call makes."""
    return array.shape[1:] == (4, 4) and len(array) > 9


def _named(rng):
    bent = np.array([0.4, 0.5, -0.3, -1.6, 0.8, 1.9, 0.6])
    one = [np.where(np.arange(7) == i, np.pi / 2 if i % 2 else 0.5, 0.0) for i in range(7)]
    whole = np.array([1.0, -1, 0, -2, 0, 2, 1])
    far = np.array([8.0, -9, 7, -10, 12, 9, -8])  # whole, and beyond one revolution
    return [shared.READY, np.zeros(7), bent, *one, whole, far]


def _found(T, q):
    """Return in words which pose is the first that is wrong, and in what."""
    right = shared.frames(q)
    k = next(k for k in range(8) if not near(T[k], right[k]))
    if not near(T[k, :3, 3], right[k, :3, 3]):
        wanted, yours, what = right[k, :3, 3], T[k, :3, 3], "Its position is"
    else:
        i = int(np.argmax(np.abs(T[k] - right[k]).max(0)))
        wanted, yours, what = right[k, :3, i], T[k, :3, i], f"Its {'xyz'[i]} axis is"
    row = f" (modified_table[{k}])" if k < 7 else ""
    pose = f"The first pose that differs is that of {_NAMES[k]}{row}."
    return f"{pose} {what} " + compared(wanted, yours) + "."


def _from_the_base(q):
    steps = [shared.modified(*row, theta) for row, theta in zip(shared.TABLE, q, strict=True)]
    return np.array(products([*steps, _FLANGE])[1:])


def _flange_alone_in_the_world(q):
    return np.array([*_from_the_base(q)[:-1], shared.frames(q)[-1]])


def _base_first(q):
    right = shared.frames(q)
    return np.array([shared.T_W0, *right[:6], right[-1]])


def _base_first_and_no_flange(q):
    return np.array([shared.T_W0, *shared.frames(q)[:7]])


def _one_array(which):
    """Return the answer whose seven frames are all the pose `which`."""
    return lambda q: np.array([shared.frames(q)[which]] * 7 + [shared.frames(q)[-1]])


EXERCISE = declared(
    "panda_fk",
    points=2,
    arguments={
        "q": joint_angles(7).but(
            drawn=lambda rng: np.round(rng.uniform(shared.LOW, shared.HIGH), 2),
            named=_named,
            beside=(("small angles", lambda rng, size: shared.READY + size, SMALL),),
            small=True,
        )
    },
    tolerance=EXACT,
    library=shared.frames,
    properties=(SAME_TWICE, LAST_ROW),
    says="the pose of frame i in the world is T_w0 T_1 ... T_i",
    found=_found,
    otherwise=Question(
        "a pose is not the previous pose times its own step",
        "Multiply the previous pose by the step of this pose, and compare the product "
        "with your pose. For frame 1 the previous pose is T_w0, and for the flange the step is the "
        "pose `flange`. Which factor differs in your code?",
    ),
    hints=(
        "Begin with the pose of the base in the world, and multiply by one step for each row of "
        "the table.",
        "In the loop: T = T @ dh_modified(a, alpha, d, theta). Append each T to a list.",
        "The flange is T @ rigid.transform(np.eye(3), [0, 0, 0.107]). Return np.array(list), shape "
        "(8, 4, 4).",
    ),
    forbidden=("course_lib.arms.panda", "course_lib.arms.SerialArm"),
    mistakes=(
        Mistake(
            "there is one pose too many, perhaps that of the base",
            "Which frame does the task name as the first of the eight?",
            form=(9, 4, 4),
        ),
        Mistake(
            "there is one pose too few",
            "The task asks for eight poses: those of seven frames, and one more. Which one do you "
            "not return?",
            form=(7, 4, 4),
        ),
        Mistake(
            "only the positions are returned",
            "Each of the eight is a pose of shape (4, 4).",
            form=(8, 3),
        ),
        Mistake(KEPT_FOR_THE_NEXT_CALL.name, KEPT_FOR_THE_NEXT_CALL.hint, form=_has_grown),
        Mistake(
            "the base is left out, so that the poses are seen from the base",
            "Where is the base in the world?",
            _from_the_base,
        ),
        Mistake(
            "only some of the poses are seen from the world, and the others from the base",
            "From which frame does the task want all eight poses to be seen?",
            _flange_alone_in_the_world,
        ),
        Mistake(
            "the first pose is that of the base, and the other frames follow one place later",
            "Which frame does the task name as the first of the eight, and which as the last?",
            _base_first,
            _base_first_and_no_flange,
        ),
        Mistake(
            "one array stands in several places, so that its last change shows in all of them",
            "Which line changes T in place, and what does the list hold after it: one array, or "
            "several?",
            _one_array(-1),
            _one_array(-2),
        ),
        Mistake(
            "the angles are clipped to the joint limits",
            "Does the task restrict the angles for which the poses are wanted?",
            lambda q: shared.frames(np.clip(q, shared.LOW, shared.HIGH)),
        ),
    ),
)
