"""pose_error: the error from one pose to another that belongs to the geometric Jacobian."""

import numpy as np

from course_lib.checks.answer_types import NOT_A_NUMBER, numbers
from course_lib.checks.exercise import Exercise, Mistake, Property, Unreadable
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.exercises.panda_dh_ik.pose_error_mistakes import (
    MISTAKES,
    alike,
    angle_between,
    nearly_pi,
    pose_error,
    position_between,
    rotation_between,
)
from course_lib.checks.vocabulary import FINE, any_pose, away_from_zero, near, unit
from course_lib.rigid import transform
from course_lib.rotations import exp_so3, length

# As products of rotations may come out: the trace a hair above -1, so that arccos is a hair below pi.
_ROUNDED_PI = np.diag([1.0, 2.0**-53 - 1, 2.0**-53 - 1, 1])
_TINY = 1e-6  # below it, rounding takes part of the digits of a product of rotations
_AT_NO_ROTATION = Mistake(
    "the logarithm divides by zero, or asks arccos outside [-1, 1], at hardly any rotation",
    "The trace of R_target R^T is 3 there, or slightly more. rotations.log_so3 handles it.",
)
_SIX = "e has six numbers: the difference of the positions, then the rotation vector phi. np.concatenate joins them."
_HALVES = Mistake("the halves are not joined", _SIX)
_fitted = numbers(
    lambda T, T_target: (6,),
    {
        (2, 3): _HALVES,
        (3, 2): _HALVES,
        (3,): Mistake("only one half is returned", _SIX),
        (2,): Mistake("two lengths are returned", _SIX + " Lengths alone lose the directions."),
        (4, 4): Mistake("a matrix is returned", _SIX),
        (7,): Mistake(
            "the difference of positions and quaternions is returned",
            "Seven numbers fit no Jacobian of six rows. " + _SIX,
        ),
    },
)


def _read(value, T, T_target):
    """Return the answer as an array (6,)."""
    try:
        return _fitted(value, T, T_target)
    except Unreadable as wrong:
        if wrong.mistake is NOT_A_NUMBER and length(pose_error(T, T_target)[3:]) < _TINY:
            raise Unreadable(str(wrong), _AT_NO_ROTATION) from None
        if isinstance(value, list | tuple) and [np.size(part) for part in value] == [3, 3]:
            raise Unreadable(str(wrong), _HALVES) from None
        raise


def _cases(rng):
    x, z = np.eye(3)[[0, 2]]
    at, degree = transform(np.eye(3), [1.0, 0, 0]), np.pi / 180
    named = [
        (at, transform(exp_so3(0.1 * z), [1.0, 0, 0])),
        (transform(exp_so3(np.pi / 2 * x), [1.0, 0, 0]), transform(exp_so3(0.5 * z), [0, 2.0, 0])),
        (np.eye(4), at),
        (at, transform(np.eye(3), [1.0, 2, 3])),
        (np.eye(4), np.eye(4)),
    ]
    any_two = [_moved(any_pose(rng), rng) for _ in range(4)]
    far = [(transform(np.eye(3), [20.0, -30, 5]) @ T, T_target) for T, T_target in any_two[:2]]
    same = [any_pose(rng) for _ in range(6)]
    shifted = [(T, transform(T[:3, :3], away_from_zero(rng, 3))) for T in same[:2]]
    angles = [10 * degree, 90 * degree, 170 * degree, 179.9 * degree, 1e-9, 1e-9, 1e-9, 1e-5, 3e-4, 3e-3]
    angles += [np.pi - 3e-4, np.pi - 1e-5, np.pi - 1e-9, np.pi, np.pi]
    rotated = [_rotated(any_pose(rng), angle * unit(rng)) for angle in angles]
    nearly_half = (np.pi - 2e-4) * unit(rng)  # and its opposite: of two opposite axes only one is right
    rotated += [_rotated(same[0], phi) for phi in (nearly_half, -nearly_half)]
    rotated += [_rotated(T, np.pi * axis) for T in (np.eye(4), at) for axis in np.eye(3)]
    rotated += [_rotated(transform(exp_so3(179 * degree * x), [0.5, 0, 1]), 2 * degree * x)]
    rotated += [(T, T @ _ROUNDED_PI) for T in (np.eye(4), at)]
    return [*named, *any_two, *far, *((T, T.copy()) for T in same), *shifted, *rotated, named[1]]


def _rotated(T, phi):
    """Return the pose, and the same rotated by phi about its own origin."""
    return T, transform(exp_so3(phi) @ T[:3, :3], T[:3, 3])


