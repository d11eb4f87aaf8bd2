"""adjoint: find the bug. The matrix takes twists from one frame to another."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.exercise import Property
from course_lib.checks.kinds import POSE
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import part_is
from course_lib.lessons.poe_kuka_iiwa.exercises.shared import BLOCK, COLUMN, in_blocks
from course_lib.rigid import adjoint
from course_lib.rotations import hat

_UPPER, _LOWER = slice(0, 3), slice(3, 6)


def _coupling(of):
    """Return the answer of(R, [p]) in the lower left block."""
    return lambda T: of(T[BLOCK], hat(T[COLUMN]))


EXERCISE = declared(
    "adjoint",
    points=2,
    arguments={"T": POSE},
    library=adjoint,
    says="Ad V is the same motion seen from frame a: [Ad V] = T [V] T^-1",
    properties=(
        part_is(
            "the upper left 3x3 block is R: an angular velocity is rotated from frame b to frame a",
            adjoint,
            (_UPPER, _UPPER),
            Question(
                "the upper left block is not R",
                "Which line of yours fills this block? How does frame a see the omega of frame b?",
                of_the_formula=True,
            ),
            "The {} column of the block",
        ),
        Property(
            "the upper right 3x3 block is zero: the angular velocity does not depend on v",
            lambda A, T: np.abs(A[_UPPER, _LOWER]).max() <= EXACT,
            otherwise=Question(
                "the upper right block is not zero",
                "Which line of yours fills this block? Does omega depend on v, or v on omega?",
            ),
        ),
    ),
    broken=lambda T: in_blocks(T, lambda R, P, zero: [[R.T, zero], [P @ R, R]]),
    hints=(
        "Run adjoint on a pose that rotates by 90 degrees, and compare [Ad V] with T [V] T^-1 for "
        "the six twists np.eye(6). Which columns are off?",
        "Frame a sees omega as R omega, and v as R v + p x (R omega).",
        "Four 3x3 blocks; the lower two are right. Above, omega is rotated as v is below.",
    ),
    forbidden=("course_lib.rigid.adjoint",),
    mistakes=(
        Mistake(
            "the answer is 4 x 4, a pose or the matrix of a twist",
            "Twists (omega, v) have six entries: the adjoint is a 6 x 6 matrix of four blocks.",
            form=(4, 4),
        ),
        Mistake(
            "the four blocks stand in an array of arrays",
            "np.block joins blocks to one matrix, (6, 6).",
            form=(2, 2, 3, 3),
        ),
        Mistake(
            "[p] and R are in the wrong order, or R is missing or transposed in the lower left "
            "block",
            "In which frame must omega be before the cross product?",
            _coupling(lambda R, P: R @ P),
            _coupling(lambda R, P: P),
            _coupling(lambda R, P: P @ R.T),
            part=(_LOWER, _UPPER),
        ),
        Mistake(
            "the sign of the lower left block is changed",
            "The new v contains p x (R omega). Does your block give this product, or the opposite "
            "one?",
            _coupling(lambda R, P: -P @ R),
            _coupling(lambda R, P: -P @ R.T),
            _coupling(lambda R, P: -R @ P),
            part=(_LOWER, _UPPER),
        ),
    ),
)
