"""dh_modified: the pose of a frame in the previous frame by Craig's convention."""

import functools
import itertools

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.kinds import ANGLE, LENGTH
from course_lib.checks.mistake import Mistake
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import LAST_ROW
from course_lib.lessons.panda_dh_ik.exercises.shared import about_x, about_z, modified, standard
from course_lib.rigid import transform

_CASES = (
    (0.1, 0.0, 0.3, 0.0),
    (0.1, np.pi / 2, 0.3, 0.0),
    (0.1, 0.0, 0.3, np.pi / 2),
    (2.0, 1.0, 3.0, -2.0),
    (0.0, 0.0, 0.0, 0.0),
    (1.0, 0.0, 0.0, 0.0),
    (0.0, 0.0, 1.0, 0.0),
    (0.0, 0.0, 0.0, 1.0),
    (0.0, 1.0, 0.0, 0.0),
)


def _product(order):
    """Return the answer that multiplies Rot_x, Trans_x, Rot_z and Trans_z in another order."""

    def answer(a, alpha, d, theta):
        steps = {
            "X": about_x(alpha),
            "a": transform(np.eye(3), [a, 0, 0]),
            "Z": about_z(theta),
            "d": about_z(0.0, d),
        }
        return functools.reduce(np.matmul, [steps[name] for name in order])

    return answer


def _other_orders():
    """Return the answers of the orders whose products differ, and from both conventions."""
    row, answers = (0.3, 0.5, 0.7, 0.9), []
    known = [modified(*row), standard(*row)]
    for answer in map(_product, itertools.permutations("XaZd")):
        if not any(np.allclose(answer(*row), T) for T in known):
            known.append(answer(*row))
            answers.append(answer)
    return answers


def _of_both(rotation, position):
    """Return the answer with the rotation of one answer and the position of another."""
    return lambda *row: np.hstack([rotation(*row)[:, :3], position(*row)[:, 3:]])


def _in_degrees(convert):
    return lambda a, alpha, d, theta: modified(a, convert(alpha), d, convert(theta))


def _small_entries_lost(T, *row):
    wrong = np.abs(T - modified(*row)) > EXACT
    return bool(wrong.any() and (np.abs(modified(*row))[wrong] < 0.02).all() and not T[wrong].any())


_STEPS_APART = "the steps are returned, not their product"
_WHICH_PRODUCT = "The answer is one pose. Which product joins the steps?"

EXERCISE = declared(
    "dh_modified",
    points=1,
    arguments={"a": LENGTH, "alpha": ANGLE, "d": LENGTH, "theta": ANGLE},
    cases=_CASES,
    tolerance=EXACT,
    library=modified,
    properties=(LAST_ROW,),
    says="the frame is moved by a along the old x and rotated by alpha about it, then moved by d "
    "along the new z and rotated by theta about it",
    hints=(
        "Make two poses: one rotates about x and moves along x, the other rotates about z and "
        "moves along z.",
        "rigid.transform(rotations.rot_x(alpha), [a, 0, 0]) is the first of them.",
        "In the modified convention the pose along x is the left factor: along_x @ along_z.",
    ),
    forbidden=("course_lib.arms.SerialArm", "course_lib.arms._dh_frames"),
    mistakes=(
        Mistake(_STEPS_APART, _WHICH_PRODUCT, form=(4, 4, 4)),
        Mistake(_STEPS_APART, _WHICH_PRODUCT, form=(2, 4, 4)),
        Mistake(
            "the pose, its rotation or its position is that of the standard convention",
            "Which pair of steps comes first in the modified convention, that of x or that of z?",
            standard,
            _of_both(rotation=standard, position=modified),
            _of_both(rotation=modified, position=standard),
        ),
        Mistake(
            "the steps are multiplied in another order",
            "Each factor acts along the axes that the factors to its left have made. Which of a "
            "and d is measured along an old axis, and which along a new axis?",
            *_other_orders(),
        ),
        Mistake(
            "the two poses are multiplied entry by entry",
            "A * B multiplies each entry of A by one entry of B. Which operator is the product of "
            "two matrices?",
            lambda a, alpha, d, theta: about_x(alpha, a) * about_z(theta, d),
        ),
        Mistake(
            "the angles are taken for degrees, or converted to degrees",
            "In which unit are the angles given?",
            _in_degrees(np.deg2rad),
            _in_degrees(np.rad2deg),
        ),
        Mistake(
            "small entries are set to 0, or rounded",
            "How far does an angle of a millionth of a radian move the end of an arm of 1 m?",
            seen=_small_entries_lost,
        ),
    ),
)
