"""descent_step: find the bug. The space error is paired with the geometric Jacobian."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.vocabulary import any_pose, away_from_zero, near
from course_lib.lessons.panda_dh_ik.exercises.shared import (
    HIGH,
    LOW,
    flange,
    panda_jacobian,
    pose_error,
)
from course_lib.rigid import inverse, log_se3, transform
from course_lib.rotations import exp_so3, log_so3


def right(q, J, T, T_target, step):
    """Return the angles after a step of the transpose method."""
    return q + step * J.T @ pose_error(T, T_target)


def _of_the_world(T, T_target):
    X = T @ inverse(T_target)
    return np.concatenate([X[:3, 3], log_so3(X[:3, :3])])


def _broken(q, J, T, T_target, step):
    return q - step * J.T @ _of_the_world(T, T_target)


def _cases(rng):
    at, ahead = transform(np.eye(3), [1.0, 0, 0]), transform(exp_so3([0, 0, 0.1]), [1.0, 0, 0])
    J = np.vstack([[[0, 0], [2, 1], [0, 0]], [[0, 0], [0, 0], [1, 1]]])
    simple = np.array([0.3, 0.4]), J, at, ahead, 0.5
    moved = np.array([0.3, 0.4]), J, at, transform(np.eye(3), [1.5, 0.2, 0]), 0.5
    there = np.array([0.3, 0.4]), J, ahead, ahead, 0.5
    drawn = []
    for step in (0.1, 0.3, 1.0):
        q = np.round(rng.uniform(LOW, HIGH), 2)
        drawn.append((q, panda_jacobian(q), flange(q), any_pose(rng), step))
    drawn += [
        (away_from_zero(rng, 4), away_from_zero(rng, (6, 4)), any_pose(rng), any_pose(rng), 0.2)
    ]
    return [simple, moved, *drawn, there]


EXERCISE = Exercise(
    name="descent_step",
    points=1,
    arguments=("q", "J", "T", "T_target", "step"),
    cases=_cases,
    returns=numbers(lambda q, *rest: (len(q),)),
    properties=(
        Property(
            "at the target the angles stay as they are",
            lambda answer, q, *rest: near(answer, q),
            where=lambda q, J, T, T_target, step: np.array_equal(T, T_target),
        ),
        Property(
            "if only the position differs, the step leads towards the target, as far as J^T says",
            lambda answer, *case: near(answer, right(*case)),
            where=lambda q, J, T, T_target, step: np.array_equal(T[:3, :3], T_target[:3, :3]),
            mistake=Mistake(
                "the step is not step J^T e",
                "Print e: does it lead from T to T_target? Which matrix, and which number, stand "
                "before it?",
            ),
        ),
        Property(
            "the error is the one that belongs to the geometric Jacobian",
            lambda answer, *case: near(answer, right(*case)),
            mistake=Mistake(
                "the error is not the one that belongs to J",
                "Compare both halves of your e with those of pose_error(T, T_target).",
            ),
        ),
    ),
    hints=(
        "Take T and T_target with the same position and different orientations. What should the "
        "upper half of e be?",
        "The translation of T T_target^-1 says how the point at the world's origin moves, not the "
        "end-effector's.",
        "e is what pose_error(T, T_target) returns, and it already leads to the target.",
    ),
    library=right,
    broken=_broken,
)


@EXERCISE.mistake(
    "the translation still holds a part of the rotation",
    "Which error belongs to the geometric Jacobian in the table of the three Jacobians?",
    error=(lambda T, G: _of_the_world(G, T), lambda T, G: np.roll(log_se3(G @ inverse(T)), 3)),
)
def rotation_in_the_translation(q, J, T, T_target, step, error):
    return q + step * J.T @ error(T, T_target)


@EXERCISE.mistake(
    "the error is seen from the end-effector",
    "Along which axes is the geometric Jacobian?",
    position=(True, False),
)
def from_the_end_effector(q, J, T, T_target, step, position):
    R, e = T[:3, :3], pose_error(T, T_target)
    e = np.concatenate([R.T @ e[:3] if position else e[:3], log_so3(R.T @ T_target[:3, :3])])
    return q + step * J.T @ e


@EXERCISE.mistake(
    "phi stands before the difference of the positions",
    "Which three rows of J come first?",
)
def halves_swapped(q, J, T, T_target, step):
    return q + step * J.T @ np.roll(pose_error(T, T_target), 3)


@EXERCISE.mistake(
    "the error, or one half of it, leads from the target to the arm",
    "From which pose to which must it lead, where it is added?",
    signs=((-1, 1), (1, -1), (-1, -1)),
)
def half_reversed(q, J, T, T_target, step, signs):
    return q + step * J.T @ (np.repeat(signs, 3) * pose_error(T, T_target))


@EXERCISE.mistake(
    "an inverse of J stands where J^T is asked for",
    "Which method is this, and which the task's?",
)
def inverse_for_the_transpose(q, J, T, T_target, step):
    return q + step * np.linalg.pinv(J) @ pose_error(T, T_target)
