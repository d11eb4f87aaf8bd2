"""descent_step: find the bug. The space error is paired with the geometric Jacobian."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.special_cases import BESIDE, Sweep
from course_lib.checks.tolerances import EXACT
from course_lib.checks.vocabulary import any_pose, away_from_zero, near, unit
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


def _rotated_by(angle):
    """Return the case(rng, size) of a target that is rotated by angle(size), and moved."""

    def case(rng, size):
        T = any_pose(rng)
        T_target = transform(exp_so3(angle(size) * unit(rng)) @ T[:3, :3], away_from_zero(rng, 3))
        return away_from_zero(rng, 4), away_from_zero(rng, (6, 4)), T, T_target, 0.2

    return case


EXERCISE = Exercise(
    name="descent_step",
    points=1,
    arguments=("q", "J", "T", "T_target", "step"),
    cases=_cases,
    small=("q", "T", "T_target"),
    returns=numbers(lambda q, *rest: (len(q),)),
    properties=(
        Property(
            "at the target the angles do not change",
            lambda answer, q, *rest: near(answer, q),
            where=lambda q, J, T, T_target, step: np.array_equal(T, T_target),
        ),
        Property(
            "if only the position differs, the step leads towards the target, as far as J^T says",
            lambda answer, *case: near(answer, right(*case)),
            where=lambda q, J, T, T_target, step: np.array_equal(T[:3, :3], T_target[:3, :3]),
            mistake=Mistake(
                "the step is not step J^T e",
                "Print e. Does the vector e lead from T to T_target? Which matrix, and which "
                "number, "
                "stand before e?",
            ),
        ),
        Property(
            "the answer is q + step J^T e, with the error e that belongs to the geometric Jacobian",
            lambda answer, *case: near(answer, right(*case)),
            says=lambda answer, q, *rest: (
                f"The change of q in your answer is off by "
                f"{np.abs(answer - right(q, *rest)).max():.2g}."
            ),
            mistake=Mistake(
                "the step is not step J^T e with the error that belongs to J",
                "Compare both halves of your e with those of pose_error(T, T_target), and your "
                "answer "
                "with q + step * J.T @ e for this e.",
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
    sweeps=(
        Sweep("a small rotation", _rotated_by(lambda size: size), BESIDE),
        # Nearer to half a revolution, rounding decides between phi and -phi.
        Sweep(
            "nearly half a revolution",
            _rotated_by(lambda size: np.pi - size),
            tuple(size for size in BESIDE if size > 1e-3),
        ),
    ),
    angles=("q",),
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
    "Along the axes of which frame are the rows of the geometric Jacobian?",
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
    "From which pose to which pose must an error lead that is added to the angles?",
    signs=((-1, 1), (1, -1), (-1, -1)),
)
def half_reversed(q, J, T, T_target, step, signs):
    return q + step * J.T @ (np.repeat(signs, 3) * pose_error(T, T_target))


@EXERCISE.mistake(
    "an inverse of J stands where J^T is asked for",
    "Which method uses an inverse, and which method does the task ask for?",
)
def inverse_for_the_transpose(q, J, T, T_target, step):
    return q + step * np.linalg.pinv(J) @ pose_error(T, T_target)


@EXERCISE.mistake(
    "the angles are brought between -pi and pi, or between 0 and 2 pi",
    "Does the formula in the task change an angle by whole revolutions?",
    wrap=(lambda q: np.arctan2(np.sin(q), np.cos(q)), lambda q: q % (2 * np.pi)),
)
def wrapped(*case, wrap):
    return wrap(right(*case))


@EXERCISE.mistake(
    "a long error is shortened",
    "How long is e, and which e does the task multiply by J^T?",
    longest=(1.0, 0.5, 0.1),
)
def error_shortened(q, J, T, T_target, step, longest):
    e = pose_error(T, T_target)
    return q + step * J.T @ e * min(1.0, longest / max(np.linalg.norm(e), EXACT))


@EXERCISE.mistake(
    "phi has the length of a sine, as (R - R^T) / 2 gives it",
    "How long is the vector of (R - R^T) / 2 for a rotation by 90 degrees, and by 180 degrees?",
)
def sine_for_the_angle(q, J, T, T_target, step):
    e = pose_error(T, T_target)
    angle = np.linalg.norm(e[3:])
    e = np.concatenate([e[:3], e[3:] * np.sinc(angle / np.pi)])
    return q + step * J.T @ e