def _moved(T, rng):
    """Return the pose, and another in another position, rotated by an angle well below pi."""
    return T, transform(exp_so3(rng.uniform(0.8, 2.6) * unit(rng)) @ T[:3, :3], away_from_zero(rng, 3))


def _same_orientation(T, T_target):
    return np.array_equal(T[:3, :3], T_target[:3, :3])


def _fine(T, T_target):
    """Return the error that a right phi may have: near pi, angle / sin(angle) and arccos lose some digits."""
    to_half = np.pi - angle_between(T, T_target)
    return 1e-7 if nearly_pi(T, T_target) else max(FINE, 1e-14 / to_half**2)


def _off_rotation(e, T, T_target):
    wanted = pose_error(T, T_target)[3:]
    return (
        f"{np.rad2deg(length(wanted)):.4g} degrees are between them, phi = {format_tuple(wanted)}; yours are "
        f"{np.rad2deg(length(e[3:])):.4g}, phi = {format_tuple(e[3:])}."
    )


def _off_tiny(e, T, T_target):
    return (
        f"The angle between them is {angle_between(T, T_target):.3g} rad; yours differs by {_gap(e, T, T_target):.2g}."
    )


def _gap(e, T, T_target):
    return length(e[3:] - pose_error(T, T_target)[3:])


EXERCISE = Exercise(
    name="pose_error",
    points=2,
    arguments=("T", "T_target"),
    cases=_cases,
    returns=_read,
    properties=(
        Property(
            "at the target the error is 0",
            lambda e, T, T_target: np.abs(e).max() < FINE,
            where=lambda T, T_target: np.array_equal(T, T_target),
        ),
        Property(
            "the first three numbers are p_target - p, along the world's axes",
            lambda e, T, T_target: near(e[:3], position_between(T, T_target)),
            says=lambda e, T, T_target: (
                f"That is {format_tuple(position_between(T, T_target))}; yours are {format_tuple(e[:3])}."
            ),
        ),
        Property(
            "if both poses have the same orientation, the last three numbers are 0",
            lambda e, T, T_target: np.abs(e[3:]).max() < FINE,
            says=lambda e, T, T_target: f"Yours are {format_tuple(e[3:])}.",
            where=_same_orientation,
        ),
        Property(
            "the rotation vector phi takes R to R_target: exp([phi]) R = R_target",
            lambda e, T, T_target: (
                np.abs(exp_so3(e[3:]) - rotation_between(T, T_target)).max() < 10 * _fine(T, T_target)
            ),
            says=_off_rotation,
        ),
        Property(
            "phi is the shortest rotation: its angle is at most pi",
            lambda e, T, T_target: length(e[3:]) < np.pi + max(1e-6, _fine(T, T_target)),
            says=_off_rotation,
            mistake=Mistake(
                "the longer rotation is taken",
                "2 pi - a about the opposite axis is the same rotation by a smaller angle.",
            ),
        ),
        Property(
            "a tiny rotation keeps its digits, as the last steps to a target need them",
            lambda e, T, T_target: _gap(e, T, T_target) <= 1e-5 * angle_between(T, T_target),
            says=_off_tiny,
            where=lambda T, T_target: 0 < angle_between(T, T_target) < 1e-2 and not _same_orientation(T, T_target),
        ),
        Property(
            "phi is the logarithm of R_target R^T as a rotation vector",
            lambda e, T, T_target: _gap(e, T, T_target) < _fine(T, T_target),
            says=_off_rotation,
            where=lambda T, T_target: not nearly_pi(T, T_target),
        ),
    ),
    mistakes=MISTAKES,
    hints=(
        "Positions may be subtracted. Rotations are compared by a product: "
        "the rotation between them is X with X R = R_target.",
        "X = R_target R^T is along the world's axes, as the Jacobian's lower half is. log_so3 gives its vector.",
        "np.concatenate([T_target[:3, 3] - T[:3, 3], rotations.log_so3(T_target[:3, :3] @ T[:3, :3].T)])",
    ),
    library=pose_error,
    alike=alike,
    errors=(
        (
            "ValueError",
            "is not a rotation",
            Mistake(
                "the logarithm is asked of something that is no rotation",
                "Rotations are compared by a product, R_target @ R.T, not by a difference; * is entry by entry.",
            ),
        ),
        (
            "ValueError",
            "of shape (..., 3, 3)",
            Mistake("the logarithm is given the whole pose", "It takes the block: T[:3, :3]."),
        ),
    ),
    forbidden=("course_lib.ik.pose_error",),
)
