"""pose_error: the error from one pose to another that belongs to the geometric Jacobian."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.exercise import Exercise, Mistake, Property, same
from course_lib.checks.format_numbers import format_tuple
from course_lib.checks.special_cases import BESIDE, SMALL, Sweep
from course_lib.checks.tolerances import (
    EXACT,
    FIVE_DIGITS,
    FOUR_DIGITS,
    HALF_THE_DIGITS,
    SIX_DIGITS,
)
from course_lib.checks.vocabulary import any_pose, away_from_zero, compared, near, unit
from course_lib.lessons.panda_dh_ik.exercises.shared import pose_error, roll_pitch_yaw
from course_lib.rigid import inverse, log_se3, transform
from course_lib.rotations import exp_so3, length, log_so3, matrix_to_quaternion

_NEARLY_PI = np.pi - SIX_DIGITS  # rad; beyond it phi and -phi are both right
_ROUNDING = 1e-14  # relative, of a product of two rotations and of the formulas after it
# As products of rotations may come out: the trace a hair above -1, so that arccos is a hair below
# pi.
_ROUNDED_PI = np.diag([1.0, 2.0**-53 - 1, 2.0**-53 - 1, 1])
_HALVES = Mistake(
    "the halves are not joined", "The error has six numbers. np.concatenate joins arrays."
)
_NO_ROTATION = Mistake(
    "log_so3 gets a matrix that is not a rotation",
    "Which operation compares two rotations, a difference or a product?",
)
_WHOLE_POSE = Mistake("log_so3 gets the whole pose", "Which block of T is the rotation?")


def _between(T, T_target):
    return T_target[:3, 3] - T[:3, 3], T_target[:3, :3] @ T[:3, :3].T


def _angle(T, T_target):
    return length(pose_error(T, T_target)[3:])


def _rotated(T, phi):
    """Return the pose, and the same rotated by phi about its own origin."""
    return T, transform(exp_so3(phi) @ T[:3, :3], T[:3, 3])


def _moved(T, rng):
    """Return the pose, and another in another position, rotated by an angle well below pi."""
    return T, transform(
        exp_so3(rng.uniform(0.8, 2.6) * unit(rng)) @ T[:3, :3], away_from_zero(rng, 3)
    )


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
    there = [any_pose(rng) for _ in range(6)]
    shifted = [(T, transform(T[:3, :3], away_from_zero(rng, 3))) for T in there[:2]]
    angles = [10 * degree, 90 * degree, 170 * degree, 179.9 * degree, 1e-9, 1e-9, np.pi, np.pi]
    rotated = [_rotated(any_pose(rng), angle * unit(rng)) for angle in angles]
    nearly_half = (np.pi - 2e-4) * unit(
        rng
    )  # and its opposite: of two opposite axes only one is right
    rotated += [_rotated(there[0], phi) for phi in (nearly_half, -nearly_half)]
    rotated += [_rotated(T, np.pi * axis) for T in (np.eye(4), at) for axis in np.eye(3)]
    rotated += [_rotated(transform(exp_so3(179 * degree * x), [0.5, 0, 1]), 2 * degree * x)]
    rotated += [(T, T @ _ROUNDED_PI) for T in (np.eye(4), at)]
    return [*named, *any_two, *far, *((T, T.copy()) for T in there), *shifted, *rotated, named[1]]


def _by(rng, angle):
    return _rotated(any_pose(rng), angle * unit(rng))


def _nearly_there(rng, size):
    """Return two poses nearly at the origin, rotated by an ordinary angle."""
    near_origin = (size * away_from_zero(rng, 3) for _ in range(2))
    return tuple(transform(exp_so3(unit(rng)), p) for p in near_origin)


# Below 1e-10 rad, rounding in the product of two rotations exceeds the five digits asked for.
_SMALL_ANGLES = tuple(size for size in BESIDE if size > 3e-10)
# At 1e-6 rad from pi, rounding would decide whether either sign is right.
_GAPS = tuple(gap for gap in BESIDE if not 0.5 * SIX_DIGITS < gap < 2 * SIX_DIGITS)


def _fine(T, T_target):
    """Return the error that a right phi may have: near pi, angle / sin(angle) and arccos lose some
    digits."""
    angle = _angle(T, T_target)
    return HALF_THE_DIGITS if angle > _NEARLY_PI else max(EXACT, _ROUNDING / (np.pi - angle) ** 2)


def _gap(e, *case):
    return length(e[3:] - pose_error(*case)[3:])


def _off(e, *case):
    wanted = pose_error(*case)
    if not near(e[:3], wanted[:3]):
        return f"That is {compared(wanted[:3], e[:3])}."
    angle, phi = length(wanted[3:]), format_tuple(wanted[3:])
    yours = f"{format_tuple(e[3:])}, off by {_gap(e, *case):.2g}"
    return f"The rotation between them is {angle:.4g} rad, phi = {phi}; your phi is {yours}."


def _alike(e, predicted, *case, up_to_two_pi=False):
    """Return whether two errors are the same, phi to the digits that a small angle has, and up to
    its sign at pi."""
    e, predicted = np.asarray(e, float), np.asarray(predicted, float)
    if e.shape != (6,) or not same(e[:3], predicted[:3]):
        return False
    phi = predicted[3:]
    gaps = [e[3:] - guess for guess in ((phi, -phi) if length(phi) > _NEARLY_PI else (phi,))]
    gaps = [gap - up_to_two_pi * 2 * np.pi * np.round(gap / (2 * np.pi)) for gap in gaps]
    return min(np.abs(gap).max() for gap in gaps) <= FOUR_DIGITS * min(_angle(*case), 0.01) + 1e-12


def _alike_up_to_two_pi(*case):
    return _alike(*case, up_to_two_pi=True)


EXERCISE = Exercise(
    name="pose_error",
    points=2,
    sets=2,
    arguments=("T", "T_target"),
    tolerance=EXACT,
    cases=_cases,
    returns=numbers(lambda *case: (6,)),
    properties=(
        Property(
            "the first three numbers are p_target - p, along the world's axes",
            lambda e, *case: near(e[:3], _between(*case)[0]),
            _off,
        ),
        Property(
            "the rotation vector phi takes R to R_target: exp([phi]) R = R_target",
            lambda e, *case: np.abs(exp_so3(e[3:]) - _between(*case)[1]).max() < 10 * _fine(*case),
            _off,
            mistake=Mistake(
                "phi does not take R to R_target",
                "Compute exp([phi]) R for your phi, and compare it with R_target. By which "
                "angle do "
                "the two differ for small and for large rotations?",
            ),
        ),
        Property(
            "phi is the shortest rotation: its angle is at most pi",
            lambda e, *case: length(e[3:]) < np.pi + max(SIX_DIGITS, _fine(*case)),
            _off,
            mistake=Mistake(
                "the longer rotation is taken",
                "Which smaller angle, about the opposite axis, gives the same rotation?",
            ),
        ),
        Property(
            "a tiny rotation keeps its digits, which the last steps to a target need",
            lambda e, *case: _gap(e, *case) <= FIVE_DIGITS * _angle(*case),
            _off,
            mistake=Mistake(
                "a tiny rotation counts as none, or has lost its digits",
                "What does arccos of a number slightly below 1 give? rotations.log_so3 handles "
                "this "
                "case.",
            ),
            where=lambda T, T_target: (
                0 < _angle(T, T_target) < 1e-2 and not np.array_equal(T[:3, :3], T_target[:3, :3])
            ),
        ),
        Property(
            "phi is the logarithm of R_target R^T as a rotation vector",
            lambda e, *case: _gap(e, *case) < _fine(*case),
            _off,
            where=lambda *case: _angle(*case) <= _NEARLY_PI,
        ),
    ),
    hints=(
        "Positions may be subtracted. Rotations are compared by a product: "
        "the rotation between them is X with X R = R_target.",
        "X = R_target R^T is along the world's axes, as the Jacobian's lower half is. log_so3 "
        "gives its vector.",
        "np.concatenate([T_target[:3, 3] - T[:3, 3], rotations.log_so3(T_target[:3, :3] @ T[:3, "
        ":3].T)])",
    ),
    library=pose_error,
    sweeps=(
        Sweep("a small rotation", lambda rng, size: _by(rng, size), _SMALL_ANGLES),
        Sweep("a small distance", _nearly_there, SMALL),
        Sweep("nearly half a revolution", lambda rng, gap: _by(rng, np.pi - gap), _GAPS),
    ),
    alike=_alike,
    forbidden=("course_lib.ik.pose_error",),
)

EXERCISE.mistake(_HALVES, form=(2, 3))
EXERCISE.mistake(_HALVES, form=(3, 2))
EXERCISE.mistake(_NO_ROTATION, raises=("ValueError", "is not a rotation"))
EXERCISE.mistake(_WHOLE_POSE, raises=("ValueError", "of shape (..., 3, 3)"))


@EXERCISE.mistake(
    "the error, or one half of it, leads away from the target",
    "From which pose to which pose should the error lead?",
    signs=((-1, -1), (-1, 1), (1, -1)),
)
def away_from_the_target(T, T_target, signs):
    return np.repeat(signs, 3) * pose_error(T, T_target)


@EXERCISE.mistake(
    "phi is in degrees",
    "In which unit are the joint angles that the Jacobian multiplies?",
)
def in_degrees(T, T_target):
    e = pose_error(T, T_target)
    return np.append(e[:3], np.rad2deg(e[3:]))


@EXERCISE.mistake(
    "the error, or one half of it, is seen from the end-effector",
    "Along the axes of which frame are the rows of the Jacobian?",
    halves=((True, True), (True, False), (False, True)),
)
def from_the_end_effector(T, T_target, halves):
    R, e = T[:3, :3], pose_error(T, T_target)
    seen = R.T @ e[:3], log_so3(R.T @ T_target[:3, :3])
    return np.where(np.repeat(halves, 3), np.concatenate(seen), e)


@EXERCISE.mistake(
    "the translation contains a part of the rotation, because it is that of a product of poses "
    "or of "
    "its logarithm",
    "The velocity of which point do the upper rows of the Jacobian give?",
    error=(
        lambda T, G: np.append((G @ inverse(T))[:3, 3], pose_error(T, G)[3:]),
        lambda T, G: np.roll(log_se3(G @ inverse(T)), 3),
        lambda T, G: np.roll(log_se3(inverse(T) @ G), 3),
        lambda T, G: log_se3(G @ inverse(T)),
        lambda T, G: log_se3(inverse(T) @ G),
    ),
)
def rotation_in_the_translation(T, T_target, error):
    return error(T, T_target)


def _quaternion(R):
    return 2 * matrix_to_quaternion(R)[1:]


@EXERCISE.mistake(
    "angles, rotation vectors or quaternions of the two rotations are subtracted",
    "Do rotations about different axes add up? By how many degrees does an arm have to rotate from "
    "179 to -179 degrees?",
    measure=(roll_pitch_yaw, log_so3, _quaternion),
    order=(1, -1),
    alike=_alike_up_to_two_pi,
)
def coordinates_subtracted(T, T_target, measure, order):
    return np.append(
        _between(T, T_target)[0], (measure(T_target[:3, :3]) - measure(T[:3, :3]))[::order]
    )
