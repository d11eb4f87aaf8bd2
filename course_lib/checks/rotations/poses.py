"""is_se: what counts as a pose, within a tolerance."""

import numpy as np

from course_lib.checks.answer_types import boolean
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.rotations.predicates import (
    ALWAYS_THE_SAME,
    FIXED_TOLERANCES,
    LOOSE,
    NEARLY_ONE,
    NO_ABSOLUTE_VALUE,
    NO_TOL,
    RELATIVE,
    TIGHT,
    is_rotation,
    orthogonality_error,
    plane_rotation,
)
from course_lib.rotations import random_rotations


def _row_error(T):
    """What the last row differs from (0, ..., 0, 1) by, entry by entry."""
    return T[-1] - np.eye(T.shape[1])[-1]


def _square(T):
    return T.shape in ((3, 3), (4, 4))


def _row_fits(T, tol):
    return np.abs(_row_error(T)).max() <= tol


def _is_se(T, tol):
    return _square(T) and is_rotation(T[:-1, :-1], tol) and _row_fits(T, tol)


def pose(R, p, *row):
    """The matrix [[R, p], [row]], with the row of a pose where none is given."""
    n = len(p)
    T = np.eye(n + 1)
    T[:n, :n], T[:n, n] = R, p
    T[n] = row or T[n]
    return T


def _is_se_cases(rng):
    turn = random_rotations(1, rng)[0]
    flat = plane_rotation(0.5)
    p = rng.normal(size=3) * 10
    return [
        (np.eye(3), TIGHT),
        (np.eye(4), TIGHT),
        (pose(flat, p[:2]), TIGHT),
        (pose(turn, p), TIGHT),
        (pose(np.diag([1.0, -1.0]), p[:2]), TIGHT),
        (pose(-turn, p), TIGHT),
        (pose(0.5 * turn, p), TIGHT),
        (pose(turn @ np.diag([2.0, 0.5, 1.0]), p), TIGHT),
        (pose(turn, p, 0.3, -0.3, 0.0, 1.0), TIGHT),
        (pose(flat, 0 * p[:2], -0.3, 0.0, 1.0), TIGHT),
        (pose(turn, p, 0.0, 0.0, 0.0, 2.0), TIGHT),
        (pose(flat, p[:2], 0.0, 0.0, 0.5), TIGHT),
        (pose(turn, p, 0.0, 0.0, 0.0, NEARLY_ONE), TIGHT),
        (pose(flat, p[:2], 0.004, 0.0, 1.0), LOOSE),
        (pose(flat, p[:2], 0.004, 0.0, 1.0), 1e-4),
        (pose(turn @ np.diag([1.003, 1.0, 1.0]), p), LOOSE),
        (pose(turn @ np.diag([1.003, 1.0, 1.0]), p), 1e-4),
        (pose(turn @ np.diag([1.0, 1.0, -0.997]), p), LOOSE),
        (pose(turn, p)[:3], TIGHT),
        (np.eye(3, 4), TIGHT),
        (turn[:2], TIGHT),
    ]


def _and_block(test):
    """The answers of somebody who looks at the block and asks `test` for the last row."""
    return lambda T, tol: _square(T) and is_rotation(T[:-1, :-1], tol) and test(T, tol)


def _and_row(test):
    """The answers of somebody who looks at the last row and asks `test` for the block."""
    return lambda T, tol: _square(T) and test(T[:-1, :-1], tol) and _row_fits(T, tol)


