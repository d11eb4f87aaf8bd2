"""inverse: the pose that undoes a pose."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property, same
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.poe_kuka_iiwa.matrices import BLOCK, COLUMN, FINE, in_part, near, told
from course_lib.checks.rotations.poses import pose
from course_lib.rotations import random_rotations, rot_x, rot_y, rot_z

_NO_ROW = Mistake("the last row is missing", "Start from np.eye(4) and fill in the block and the column.")


def poses(rng):
    """A translation, turns, both, and any poses; poses that no two mistakes take to the same."""
    far, quarter = np.array([1.0, 2.0, 3.0]), np.pi / 2
    named = [(np.eye(3), 0 * far), (np.eye(3), far), (rot_z(quarter), 0 * far)]
    named += [(rot(quarter), far) for rot in (rot_x, rot_y, rot_z)] + [(np.diag([1.0, -1.0, -1.0]), far)]
    sizes = (1, 1, 1, 1e-3, 100)
    return named + [(R, size * rng.normal(size=3)) for R, size in zip(random_rotations(5, rng), sizes, strict=True)]


def _cases(rng):
    return [(pose(R, p),) for R, p in poses(rng)]


def _right_block(T):
    return T[BLOCK].T


def _right_column(T):
    return -T[BLOCK].T @ T[COLUMN]


def _p_from(rotation):
    """A prediction: some rotation of p."""
    return lambda T: rotation(T[BLOCK]) @ T[COLUMN]


_in_block, _in_column = in_part(BLOCK, _right_block), in_part(COLUMN, _right_column)

INVERSE = Exercise(
    name="inverse",
    points=1,
    arguments=("T",),
    cases=_cases,
    returns=numbers(lambda *case: (4, 4), {(3, 4): _NO_ROW}),
    properties=(
        Property(
            "the last row is (0, 0, 0, 1)",
            lambda X, T: np.abs(X[3] - np.eye(4)[3]).max() < FINE,
            seen=lambda X, T: f"Yours is {format_tuple(X[3])}.",
            mistake=Mistake("the last row is not that of a pose", "Start from np.eye(4) and fill in block and column."),
        ),
        Property(
            "the upper left 3x3 block turns back: it is R^T",
            lambda X, T: near(X[BLOCK], _right_block(T)),
            seen=told(lambda X: X[BLOCK], _right_block),
        ),
        Property(
            "the inverse takes the point p to the origin, as T takes the origin to p",
            lambda X, T: near(X[COLUMN], _right_column(T)),
            seen=lambda X, T: (
                f"p is {format_tuple(T[COLUMN])}; your pose takes it to {format_tuple(X[BLOCK] @ T[COLUMN] + X[COLUMN])}."
            ),
        ),
    ),
    mistakes=(
        Mistake("T itself is returned", "The inverse turns back and goes back.", lambda T: T),
        Mistake(
            "the whole of T is transposed", "Only the block R is: p is turned back and changes its sign.", lambda T: T.T
        ),
        Mistake("T changes its sign", "-T undoes no motion: turn back by R^T, then go back.", lambda T: -T),
        Mistake(
            "every entry is inverted by itself",
            "1 / T or T ** -1 takes each entry by itself; a pose wants R^T.",
            lambda T: 1 / T if T.all() else None,
        ),
        Mistake(
            "the last row is that of the whole of T transposed, or p stands in it",
            "The last row of a pose is (0, 0, 0, 1).",
            seen=lambda X, T: T[COLUMN].any() and same(np.abs(X[3]), np.abs([*T[COLUMN], 1])),
        ),
        Mistake("the last row is zero", "X[3, 3] = 1: start from np.eye(4).", seen=lambda X, T: not X[3].any()),
        _in_block(("R is not transposed", "The block turns back: R^T."), lambda T: T[BLOCK]),
        _in_block(
            ("R changes its sign", "A turn is undone by R^T, not by -R."), lambda T: -T[BLOCK], lambda T: -T[BLOCK].T
        ),
        _in_block(("the block is the identity", "The block turns back: R^T."), lambda T: np.eye(3)),
        _in_column(
            ("the minus is missing: R^T p", "T^-1 p has to be the origin: R^T p + (-R^T p) = 0."),
            _p_from(lambda R: R.T),
        ),
        _in_column(
            ("p changes its sign and is not turned: -p", "p is known in the frame before; turn it back: -R^T p."),
            _p_from(lambda R: -np.eye(3)),
        ),
        _in_column(("p stays as it is", "T^-1 p has to be the origin: -R^T p."), _p_from(lambda R: np.eye(3))),
        _in_column(
            ("p is turned by R, not by R^T", "p turns back: -R^T p."),
            _p_from(lambda R: -R),
            _p_from(lambda R: R),
        ),
        _in_column(("the column is left empty", "X[:3, 3] = -R.T @ p"), lambda T: np.zeros(3)),
        _in_column(
            ("R^T * p, entry by entry, stands for the product", "In numpy the matrix product is @."),
            lambda T: (-T[BLOCK].T * T[COLUMN]).sum(0),
            lambda T: -np.diag(T[BLOCK]) * T[COLUMN],
        ),
    ),
    hints=(
        "R, p = T[:3, :3], T[:3, 3]. Solve y = R x + p for x.",
        "x = R^T y - R^T p: the block is R.T, the column -R.T @ p, the last row that of np.eye(4).",
    ),
    forbidden=("course_lib.rigid.inverse",),
)
