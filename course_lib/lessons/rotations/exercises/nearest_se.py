"""nearest_se: the pose nearest to a damaged one."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.special_cases import SMALL, SMALL_NUMBERS, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import LAST_ROW, is_rotation, pose
from course_lib.lessons.rotations.exercises import shared
from course_lib.lessons.rotations.exercises.shared import (
    NOT_NEAREST,
    damaged_rotations,
    distances,
    nearly_diagonal,
    nearly_rotation,
)
from course_lib.rigid import nearest_se
from course_lib.rotations import random_rotations


def _damaged_pose(M, p):
    return pose(M, p[: len(M)], *(0.1 * np.arange(1, len(M) + 2)))


def _cases(rng):
    p, slightly = rng.normal(size=3), random_rotations(1, rng)[0] @ np.diag([1.003, 0.999, 1])
    good = [pose(random_rotations(1, rng)[0], p), np.eye(3), np.eye(4)]
    whole = pose(shared.SINGULAR, [1.0, 2.0, 3.0], 4.0, 3.0, 2.0, 1.0)
    good.append(whole)
    return [(T,) for T in [_damaged_pose(M, p) for M in [*damaged_rotations(rng), slightly]] + good]


def _small(rng, size):
    """A pose that is nearly the identity, and damaged."""
    return (pose(nearly_diagonal(rng, size), size * rng.uniform(-0.9, 0.9, 3), *[0.1] * 4),)


def _nearly(rng, gap):
    """A pose but for small errors in its block and in its last row."""
    row = np.array([0, 0, 0, 1]) + gap * rng.uniform(-0.9, 0.9, 4)
    return (pose(nearly_rotation(rng, gap), rng.normal(size=3), *row),)


def _is_pose(T):
    return is_rotation(T[:-1, :-1]) and np.array_equal(T[-1], np.eye(len(T))[-1])


EXERCISE = Exercise(
    name="nearest_se",
    points=2,
    arguments=("T",),
    tolerance=EXACT,
    cases=_cases,
    sweeps=(
        Sweep("small entries", _small, SMALL_NUMBERS),
        Sweep("nearly a pose", _nearly, SMALL),
    ),
    returns=numbers(np.shape),
    library=nearest_se,
    properties=(
        LAST_ROW,
        Property(
            "the translation (the last column) stays as it is",
            lambda X, T: np.abs(X[:-1, -1] - T[:-1, -1]).max() < EXACT,
            mistake=Mistake(
                "the translation is changed", "Only the block and the last row need repair."
            ),
        ),
        Property(
            "the block is a rotation",
            lambda X, T: is_rotation(X[:-1, :-1]),
            mistake=Mistake(
                "the block is not a rotation",
                "Which of your functions makes a rotation of a matrix?",
            ),
        ),
        Property(
            "a pose comes back unchanged", lambda X, T: np.abs(X - T).max() < EXACT, where=_is_pose
        ),
        Property(
            "the block is the rotation nearest to that of T",
            lambda X, T: np.linalg.norm(X - nearest_se(T)) < EXACT,
            says=lambda X, T: distances(X[:-1, :-1], T[:-1, :-1]),
            mistake=NOT_NEAREST,
        ),
    ),
    hints=(
        "Three parts: the block T[:-1, :-1], the translation T[:-1, -1], the last row. Which of "
        "them need repair?",
        "With n = len(T) - 1 the same lines serve SE(2) and SE(3).",
        "Start from np.eye(len(T)); put nearest_so of the block and the translation into it.",
    ),
    forbidden=("course_lib.rigid.nearest_se", "course_lib.rotations.nearest_so"),
    builds_on=("nearest_so",),
)
