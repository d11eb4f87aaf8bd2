"""nearest_so: the rotation nearest to a damaged one. The given code returns a rotation, but not the nearest."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.rotations.shared import (
    damaged_rotations,
    distances,
    gram_schmidt,
    is_rotation,
    last_column_negated,
    ones,
    polar,
    right_handed,
)
from course_lib.checks.vocabulary import argument_returned, entry_by_entry, orthogonality_error, transposed
from course_lib.rotations import nearest_so, random_rotations


def _cases(rng):
    return [*((M,) for M in damaged_rotations(rng)), (random_rotations(1, rng)[0],), (np.eye(2),), (np.eye(3),)]


def _sign(M):
    return np.linalg.det(polar(M))


def _v_transposed_twice(M):
    U, _, Vt = np.linalg.svd(M)
    return (U * np.array([*ones(M), np.linalg.det(U @ Vt)])) @ Vt.T


EXERCISE = Exercise(
    name="nearest_so",
    points=3,
    arguments=("M",),
    cases=_cases,
    returns=numbers(np.shape),
    library=nearest_so,
    broken=last_column_negated,
    properties=(
        Property(
            "the columns of R have length one and are orthogonal: R^T R = I",
            lambda R, M: orthogonality_error(R) < 1e-9,
            mistake=Mistake("the answer is not orthogonal", "Which part of M = U S V^T stretches?"),
        ),
        Property(
            "R is not a reflection: det R = +1",
            lambda R, M: np.linalg.det(R) > 0,
            says=lambda R, M: f"det R is {np.linalg.det(R):.0f}; det M is {np.linalg.det(M):.3g}.",
            mistake=Mistake("the answer is a reflection", "If det(U V^T) = -1, one sign has to change. Which one?"),
        ),
        Property("a rotation comes back unchanged", lambda R, M: np.abs(R - M).max() < 1e-9, where=is_rotation),
        Property(
            "no rotation is nearer to M than R",
            lambda R, M: np.linalg.norm(M - R) < np.linalg.norm(M - nearest_so(M)) + 1e-9,
            says=distances,
        ),
    ),
    mistakes=(
        argument_returned(name="M is returned as it came", hint="U S V^T is M again: which factor is not a rotation?"),
        Mistake(
            "U V^T is returned even if it is a reflection",
            "Its determinant is +1 or -1. In the second case one direction has to be reversed: the cheapest.",
            polar,
        ),
        Mistake(
            "the last row of U V^T is negated",
            "The result is a rotation, but the last coordinate axis has nothing to do with M. "
            "In which direction does reversing cost least?",
            lambda M: np.diag([*ones(M), _sign(M)]) @ polar(M),
        ),
        Mistake(
            "the sign is put at the largest singular value",
            "Reversing costs least where M is weakest. numpy sorts singular values in descending order.",
            lambda M: polar(M, _sign(M), *ones(M)),
        ),
        Mistake(
            "all of U V^T is negated",
            "In the plane that leaves the determinant as it is; in space it reverses all three axes. One is enough.",
            lambda M: _sign(M) * polar(M),
        ),
        Mistake(
            "the sign is changed always", "Change it only if U V^T is a reflection.", lambda M: polar(M, *ones(M), -1.0)
        ),
        Mistake(
            "the sign comes from det M",
            "A singular M has det M = 0, and yet it has a nearest rotation. Which determinant is always +1 or -1?",
            lambda M: polar(M, *ones(M), np.sign(np.linalg.det(M))),
            lambda M: polar(M, *ones(M), 1.0 if np.linalg.det(M) >= 0 else -1.0),
            lambda M: polar(M, *ones(M), 1.0 if np.linalg.det(M) > 0 else -1.0),
            lambda M: polar(M, *ones(M), np.linalg.det(M)),
        ),
        Mistake(
            "the columns are made orthogonal one after the other (Gram-Schmidt, QR)",
            "That favours the first column. The nearest rotation treats all columns alike.",
            gram_schmidt,
            lambda M: right_handed(gram_schmidt(M)),
            lambda M: np.linalg.qr(M)[0],
            lambda M: right_handed(np.linalg.qr(M)[0]),
        ),
        Mistake(
            "the columns are only scaled to length one",
            "They must be at right angles to each other too.",
            lambda M: M / np.linalg.norm(M, axis=0),
        ),
        transposed(
            nearest_so, hint="Compare U V^T with M = U S V^T for a matrix M that is nearly a rotation: which is near M?"
        ),
        Mistake(
            "numpy's third result is taken for V", "numpy.linalg.svd returns V already transposed.", _v_transposed_twice
        ),
        entry_by_entry(lambda M: np.multiply(*np.linalg.svd(M)[::2])),
    ),
    hints=(
        "Print the distance from M to your answer, and to a few rotations near it. Is yours the smallest?",
        "The singular value decomposition M = U S V^T: one of the directions of V is reversed. M is weakest along the "
        "one with the smallest singular value, which is the last.",
        "So the sign belongs between U and V^T: U diag(1, ..., det(U V^T)) V^T.",
    ),
    forbidden=("course_lib.rotations.nearest_so", "course_lib.rigid.nearest_se"),
)
