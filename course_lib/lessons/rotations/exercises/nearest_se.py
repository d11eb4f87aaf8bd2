"""nearest_se: the pose nearest to a damaged one."""

import numpy as np

from course_lib.checks.declared import declared
from course_lib.checks.kinds import Kind, whole_numbers
from course_lib.checks.mistake import Question
from course_lib.checks.special_cases import SMALL, SMALL_NUMBERS
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import (
    LAST_ROW,
    any_pose,
    any_rotation,
    compared,
    is_rotation,
    near,
    no_rotation,
    pose,
)
from course_lib.lessons.rotations.exercises import shared
from course_lib.rigid import nearest_se


def _damaged_pose(M, p):
    return pose(M, p[: len(M)], *(0.1 * np.arange(1, len(M) + 2)))


def _damaged_poses(rng):
    p = rng.normal(size=3)
    slightly = any_rotation(rng) @ np.diag([1.003, 0.999, 1])
    whole = pose(shared.SINGULAR, [1.0, 2.0, 3.0], 4.0, 3.0, 2.0, 1.0)
    damaged = [_damaged_pose(M, p) for M in (*shared.damaged_rotations(rng), slightly)]
    large = [
        pose(shared.large_whole_numbers(rng, sign), [1, 2, 3], 4, 3, 2, 1).astype(int)
        for sign in (1, -1)
    ]
    return [*damaged, any_pose(rng), np.eye(3), np.eye(4), whole, *large]


def _nearly_the_identity(rng, size):
    block = shared.nearly_diagonal(rng, size)
    return pose(block, size * rng.uniform(-0.9, 0.9, 3), *[0.1] * 4)


def _nearly_a_pose(rng, gap):
    """Return a pose but for small errors in its block and in its last row."""
    row = np.array([0, 0, 0, 1]) + gap * rng.uniform(-0.9, 0.9, 4)
    return pose(shared.nearly_rotation(rng, gap), rng.normal(size=3), *row)


def _with_a_block_of_a_scale(rng, scale):
    return _damaged_pose(shared.of_a_scale(rng, scale), rng.normal(size=3))


def _coarse(rng):
    block = shared.coarse(rng)
    n = len(block)
    return pose(block, whole_numbers(rng, n), *whole_numbers(rng, n + 1))


DAMAGED = Kind(
    drawn=lambda rng: _damaged_pose(any_rotation(rng) @ np.diag([2.0, 1, 0.5]), rng.normal(size=3)),
    named=_damaged_poses,
    beside=(
        ("small entries", _nearly_the_identity, SMALL_NUMBERS),
        ("nearly a pose", _nearly_a_pose, SMALL),
        ("small or large blocks", _with_a_block_of_a_scale, shared.SCALES),
    ),
    coarse=_coarse,
)


def _found(X, T):
    block = X[:-1, :-1]
    if not near(X[-1], np.eye(len(T))[-1]):
        return LAST_ROW.says(X, T)
    if not near(X[:-1, -1], T[:-1, -1]):
        return "The translation should be " + compared(T[:-1, -1], X[:-1, -1]) + "."
    return shared.distances(block, T[:-1, :-1]) if is_rotation(block) else no_rotation(block)


def _otherwise(X, T):
    if not near(X[-1], np.eye(len(T))[-1]):
        return LAST_ROW.otherwise
    if not near(X[:-1, -1], T[:-1, -1]):
        return Question(
            "the translation is changed",
            "Only the block and the last row need repair. Which line writes the last column?",
        )
    if is_rotation(X[:-1, :-1]):
        return shared.NOT_NEAREST
    return Question(
        "the block is not a rotation",
        "Which line should make a rotation of the block? Print each factor that it multiplies, for "
        "this T.",
    )


EXERCISE = declared(
    "nearest_se",
    points=2,
    arguments={"T": DAMAGED},
    tolerance=EXACT,
    library=nearest_se,
    says="the block is the rotation nearest to that of T, the translation (the last column) stays "
    "as it is, and the last row is (0, ..., 0, 1)",
    found=_found,
    otherwise=_otherwise,
    hints=(
        "Three parts: the block T[:-1, :-1], the translation T[:-1, -1], the last row. Which of "
        "them need repair?",
        "With n = len(T) - 1 the same lines serve SE(2) and SE(3).",
        "Start from np.eye(len(T)); put nearest_so of the block and the translation into it.",
    ),
    mistakes=(),
    forbidden=("course_lib.rigid.nearest_se", "course_lib.rotations.nearest_so"),
    builds_on=("nearest_so",),
)
