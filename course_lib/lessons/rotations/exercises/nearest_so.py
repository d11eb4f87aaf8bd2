"""nearest_so: the rotation nearest to a damaged one.

The given code returns a rotation, but not the nearest.
"""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.naming import difference
from course_lib.checks.special_cases import SMALL, SMALL_NUMBERS, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import is_rotation, orthogonality_error
from course_lib.lessons.rotations.exercises import shared
from course_lib.lessons.rotations.exercises.shared import (
    NOT_NEAREST,
    damaged_rotations,
    distances,
    nearly_diagonal,
    nearly_rotation,
    ones,
    polar,
)
from course_lib.rotations import nearest_so, random_rotations


def _cases(rng):
    return [
        *((M,) for M in damaged_rotations(rng)),
        (random_rotations(1, rng)[0],),
        (np.eye(2),),
        (np.eye(3),),
    ]


EXERCISE = Exercise(
    name="nearest_so",
    points=3,
    arguments=("M",),
    tolerance=EXACT,
    cases=_cases,
    sweeps=(
        Sweep("small entries", lambda rng, size: (nearly_diagonal(rng, size),), SMALL_NUMBERS),
        Sweep("nearly a rotation", lambda rng, gap: (nearly_rotation(rng, gap),), SMALL),
    ),
    returns=numbers(np.shape),
    library=nearest_so,
    broken=shared.last_column_negated,
    properties=(
        Property(
            "the columns of R have length one and are orthogonal: R^T R = I",
            lambda R, M: orthogonality_error(R) < EXACT,
            mistake=Mistake("the answer is not orthogonal", "Which part of M = U S V^T stretches?"),
        ),
        Property(
            "R is not a reflection: det R = +1",
            lambda R, M: np.linalg.det(R) > 0,
            says=lambda R, M: (
                f"The determinant of your answer is {np.linalg.det(R):.0f}, and that of M is "
                f"{np.linalg.det(M):.3g}."
            ),
            mistake=Mistake(
                "the answer is a reflection",
                "U V^T is a reflection if det(U V^T) = -1: which sign has to change then?",
            ),
        ),
        Property(
            "a rotation comes back unchanged",
            lambda R, M: np.abs(R - M).max() < EXACT,
            where=is_rotation,
        ),
        Property(
            "no rotation is nearer to M than R",
            # By the rotations: their distances from M differ only by the square of the error.
            lambda R, M: difference(R, nearest_so(M)) <= EXACT,
            says=distances,
            mistake=NOT_NEAREST,
        ),
    ),
    hints=(
        "Print the distance from M to your answer, and to a few rotations near it. Is yours the "
        "smallest?",
        "The singular value decomposition M = U S V^T: one of the directions of V is reversed. M "
        "is weakest along the "
        "one with the smallest singular value, which is the last.",
        "So the sign belongs between U and V^T: U diag(1, ..., det(U V^T)) V^T.",
    ),
    forbidden=("course_lib.rotations.nearest_so", "course_lib.rigid.nearest_se"),
)


@EXERCISE.mistake(
    "the sign is put at the largest singular value",
    "Reversing costs least where M is weakest. numpy sorts singular values in descending order.",
)
def largest_singular_value(M):
    return polar(M, np.linalg.det(polar(M)), *ones(M))


@EXERCISE.mistake(
    "the sign comes from det M",
    "A singular M has det M = 0, and yet it has a nearest rotation. Which determinant is always "
    "+1 or -1?",
    sign=(np.sign, lambda d: 1.0 if d >= 0 else -1.0, lambda d: d),
)
def sign_of_det_M(M, sign):
    return polar(M, *ones(M), sign(np.linalg.det(M)))


@EXERCISE.mistake(
    "numpy's third result is taken for V",
    "numpy.linalg.svd returns V already transposed.",
    negated=(False, True),
)
def v_transposed_twice(M, negated):
    U, _, Vt = np.linalg.svd(M)
    return (U * np.array([*ones(M), np.linalg.det(U @ Vt) if negated else 1])) @ Vt.T
