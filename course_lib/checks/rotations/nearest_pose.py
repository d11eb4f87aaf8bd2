"""nearest_se: the pose nearest to a damaged one."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.rotations.nearest import (
    damaged_rotations,
    distances,
    gram_schmidt,
    is_exact_rotation,
    last_column_negated,
    polar,
)
from course_lib.checks.rotations.poses import pose
from course_lib.rigid import nearest_se
from course_lib.rotations import nearest_so, random_rotations


def _damaged_pose(M, p):
    return pose(M, p[: len(M)], *(0.1 * np.arange(1, len(M) + 2)))


def _nearest_se_cases(rng):
    p = rng.normal(size=3)
    good = [np.eye(3), np.eye(4), pose(random_rotations(1, rng)[0], p)]
    return [(T,) for T in good + [_damaged_pose(M, p) for M in damaged_rotations(rng)]]


def _valid_pose(T):
    return is_exact_rotation(T[:-1, :-1]) and np.array_equal(T[-1], np.eye(len(T))[-1])


def _mended(T, block=nearest_so, translation=lambda R, p: p, row=lambda row: np.eye(len(row))[-1]):
    """T put together from a new block, translation and row."""
    R = block(T[:-1, :-1])
    return pose(R, translation(R, T[:-1, -1]), *row(T[-1]))


NEAREST_SE = Exercise(
    name="nearest_se",
    points=2,
    arguments=("T",),
    cases=_nearest_se_cases,
    returns=numbers(np.shape),
    properties=(
        Property("a pose comes back unchanged", lambda X, T: np.abs(X - T).max() < 1e-9, where=_valid_pose),
        Property(
            "the last row is (0, ..., 0, 1)",
            lambda X, T: np.abs(X[-1] - np.eye(len(T))[-1]).max() < 1e-9,
            mistake=Mistake("the last row stays as it came", "Write it anew: T[-1] = (0, ..., 0, 1)."),
        ),
        Property(
            "the translation (the last column) stays as it is",
            lambda X, T: np.abs(X[:-1, -1] - T[:-1, -1]).max() < 1e-9,
            mistake=Mistake("the translation is changed", "Only the block T[:-1, :-1] and the last row need mending."),
        ),
        Property(
            "the block is a rotation",
            lambda X, T: is_exact_rotation(X[:-1, :-1]),
            mistake=Mistake("the block is no rotation", "Your nearest_so turns T[:-1, :-1] into one."),
        ),
        Property(
            "the block is the rotation nearest to that of T",
            lambda X, T: np.linalg.norm(X - nearest_se(T)) < 1e-6,
            seen=lambda X, T: distances(X[:-1, :-1], T[:-1, :-1]),
        ),
    ),
    mistakes=(
        Mistake(
            "the last row stays as it came",
            "Write it anew: T[-1] = (0, ..., 0, 1).",
            lambda T: _mended(T, row=lambda row: row),
        ),
        Mistake(
            "of the last row only the 1 is written",
            "The others are 0 in a pose.",
            lambda T: _mended(T, row=lambda row: [*row[:-1], 1.0]),
        ),
        Mistake(
            "T is divided by its last entry",
            "That scales the translation. Only the block and the row are mended.",
            lambda T: _mended(T / T[-1, -1]),
            lambda T: _mended(T / T[-1, -1], row=lambda row: row),
        ),
        Mistake(
            "the translation is lost",
            "The last column stays as it is.",
            lambda T: _mended(T, translation=lambda R, p: 0 * p),
        ),
        Mistake(
            "the translation is turned with the block",
            "The last column stays as it is.",
            lambda T: _mended(T, translation=lambda R, p: R @ p),
            lambda T: _mended(T, translation=lambda R, p: R.T @ p),
        ),
        Mistake(
            "the inverse pose is returned",
            "Keep the block and the translation: no transpose, no minus.",
            lambda T: _mended(T, lambda M: nearest_so(M).T, lambda R, p: -R @ p),
        ),
        Mistake(
            "the whole of T is taken for a matrix to be made a rotation",
            "Take the block T[:-1, :-1] only.",
            lambda T: polar(T, *[1.0] * (len(T) - 1), np.linalg.det(polar(T))),
            polar,
        ),
        Mistake(
            "the block comes back as it is",
            "Your nearest_so turns T[:-1, :-1] into a rotation.",
            lambda T: _mended(T, np.copy),
            np.copy,
        ),
        Mistake(
            "the last column of U V^T is negated, as in the published report",
            "The sign belongs between U and V^T; your nearest_so does it.",
            lambda T: _mended(T, last_column_negated),
        ),
        Mistake(
            "the block is left a reflection where det < 0",
            "Use your nearest_so, which turns the sign.",
            lambda T: _mended(T, polar),
        ),
        Mistake(
            "the block is transposed",
            "numpy.linalg.svd returns U, S, V^T: the product is U @ Vt.",
            lambda T: _mended(T, lambda M: nearest_so(M).T),
        ),
        Mistake(
            "the block is made orthogonal column after column",
            "Gram-Schmidt favours the first column: use your nearest_so.",
            lambda T: _mended(T, gram_schmidt),
        ),
    ),
    hints=(
        "Copy T, put nearest_so of the block T[:-1, :-1] in its place, and write the last row anew.",
        "n = len(T) - 1 works for SE(2) and SE(3).",
    ),
    forbidden=("course_lib.rigid.nearest_se", "course_lib.rotations.nearest_so"),
)