IS_SE = Exercise(
    name="is_se",
    points=1,
    arguments=("T", "tol"),
    cases=_is_se_cases,
    returns=boolean,
    properties=(
        Property("a pose is accepted", lambda ok, T, tol: ok, where=lambda T, tol: _is_se(T, min(tol, TIGHT))),
        Property(
            "a matrix that is neither 3x3 nor 4x4 is refused",
            lambda ok, T, tol: not ok,
            where=lambda T, tol: not _square(T),
            mistake=Mistake("the shape is not looked at", "T.shape in ((3, 3), (4, 4)) is the first question."),
        ),
        Property(
            "the upper left block must be a rotation, within tol",
            lambda ok, T, tol: ok == _is_se(T, tol),
            where=lambda T, tol: _square(T) and not _row_error(T).any(),
        ),
        Property(
            "the last row must be (0, ..., 0, 1), each entry within tol",
            lambda ok, T, tol: ok == _is_se(T, tol),
            mistake=Mistake("the last row is not compared with tol", "np.abs(T[-1] - last_row).max() <= tol"),
        ),
    ),
    mistakes=(
        *ALWAYS_THE_SAME,
        Mistake(
            "the last row is not looked at",
            "T has to map points to points: T[-1] is (0, ..., 0, 1).",
            lambda T, tol: is_rotation(T[:-1, :-1], tol),
            _and_block(lambda T, tol: True),
        ),
        Mistake(
            "of the last row only the last entry is looked at",
            "The others must be 0.",
            _and_block(lambda T, tol: abs(T[-1, -1] - 1) <= tol),
        ),
        Mistake(
            "of the last row only the zeros are looked at",
            "Its last entry must be 1.",
            _and_block(lambda T, tol: np.abs(T[-1, :-1]).max() <= tol),
        ),
        Mistake(
            "the entries of the last row are added up",
            "(0.3, -0.3, 0, 1) adds up to 1 too: compare each entry.",
            _and_block(lambda T, tol: abs(T[-1].sum() - 1) <= tol),
            _and_block(lambda T, tol: abs(_row_error(T).sum()) <= tol),
        ),
        Mistake(*NO_ABSOLUTE_VALUE, _and_block(lambda T, tol: _row_error(T).max() <= tol)),
        Mistake(*RELATIVE, _and_block(lambda T, tol: np.allclose(T[-1], np.eye(len(T))[-1], rtol=1e-5, atol=tol))),
        Mistake(
            "the last column is compared in place of the last row",
            "T[-1] is the last row, T[:, -1] the last column.",
            _and_block(lambda T, tol: np.abs(_row_error(T.T)).max() <= tol),
        ),
        Mistake(
            "the last row is not compared with tol",
            "np.abs(T[-1] - last_row).max() <= tol",
            *(_and_block(lambda T, tol, fixed=fixed: _row_fits(T, fixed)) for fixed in (0.0, *FIXED_TOLERANCES)),
        ),
        Mistake(
            "the whole of T is taken for a rotation",
            "The translation column may hold anything. Take the block T[:-1, :-1].",
            lambda T, tol: _square(T) and orthogonality_error(T) <= tol,
        ),
        Mistake("the block is not looked at", "T[:-1, :-1] is for is_so.", _and_row(lambda R, tol: True)),
        Mistake(
            "a reflection passes for a rotation",
            "The block needs det = +1 too.",
            _and_row(lambda R, tol: orthogonality_error(R) <= tol),
        ),
        Mistake(
            "of the block only the determinant is looked at",
            "diag(2, 0.5, 1) has det = 1. Your is_so asks for more.",
            _and_row(lambda R, tol: abs(np.linalg.det(R) - 1) <= tol),
            _and_row(lambda R, tol: np.linalg.det(R) > 0),
        ),
        Mistake(*NO_TOL, *(lambda T, tol, fixed=fixed: _is_se(T, fixed) for fixed in FIXED_TOLERANCES)),
        Mistake(
            "tol is not passed on to the block",
            "Your is_so takes tol too.",
            *(_and_row(lambda R, tol, fixed=fixed: is_rotation(R, fixed)) for fixed in FIXED_TOLERANCES),
        ),
        Mistake(
            "one size alone is accepted",
            "T may be 3x3 or 4x4: len(T) tells.",
            *(lambda T, tol, n=n: T.shape == (n, n) and _is_se(T, tol) for n in (3, 4)),
        ),
    ),
    hints=(
        "Split T: the block T[:-1, :-1], the translation T[:-1, -1] (anything goes), the last row T[-1].",
        "Your is_so judges the block. The last row is compared with (0, ..., 0, 1).",
    ),
    forbidden=("course_lib.rigid.is_se", "course_lib.rotations.is_so"),
)
