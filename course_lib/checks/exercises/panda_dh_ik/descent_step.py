"""descent_step: find the bug. The space error is paired with the geometric Jacobian."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.panda_dh_ik.pose_error_mistakes import pose_error
from course_lib.checks.exercises.panda_dh_ik.shared import HIGH, LOW, flange, panda_jacobian
from course_lib.checks.vocabulary import any_pose, away_from_zero, few_digits, near, wrong_steps
from course_lib.rigid import inverse, log_se3, transform
from course_lib.rotations import exp_so3, log_so3

_PAIR = "Compare with the table of the three Jacobians: which error belongs to the geometric one?"


def _step(error):
    return lambda q, J, T, T_target, step: q + step * J.T @ error(T, T_target)


right = _step(pose_error)


def _of_the_world(T, T_target):
    X = T @ inverse(T_target)
    return -np.concatenate([X[:3, 3], log_so3(X[:3, :3])])


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
    drawn += [(away_from_zero(rng, 4), away_from_zero(rng, (6, 4)), any_pose(rng), any_pose(rng), 0.2)]
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
            lambda answer, q, J, T, T_target, step: near(answer, q),
            where=lambda q, J, T, T_target, step: np.array_equal(T, T_target),
        ),
        Property(
            "if only the position differs, the answer is q + step J^T e, with p_target - p in e",
            lambda answer, *case: near(answer, right(*case)),
            where=lambda q, J, T, T_target, step: np.array_equal(T[:3, :3], T_target[:3, :3]),
        ),
        Property(
            "the answer is q + step J^T e, with the error e that belongs to the geometric Jacobian",
            lambda answer, *case: near(answer, right(*case)),
        ),
    ),
    mistakes=(
        few_digits(right),
        Mistake(
            "only one half of the error is corrected",
            _PAIR,
            _step(lambda *c: np.concatenate([_of_the_world(*c)[:3], -pose_error(*c)[3:]])),
            _step(lambda *c: np.concatenate([pose_error(*c)[:3], -pose_error(*c)[3:]])),
            _step(lambda *c: np.concatenate([-pose_error(*c)[:3], pose_error(*c)[3:]])),
        ),
        Mistake(
            "the translation still holds a part of the rotation",
            _PAIR,
            _step(lambda T, T_target: np.concatenate([(T_target @ inverse(T))[:3, 3], pose_error(T, T_target)[3:]])),
            _step(lambda T, T_target: np.roll(log_se3(T_target @ inverse(T)), 3)),
        ),
        Mistake(
            "the error is seen from the end-effector",
            "The geometric Jacobian is along the world's axes.",
            _step(
                lambda T, T_target: np.concatenate(
                    [T[:3, :3].T @ pose_error(T, T_target)[:3], log_so3(T[:3, :3].T @ T_target[:3, :3])]
                )
            ),
            _step(
                lambda T, T_target: np.concatenate(
                    [pose_error(T, T_target)[:3], log_so3(T[:3, :3].T @ T_target[:3, :3])]
                )
            ),
            _step(lambda T, T_target: np.roll(log_se3(inverse(T) @ T_target), 3)),
        ),
        Mistake(
            "phi stands before the difference of the positions",
            "The rows of J are (v, omega).",
            _step(lambda *c: np.roll(pose_error(*c), 3)),
        ),
        *wrong_steps(right),
        Mistake("step is not used", "J^T e is multiplied by step.", lambda *case: right(*case[:4], 1.0)),
        Mistake(
            "the pseudoinverse stands for the transpose",
            "The bug is not there: J.T is what the method is called after.",
            lambda q, J, T, T_target, step: q + step * np.linalg.pinv(J) @ pose_error(T, T_target),
        ),
    ),
    hints=(
        "Take T and T_target with the same position and different orientations. What should the upper half of e be?",
        "The translation of T T_target^-1 says how the point at the world's origin moves, not the end-effector's.",
        "e is what pose_error(T, T_target) returns, and it already leads to the target.",
    ),
    library=right,
    broken=_step(_of_the_world),
)
