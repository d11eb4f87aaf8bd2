"""is_se and nearest_se: poses in the plane and in space."""

import numpy as np

from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.reading import numbers, truth
from course_lib.checks.rotations.nearest import (
    damaged_rotations,
    distances,
    gram_schmidt,
    is_exact_rotation,
    last_column_negated,
    polar,
)
from course_lib.checks.rotations.predicates import is_rotation, orthogonality_error, plane_rotation
from course_lib.rigid import nearest_se
from course_lib.rotations import nearest_so, random_rotations


def _last_row_error(T):
    return np.abs(T[-1] - np.eye(len(T))[-1]).max()


def _is_se(T, tol):
    return T.shape in ((3, 3), (4, 4)) and is_rotation(T[:-1, :-1], tol) and _last_row_error(T) <= tol


def _pose(R, p):
    n = len(p)
    T = np.eye(n + 1)
    T[:n, :n], T[:n, n] = R, p
    return T


def _is_se_cases(rng):
    turn = random_rotations(1, rng)[0]
    p = rng.normal(size=3) * 10
    bent, scaled, open_row = _pose(turn, p), _pose(turn, p), _pose(plane_rotation(0.5), p[:2])
    bent[3, :3] = 0.3
    scaled[3, 3] = 2.0
    open_row[2, 0] = 0.004
    tight, loose = 1e-9, 0.01
    return [
        (np.eye(3), tight),
        (np.eye(4), tight),
        (_pose(plane_rotation(0.5), p[:2]), tight),
        (_pose(turn, p), tight),
        (_pose(np.diag([1.0, -1.0]), p[:2]), tight),
        (_pose(-turn, p), tight),
        (_pose(2 * turn, p), tight),
        (bent, tight),
        (scaled, tight),
        (open_row, loose),
        (open_row, 1e-3),
        (_pose(turn @ np.diag([1.003, 1.0, 1.0]), p), loose),
        (_pose(turn, p)[:3], tight),
        (turn[:2], tight),
    ]


IS_SE = Exercise(
    name="is_se",
    points=1,
    arguments=("T", "tol"),
    cases=_is_se_cases,
    returns=truth,
    properties=(
        Property("a pose is accepted", lambda ok, T, tol: ok, where=lambda T, tol: _is_se(T, min(tol, 1e-9))),
        Property(
            "a matrix that is neither 3x3 nor 4x4 is refused",
            lambda ok, T, tol: not ok,
            where=lambda T, tol: T.shape not in ((3, 3), (4, 4)),
        ),
        Property(
            "the upper left block must be a rotation",
            lambda ok, T, tol: ok == _is_se(T, tol),
            where=lambda T, tol: T.shape in ((3, 3), (4, 4)) and _last_row_error(T) == 0,
        ),
        Property(
            "the last row must be (0, ..., 0, 1), each entry within tol",
            lambda ok, T, tol: ok == _is_se(T, tol),
            mistake=Mistake("the last row is not compared with tol", "np.abs(T[-1] - last_row).max() <= tol"),
        ),
    ),
    mistakes=(
        Mistake(
            "the last row is not looked at",
            "T has to map points to points: T[-1] is (0, ..., 0, 1).",
            lambda T, tol: is_rotation(T[:-1, :-1], tol),
        ),
        Mistake(
            "of the last row only the last entry is looked at",
            "The others must be 0.",
            lambda T, tol: is_rotation(T[:-1, :-1], tol) and abs(T[-1, -1] - 1) <= tol,
        ),
        Mistake(
            "the whole of T is taken for a rotation",
            "The translation column may hold anything. Take the block T[:-1, :-1].",
            lambda T, tol: orthogonality_error(T) <= tol,
        ),
        Mistake(
            "the block is not looked at",
            "T[:-1, :-1] is for is_so.",
            lambda T, tol: len(set(T.shape)) == 1 and _last_row_error(T) <= tol,
        ),
        Mistake(
            "a reflection passes for a rotation",
            "The block needs det = +1 too.",
            lambda T, tol: orthogonality_error(T[:-1, :-1]) <= tol and _last_row_error(T) <= tol,
        ),
        Mistake("tol is not used", "Compare with the tolerance you are given.", lambda T, tol: _is_se(T, 1e-8)),
    ),
    hints=(
        "Split T: the block T[:-1, :-1], the translation T[:-1, -1] (anything goes), the last row T[-1].",
        "Your is_so judges the block. The last row is compared with (0, ..., 0, 1).",
    ),
    forbidden=("course_lib.rigid.is_se", "course_lib.rotations.is_so"),
)


def _damaged_pose(M, p):
    n = len(M)
    T = np.eye(n + 1)
    T[:n, :n], T[:n, n], T[n] = M, p[:n], 0.1 * np.arange(1, n + 2)
    return T


def _nearest_se_cases(rng):
    p = rng.normal(size=3)
    good = [np.eye(3), np.eye(4), _pose(random_rotations(1, rng)[0], p)]
    return [(T,) for T in good + [_damaged_pose(M, p) for M in damaged_rotations(rng)]]


def _valid_pose(T):
    return is_exact_rotation(T[:-1, :-1]) and np.array_equal(T[-1], np.eye(len(T))[-1])


def _block_replaced(T, block, row=True):
    answer = T.copy()
    answer[:-1, :-1] = block(T[:-1, :-1])
    if row:
        answer[-1] = np.eye(len(T))[-1]
    return answer


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
            "the last column of U V^T is negated, as in the published report",
            "The sign belongs between U and V^T; your nearest_so does it.",
            lambda T: _block_replaced(T, last_column_negated),
        ),
        Mistake(
            "the block is left a reflection where det < 0",
            "Use your nearest_so, which turns the sign.",
            lambda T: _block_replaced(T, polar),
        ),
        Mistake(
            "the block is transposed",
            "numpy.linalg.svd returns U, S, V^T: the product is U @ Vt.",
            lambda T: _block_replaced(T, lambda M: nearest_so(M).T),
        ),
        Mistake(
            "the block is made orthogonal column after column",
            "Gram-Schmidt favours the first column: use your nearest_so.",
            lambda T: _block_replaced(T, gram_schmidt),
        ),
    ),
    hints=(
        "Copy T, put nearest_so of the block T[:-1, :-1] in its place, and write the last row anew.",
        "n = len(T) - 1 works for SE(2) and SE(3).",
    ),
    forbidden=("course_lib.rigid.nearest_se", "course_lib.rotations.nearest_so"),
)
