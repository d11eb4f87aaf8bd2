"""nearest_so: the rotation nearest to a damaged one.

The given code returns a rotation, but not the nearest.
"""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.kinds import Kind
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import SMALL, SMALL_NUMBERS
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import any_rotation, no_rotation, orthogonality_error
from course_lib.lessons.rotations.exercises import shared
from course_lib.lessons.rotations.exercises.shared import NOT_NEAREST, distances, ones, polar
from course_lib.rotations import nearest_so

DAMAGED = Kind(
    drawn=lambda rng: any_rotation(rng) @ np.diag([2.0, 1.0, 0.5]),
    named=lambda rng: [
        *shared.damaged_rotations(rng),
        any_rotation(rng),
        np.eye(2),
        np.eye(3),
        *(shared.large_whole_numbers(rng, sign) for sign in (1, -1)),
    ],
    beside=(
        ("small entries", shared.nearly_diagonal, SMALL_NUMBERS),
        ("nearly a rotation", shared.nearly_rotation, SMALL),
        ("small or large matrices", shared.of_a_scale, shared.SCALES),
        ("a small singular value", shared.nearly_singular, SMALL),
    ),
    coarse=shared.coarse,
)


def _found(R, M):
    if orthogonality_error(R) > EXACT:
        return no_rotation(R)
    if np.linalg.det(R) > 0:
        return distances(R, M)
    of_yours, of_M = np.linalg.det(R), np.linalg.det(M)
    return f"The determinant of your answer is {of_yours:.0f}, and that of M is {of_M:.3g}."


def _otherwise(R, M):
    if orthogonality_error(R) > EXACT:
        return Question(
            "the answer is not orthogonal",
            "In M = U S V^T only S stretches. Which factors does your answer have for the M below, "
            "and which of them is not orthogonal?",
        )
    if np.linalg.det(R) < 0:
        return Question(
            "the answer is a reflection",
            "U V^T is a reflection if det(U V^T) = -1, and one sign has to change then. What does "
            "your function do with the M below?",
        )
    return NOT_NEAREST


def _sign_of_det_M(sign):
    return lambda M: polar(M, *ones(M), sign(np.linalg.det(M)))


def _transposed_twice(sign):
    """Return U diag(1, ..., sign(det(U V^T))) V, in which V^T should stand."""

    def answer(M):
        U, _, Vt = np.linalg.svd(M)
        return (U * np.array([*ones(M), sign(np.linalg.det(U @ Vt))])) @ Vt.T

    return answer


EXERCISE = declared(
    "nearest_so",
    points=3,
    arguments={"M": DAMAGED},
    tolerance=EXACT,
    library=nearest_so,
    broken=shared.last_column_negated,
    says="R is a rotation, R^T R = I and det R = +1, and no rotation is nearer to M",
    found=_found,
    otherwise=_otherwise,
    hints=(
        "Print the distance from M to your answer, and to a few rotations near it. Is yours the "
        "smallest?",
        "The singular value decomposition M = U S V^T: one of the directions of V is reversed. M "
        "is weakest along the one with the smallest singular value, which is the last.",
        "So the sign belongs between U and V^T: U diag(1, ..., det(U V^T)) V^T.",
    ),
    forbidden=("course_lib.rotations.nearest_so", "course_lib.rigid.nearest_se"),
    mistakes=(
        Mistake(
            "the sign is put at the largest singular value",
            "Reversing costs least where M is weakest. numpy sorts singular values in descending "
            "order.",
            lambda M: polar(M, np.linalg.det(polar(M)), *ones(M)),
        ),
        Mistake(
            "the sign comes from det M",
            "A singular M has det M = 0, and yet it has a nearest rotation. Which determinant is "
            "always +1 or -1?",
            _sign_of_det_M(np.sign),
            _sign_of_det_M(lambda d: 1.0 if d >= 0 else -1.0),
            _sign_of_det_M(lambda d: d),
        ),
        Mistake(
            "numpy's third result is taken for V",
            "numpy.linalg.svd returns V already transposed.",
            _transposed_twice(lambda d: 1),
            _transposed_twice(lambda d: d),
        ),
    ),
)
