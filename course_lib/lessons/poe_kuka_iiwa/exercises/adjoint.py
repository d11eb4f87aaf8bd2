"""adjoint: find the bug. The matrix takes twists from one frame to another."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.special_cases import SMALL, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import any_pose, near, part_is, pose
from course_lib.lessons.poe_kuka_iiwa.exercises.shared import (
    BLOCK,
    COLUMN,
    in_blocks,
    nearly_identity,
)
from course_lib.rigid import adjoint, hat_se3, inverse, vee_se3
from course_lib.rotations import hat, random_rotations, rot_x, rot_y, rot_z

_UPPER, _LOWER = slice(0, 3), slice(3, 6)
_UPPER_LEFT, _LOWER_LEFT, _LOWER_RIGHT = (_UPPER, _UPPER), (_LOWER, _UPPER), (_LOWER, _LOWER)
_ON_POSES = Mistake(
    "the answer is 4 x 4, a pose or the matrix of a twist",
    "Twists (omega, v) have six entries: the adjoint is a 6 x 6 matrix of four blocks.",
)
_NESTED = Mistake(
    "the four blocks stand in an array of arrays", "np.block joins blocks to one matrix, (6, 6)."
)


def _cases(rng):
    far, quarter = np.array([1.0, 2, 3]), np.pi / 2
    named = [pose(rot(quarter), far) for rot in (rot_x, rot_y, rot_z)]
    drawn = [
        pose(R, size * rng.normal(size=3))
        for R, size in zip(random_rotations(3, rng), (1, 1, 100), strict=True)
    ]
    plain = [pose(np.eye(3), far), pose(rot_z(quarter), 0 * far), np.eye(4)]
    return [(T,) for T in (*named, any_pose(rng), *drawn, *plain)]


def _carried(T, twist):
    return vee_se3(T @ hat_se3(twist) @ inverse(T))


def _carried_off(A, T):
    off = [np.abs(A @ twist - _carried(T, twist)).max() for twist in np.eye(6)]
    twist = np.eye(6)[np.argmax(off)]
    right, yours = format_tuple(_carried(T, twist)), format_tuple(A @ twist)
    return f"For V = {format_tuple(twist)} that is the twist {right}; your Ad V is {yours}."


EXERCISE = Exercise(
    name="adjoint",
    points=2,
    arguments=("T",),
    cases=_cases,
    returns=numbers(lambda T: (6, 6)),
    library=adjoint,
    sweeps=(Sweep("nearly the identity", lambda rng, size: (nearly_identity(rng, size),), SMALL),),
    properties=(
        part_is(
            "the upper left 3x3 block is R: an angular velocity is rotated from frame b to frame a",
            adjoint,
            _UPPER_LEFT,
            Mistake("the upper left block is not R", "How does frame a see the omega of frame b?"),
            "The {} column of the block",
        ),
        Property(
            "the upper right 3x3 block is zero: the angular velocity does not depend on v",
            lambda A, T: np.abs(A[_UPPER, _LOWER]).max() <= EXACT,
            mistake=Mistake(
                "the upper right block is not zero", "Does omega depend on v, or v on omega?"
            ),
        ),
        part_is(
            "the lower right 3x3 block is R: without a rotation, v is rotated from frame b to "
            "frame a",
            adjoint,
            _LOWER_RIGHT,
            what="The {} column of the block",
        ),
        Property(
            "Ad V is the same motion seen from frame a: [Ad V] = T [V] T^-1",
            lambda A, T: all(near(A @ twist, _carried(T, twist)) for twist in np.eye(6)),
            says=_carried_off,
        ),
    ),
    hints=(
        "Run adjoint on a pose that rotates by 90 degrees, and compare [Ad V] with T [V] T^-1 for "
        "the six twists "
        "np.eye(6). Which columns are off?",
        "Frame a sees omega as R omega, and v as R v + p x (R omega).",
        "Four 3x3 blocks; the lower two are right. Above, omega is rotated as v is below.",
    ),
    forbidden=("course_lib.rigid.adjoint",),
    broken=lambda T: in_blocks(T, lambda R, P, zero: [[R.T, zero], [P @ R, R]]),
)

EXERCISE.mistake(_ON_POSES, form=(4, 4))
EXERCISE.mistake(_NESTED, form=(2, 2, 3, 3))


@EXERCISE.mistake(
    "[p] and R are in the wrong order, or R is missing or transposed in the lower left block",
    "In which frame is p given, and in which frame must omega be before the cross product?",
    part=_LOWER_LEFT,
    coupling=(lambda R, P: R @ P, lambda R, P: P, lambda R, P: P @ R.T),
)
def order_of_the_coupling(T, coupling):
    return coupling(T[BLOCK], hat(T[COLUMN]))


@EXERCISE.mistake(
    "the sign of the lower left block is changed",
    "The new v contains p x (R omega). Does your block give this product, or the opposite one?",
    part=_LOWER_LEFT,
    coupling=(lambda R, P: P @ R, lambda R, P: P @ R.T, lambda R, P: R @ P),
)
def sign_of_the_coupling(T, coupling):
    return -coupling(T[BLOCK], hat(T[COLUMN]))
