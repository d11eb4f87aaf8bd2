"""nearest_so: the rotation nearest to a damaged one."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.rotations import nearest_so, random_rotations

# The block of the 4x4 matrix that the source report corrects: its determinant is negative.
_PUBLISHED = np.array(
    [[0.69942428, 0.57542726, 0.83226602], [0.51703353, 0.77526382, 0.78676897], [0.99073504, 0.09942187, 0.47534292]]
)

# Rank 2, and exactly so in floating point: det M is 0 and tells nothing of the sign of det(U V^T), which differs
# between this matrix and its negative. The nearest rotation is unique all the same.
_SINGULAR = np.array([[1.0, 2.0, 3.0], [2.0, 4.0, 6.0], [1.0, 0.0, 1.0]])


def damaged_rotations(rng):
    """Square matrices, each with one nearest rotation: singular values well apart."""
    turns = random_rotations(3, rng)
    scaled = turns[0] @ np.diag([2.0, 1.0, 0.5])
    mirrored = turns[1] @ np.diag([1.5, 1.0, -0.4])
    return [
        np.array([[2.0, 0.0], [0.0, 1.0]]),
        np.array([[0.9, -0.5], [0.5, 0.8]]),
        np.array([[1.0, 0.0], [0.0, -0.4]]),
        np.array([[0.3, 0.9], [0.8, 0.1]]),
        turns[2] + 0.1 * rng.normal(size=(3, 3)),
        scaled,
        _PUBLISHED,
        mirrored,
        _SINGULAR,
        -_SINGULAR,
    ]


def _so_cases(rng):
    return [(np.eye(2),), (np.eye(3),), *((M,) for M in damaged_rotations(rng)), (random_rotations(1, rng)[0],)]


def is_exact_rotation(M):
    return np.abs(M.T @ M - np.eye(len(M))).max() < 1e-9 and np.linalg.det(M) > 0


def polar(M, *signs):
    """U diag(signs) V^T; without signs U V^T, which is a reflection where det M < 0."""
    U, _, Vt = np.linalg.svd(M)
    return (U * np.array(signs)) @ Vt if signs else U @ Vt


def last_column_negated(M):
    """The published correction."""
    R = polar(M)
    return R @ np.diag([*[1.0] * (len(M) - 1), np.linalg.det(R)])


def gram_schmidt(M):
    Q, upper = np.linalg.qr(M)
    return Q * np.sign(np.diag(upper))


def _ones(M):
    return [1.0] * (len(M) - 1)


def _sign(M):
    return np.linalg.det(polar(M))


def _right_handed(Q):
    """Q with its last column turned where det Q < 0."""
    return Q @ np.diag([*_ones(Q), np.sign(np.linalg.det(Q))])


def _v_transposed_twice(M):
    U, _, Vt = np.linalg.svd(M)
    return (U * np.array([*_ones(M), np.linalg.det(U @ Vt)])) @ Vt.T


def distances(R, M):
    return (
        f"Yours lies at distance {np.linalg.norm(M - R):.4f} (Frobenius norm), the nearest at "
        f"{np.linalg.norm(M - nearest_so(M)):.4f}."
    )


NEAREST_SO = Exercise(
    name="nearest_so",
    points=3,
    arguments=("M",),
    cases=_so_cases,
    returns=numbers(np.shape),
    properties=(
        Property(
            "a rotation comes back unchanged",
            lambda R, M: np.abs(R - M).max() < 1e-9,
            where=is_exact_rotation,
        ),
        Property(
            "the columns of R have length one and are orthogonal: R^T R = I",
            lambda R, M: np.abs(R.T @ R - np.eye(len(R))).max() < 1e-9,
            mistake=Mistake("the answer is not orthogonal", "With M = U S V^T, U V^T has orthonormal columns."),
        ),
        Property(
            "R is no reflection: det R = +1",
            lambda R, M: np.linalg.det(R) > 0,
            seen=lambda R, M: f"det R is {np.linalg.det(R):.0f}; det M is {np.linalg.det(M):.3g}.",
            mistake=Mistake("the answer is a reflection", "Where det(U V^T) = -1, a sign must be turned. Which one?"),
        ),
        Property(
            "no rotation lies nearer to M than R",
            lambda R, M: np.linalg.norm(M - R) < np.linalg.norm(M - nearest_so(M)) + 1e-9,
            seen=distances,
        ),
    ),
    mistakes=(
        Mistake("M comes back as it is", "U S V^T is M again: leave S out.", np.copy),
        Mistake(
            "U V^T is returned as it is, a reflection where det M < 0",
            "Put the sign inside: U diag(1, ..., det(U V^T)) V^T.",
            polar,
        ),
        Mistake(
            "the last column of U V^T is negated, as in the published report",
            "That is a rotation, but not the nearest. The smallest singular value is the cheapest to turn: "
            "its sign belongs between U and V^T.",
            last_column_negated,
        ),
        Mistake(
            "the last row of U V^T is negated",
            "That is a rotation, but not the nearest: negate the last row of V^T, before the product.",
            lambda M: np.diag([*_ones(M), _sign(M)]) @ polar(M),
        ),
        Mistake(
            "the sign is put at the largest singular value",
            "The smallest one costs least: numpy sorts them downwards, so it is the last.",
            lambda M: polar(M, _sign(M), *_ones(M)),
        ),
        Mistake(
            "all of U V^T is negated",
            "For n = 2 that leaves the determinant as it is; for n = 3 it makes it +1, but turns all three axes "
            "round. One sign is enough.",
            lambda M: _sign(M) * polar(M),
        ),
        Mistake("the sign is turned always", "Only where det(U V^T) = -1.", lambda M: polar(M, *_ones(M), -1.0)),
        Mistake(
            "det M is asked for the sign",
            "A singular M has det M = 0, and a nearest rotation all the same. Ask det(U V^T): it is +1 or -1.",
            lambda M: polar(M, *_ones(M), np.sign(np.linalg.det(M))),
            lambda M: polar(M, *_ones(M), 1.0 if np.linalg.det(M) >= 0 else -1.0),
            lambda M: polar(M, *_ones(M), 1.0 if np.linalg.det(M) > 0 else -1.0),
        ),
        Mistake(
            "the columns are made orthogonal one after the other (Gram-Schmidt, QR)",
            "That favours the first column. The nearest rotation treats all alike: singular value decomposition.",
            gram_schmidt,
            lambda M: _right_handed(gram_schmidt(M)),
            lambda M: np.linalg.qr(M)[0],
            lambda M: _right_handed(np.linalg.qr(M)[0]),
        ),
        Mistake(
            "the columns are only scaled to length one",
            "They must be at right angles to each other too.",
            lambda M: M / np.linalg.norm(M, axis=0),
        ),
        Mistake(
            "the transpose is returned",
            "numpy.linalg.svd returns U, S and V^T (not V): the product is U @ Vt.",
            lambda M: nearest_so(M).T,
        ),
        Mistake(
            "numpy's third result is taken for V",
            "numpy.linalg.svd returns U, S and V^T: do not transpose it again.",
            _v_transposed_twice,
        ),
        Mistake(
            "U * Vt, entry by entry, stands for the matrix product",
            "In numpy the matrix product is @.",
            lambda M: np.multiply(*np.linalg.svd(M)[::2]),
        ),
    ),
    hints=(
        "The singular value decomposition M = U S V^T: replace S by something that makes it a rotation.",
        "U V^T is orthogonal. Its determinant is +1 or -1: if -1, one sign must change.",
        "U diag(1, ..., det(U V^T)) V^T: the sign meets the smallest singular value.",
    ),
    forbidden=("course_lib.rotations.nearest_so", "course_lib.rigid.nearest_se"),
)
