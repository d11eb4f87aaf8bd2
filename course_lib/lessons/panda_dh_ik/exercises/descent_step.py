"""descent_step: find the bug. The space error is paired with the geometric Jacobian."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.comparisons import difference
from course_lib.checks.declared import declared
from course_lib.checks.kinds import POSE, joint_angles, number, table
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import BESIDE, SMALL, Sweep
from course_lib.checks.tolerances import EXACT, SIX_DIGITS
from course_lib.checks.vocabulary import any_pose, away_from_zero, unit, wrapped
from course_lib.lessons.panda_dh_ik.exercises.shared import (
    HIGH,
    LOW,
    changed,
    flange,
    panda_jacobian,
    pose_error,
)
from course_lib.rigid import inverse, log_se3, transform
from course_lib.rotations import exp_so3, log_so3

_ANY_POSE = POSE.but(beside=())  # what lies beside the other pose has sweeps below
_TWO_JOINTS = np.vstack([[[0, 0], [2, 1], [0, 0]], [[0, 0], [0, 0], [1, 1]]])


def _with_error(error):
    """Return the answer q + step J^T error(T, T_target)."""
    return lambda q, J, T, T_target, step: q + step * J.T @ error(T, T_target)


_right = _with_error(pose_error)


def _of_the_world(T, T_target):
    X = T @ inverse(T_target)
    return np.concatenate([X[:3, 3], log_so3(X[:3, :3])])


def _cases(rng):
    q, at = np.array([0.3, 0.4]), transform(np.eye(3), [1.0, 0, 0])
    ahead = transform(exp_so3([0, 0, 0.1]), [1.0, 0, 0])
    drawn = []
    for step in (0.1, 0.3):
        configuration = np.round(rng.uniform(LOW, HIGH), 2)
        arm = configuration, panda_jacobian(configuration), flange(configuration)
        drawn.append((*arm, any_pose(rng), step))
    for n in (1, 6):  # joints; of six the Jacobian is square
        arm = away_from_zero(rng, n), away_from_zero(rng, (6, n)), any_pose(rng)
        drawn.append((*arm, any_pose(rng), 0.2))
    return [
        (q, _TWO_JOINTS, at, ahead, 0.5),
        (q, _TWO_JOINTS, at, transform(np.eye(3), [1.5, 0.2, 0]), 0.5),
        *drawn,
        (q, _TWO_JOINTS, ahead, ahead, 0.5),
    ]


def _rotated_by(angle):
    """Return the case(rng, size) of a target that is rotated by angle(size), and moved."""

    def case(rng, size):
        T = any_pose(rng)
        T_target = transform(exp_so3(angle(size) * unit(rng)) @ T[:3, :3], away_from_zero(rng, 3))
        return away_from_zero(rng, 4), away_from_zero(rng, (6, 4)), T, T_target, 0.2

    return case


def _nearly_there(rng, size):
    """Return the case of a target that is nearly where the arm is."""
    T = any_pose(rng)
    R = exp_so3(size * unit(rng)) @ T[:3, :3]
    T_target = transform(R, T[:3, 3] + size * away_from_zero(rng, 3))
    return away_from_zero(rng, 4), away_from_zero(rng, (6, 4)), T, T_target, 0.9


def _from_the_end_effector(T, T_target):
    R, e = T[:3, :3], pose_error(T, T_target)
    return np.concatenate([R.T @ e[:3], log_so3(R.T @ T_target[:3, :3])])


def _orientation_from_the_end_effector(T, T_target):
    return np.append(pose_error(T, T_target)[:3], _from_the_end_effector(T, T_target)[3:])


def _reversed(v, omega):
    return _with_error(lambda T, T_target: np.repeat([v, omega], 3) * pose_error(T, T_target))


def _shortened(longest):
    def error(T, T_target):
        e = pose_error(T, T_target)
        return e * min(1.0, longest / max(np.linalg.norm(e), EXACT))

    return _with_error(error)


def _sine_for_the_angle(T, T_target):
    e = pose_error(T, T_target)
    return np.append(e[:3], e[3:] * np.sinc(np.linalg.norm(e[3:]) / np.pi))


def _distance(answer, right, q, J, T, T_target, step):
    """Return how far an answer is from the right one; at half a revolution, phi has either sign."""
    e = pose_error(T, T_target)
    opposite = q + step * J.T @ (e * np.repeat([1, -1], 3))
    is_half = np.linalg.norm(e[3:]) > np.pi - SIX_DIGITS
    return min(difference(answer, one) for one in ((right, opposite) if is_half else (right,)))


EXERCISE = declared(
    "descent_step",
    points=1,
    arguments={
        "q": joint_angles(4, small=True),
        "J": table(6, 4),
        "T": _ANY_POSE,
        "T_target": _ANY_POSE,
        "step": number(0.1, 1.0, 0.5, 3.0),
    },
    distance=_distance,
    cases=_cases,
    library=_right,
    reads=numbers(lambda q, *rest: (len(q),)),
    broken=lambda q, J, T, T_target, step: q - step * J.T @ _of_the_world(T, T_target),
    says="the answer is q + step J^T e, with the error e that belongs to the geometric Jacobian",
    found=lambda answer, q, *rest: changed(answer, _right(q, *rest), q),
    otherwise=Question(
        "the step is not step J^T e with the error that belongs to J",
        "Compare both halves of your e with those of pose_error(T, T_target), and your answer with "
        "q + step * J.T @ e for this e. What becomes of the result afterwards?",
    ),
    sweeps=(
        Sweep("nearly at the target", _nearly_there, SMALL),
        Sweep("a small rotation", _rotated_by(lambda size: size), BESIDE),
        # Nearer to half a revolution, rounding decides between phi and -phi.
        Sweep(
            "nearly half a revolution",
            _rotated_by(lambda size: np.pi - size),
            tuple(size for size in BESIDE if size > 1e-3),
        ),
    ),
    hints=(
        "Take T and T_target with the same position and different orientations. What should the "
        "upper half of e be?",
        "The translation of T T_target^-1 says how the point at the world's origin moves, not the "
        "end-effector's.",
        "e is what pose_error(T, T_target) returns, and it already leads to the target.",
    ),
    mistakes=(
        Mistake(
            "the translation still holds a part of the rotation",
            "Which error belongs to the geometric Jacobian in the table of the three Jacobians?",
            _with_error(lambda T, T_target: _of_the_world(T_target, T)),
            _with_error(lambda T, T_target: np.roll(log_se3(T_target @ inverse(T)), 3)),
        ),
        Mistake(
            "the error is seen from the end-effector",
            "Along the axes of which frame are the rows of the geometric Jacobian?",
            _with_error(_from_the_end_effector),
            _with_error(_orientation_from_the_end_effector),
        ),
        Mistake(
            "phi stands before the difference of the positions",
            "Which three rows of J come first?",
            _with_error(lambda T, T_target: np.roll(pose_error(T, T_target), 3)),
        ),
        Mistake(
            "the error, or one half of it, leads from the target to the arm",
            "From which pose to which pose must an error lead that is added to the angles?",
            _reversed(-1, 1),
            _reversed(1, -1),
            _reversed(-1, -1),
        ),
        Mistake(
            "an inverse of J stands where J^T is asked for",
            "Which method uses an inverse, and which method does the task ask for?",
            lambda q, J, T, T_target, step: q + step * np.linalg.pinv(J) @ pose_error(T, T_target),
        ),
        wrapped(_right),
        Mistake(
            "a long error is shortened",
            "How long is e, and which e does the task multiply by J^T?",
            *map(_shortened, (1.0, 0.5, 0.1)),
        ),
        Mistake(
            "phi has the length of a sine, as (R - R^T) / 2 gives it",
            "How long is the vector of (R - R^T) / 2 for a rotation by 90 degrees, and by 180 "
            "degrees?",
            _with_error(_sine_for_the_angle),
        ),
    ),
)
