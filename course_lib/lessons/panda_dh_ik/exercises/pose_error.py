"""pose_error: the error from one pose to another that belongs to the geometric Jacobian."""

import numpy as np

from course_lib.checks.answer_types import numbers
from course_lib.checks.comparisons import same
from course_lib.checks.declared import declared
from course_lib.checks.kinds import POSE, half_turns
from course_lib.checks.mistake import Mistake, Question
from course_lib.checks.special_cases import BESIDE, SMALL, Sweep
from course_lib.checks.tolerances import (
    EXACT,
    FIVE_DIGITS,
    FOUR_DIGITS,
    SIX_DIGITS,
)
from course_lib.checks.vocabulary import any_pose, away_from_zero, compared, near, unit
from course_lib.lessons.panda_dh_ik.exercises.shared import pose_error, roll_pitch_yaw
from course_lib.rigid import inverse, log_se3, transform
from course_lib.rotations import exp_so3, length, log_so3, matrix_to_quaternion

_ANY_POSE = POSE.but(beside=(), small=False)  # small differences of two poses have sweeps below
_NEARLY_PI = np.pi - SIX_DIGITS  # rad; beyond it phi and -phi are both right
_ROUNDING = 1e-14  # relative, of a product of two rotations and of the formulas after it
# As products of rotations may come out: the trace a hair above -1, so that arccos is a hair below
# pi.
_ROUNDED_PI = np.diag([1.0, 2.0**-53 - 1, 2.0**-53 - 1, 1])
_HALVES = Mistake(
    "the halves are not joined", "The error has six numbers. np.concatenate joins arrays."
)
_LONGER = Mistake(
    "the longer rotation is taken",
    "Which smaller angle, about the opposite axis, gives the same rotation?",
)
_TINY = Question(
    "a tiny rotation counts as none, or has lost its digits",
    "How many digits of your phi are right? For so small an angle some formulas lose digits, and "
    "others are only nearly right. rotations.log_so3 handles this case.",
)
_OTHER_ROTATION = Question(
    "phi does not take R to R_target",
    "Compute exp([phi]) R for your phi, and compare it with R_target. By which angle do the two "
    "differ here, and for which rotations does your code use another formula?",
)


def _between(T, T_target):
    return T_target[:3, 3] - T[:3, 3], T_target[:3, :3] @ T[:3, :3].T


def _angle(T, T_target):
    return length(pose_error(T, T_target)[3:])


def _rotated(T, phi):
    """Return the pose, and the same rotated by phi about its own origin."""
    return T, transform(exp_so3(phi) @ T[:3, :3], T[:3, 3])


def _cases(rng):
    """Return poses that are related: the kinds have those that are not."""
    x, z = np.eye(3)[[0, 2]]
    at, degree = transform(np.eye(3), [1.0, 0, 0]), np.pi / 180
    there = any_pose(rng)
    cases = [
        (at, transform(exp_so3(0.1 * z), [1.0, 0, 0])),
        (np.eye(4), at),
        (at, transform(np.eye(3), [1.0, 2, 3])),
        (np.eye(4), np.eye(4)),
        (there, there.copy()),
        (there, transform(there[:3, :3], away_from_zero(rng, 3))),
        _rotated(transform(exp_so3(179 * degree * x), [0.5, 0, 1]), 2 * degree * x),
    ]
    angles = [10 * degree, 90 * degree, 170 * degree, 179.9 * degree, 1e-9, np.pi]
    cases += [_rotated(any_pose(rng), angle * unit(rng)) for angle in angles]
    # Of two opposite axes only one is right.
    nearly_half = (np.pi - 2e-4) * unit(rng)
    cases += [_rotated(there, phi) for phi in (nearly_half, -nearly_half)]
    cases += [(at, transform(R, [1.0, 2, 3])) for R in half_turns(rng)]
    return [*cases, (np.eye(4), _ROUNDED_PI), (at, at @ _ROUNDED_PI)]


def _by(rng, angle):
    return _rotated(any_pose(rng), angle * unit(rng))


def _nearly_there(rng, size):
    """Return two poses nearly at the origin, rotated by an ordinary angle."""
    near_origin = (size * away_from_zero(rng, 3) for _ in range(2))
    return tuple(transform(exp_so3(unit(rng)), p) for p in near_origin)


_SMALL = 0.01  # rad: below it an angle is tiny
# Below this, rounding in the product of two rotations exceeds the five digits asked for.
_ROUNDED_ANGLE = 1e-10  # rad
_SMALL_ANGLES = tuple(size for size in BESIDE if size > 3 * _ROUNDED_ANGLE)
# At 1e-6 rad from pi, rounding would decide whether either sign is right.
_GAPS = tuple(gap for gap in BESIDE if not 0.5 * SIX_DIGITS < gap < 2 * SIX_DIGITS)


def _fine(T, T_target):
    """Return the error that a right phi may have: near pi, angle / sin(angle) and arccos lose some
    digits."""
    angle = _angle(T, T_target)
    return SIX_DIGITS if angle > _NEARLY_PI else max(EXACT, _ROUNDING / (np.pi - angle) ** 2)


def _gap(e, *case):
    """Return how far phi is from the right one; at pi up to its sign."""
    phi = pose_error(*case)[3:]
    signs = (1, -1) if length(phi) > _NEARLY_PI else (1,)
    return min(length(e[3:] - sign * phi) for sign in signs)


def _distance(e, right, T, T_target):
    """Return how far an error is from the right one: phi beside its special values as a share of
    what is allowed there."""
    allowed, angle = _fine(T, T_target), _angle(T, T_target)
    if _ROUNDED_ANGLE < angle < _SMALL:
        allowed = min(allowed, FIVE_DIGITS * angle)
    gap = _gap(e, T, T_target)
    share = gap / allowed
    off = share * EXACT * max(1, np.abs(right).max())
    if share > 1:
        off = max(off, gap)  # so that an error of pi is not as small as its share suggests
    return max(np.abs(e[:3] - right[:3]).max(), off)


def _otherwise(e, *case):
    if not near(e[:3], pose_error(*case)[:3]):
        return None
    is_right_rotation = np.abs(exp_so3(e[3:]) - _between(*case)[1]).max() < SIX_DIGITS
    if is_right_rotation and length(e[3:]) > np.pi + SIX_DIGITS:
        return _LONGER
    return _TINY if _angle(*case) < _SMALL else _OTHER_ROTATION


def _off(e, *case):
    wanted = pose_error(*case)
    if not near(e[:3], wanted[:3]):
        return "p_target - p is " + compared(wanted[:3], e[:3]) + "."
    between = f"The rotation between them is {length(wanted[3:]):.7g} rad, and phi is "
    return between + compared(wanted[3:], e[3:]) + "."


def _alike(e, predicted, *case, up_to_two_pi=False):
    """Return whether two errors are the same, phi to the digits that a small angle has, and up to
    its sign at pi."""
    e, predicted = np.asarray(e, float), np.asarray(predicted, float)
    if e.shape != (6,) or not same(e[:3], predicted[:3]):
        return False
    phi = predicted[3:]
    gaps = [e[3:] - guess for guess in ((phi, -phi) if length(phi) > _NEARLY_PI else (phi,))]
    gaps = [gap - up_to_two_pi * 2 * np.pi * np.round(gap / (2 * np.pi)) for gap in gaps]
    return (
        min(np.abs(gap).max() for gap in gaps) <= FOUR_DIGITS * min(_angle(*case), _SMALL) + 1e-12
    )


def _alike_up_to_two_pi(*case):
    return _alike(*case, up_to_two_pi=True)


def _from_the_end_effector(position, rotation):
    """Return the answer with one half, or both, seen from the end-effector."""

    def answer(T, T_target):
        R, e = T[:3, :3], pose_error(T, T_target)
        v = R.T @ e[:3] if position else e[:3]
        return np.append(v, log_so3(R.T @ T_target[:3, :3]) if rotation else e[3:])

    return answer


def _subtracted(measure):
    """Return the answer by a difference of measures of the two rotations."""

    def answer(T, T_target):
        change = measure(T_target[:3, :3]) - measure(T[:3, :3])
        return np.append(T_target[:3, 3] - T[:3, 3], change)

    return answer


EXERCISE = declared(
    "pose_error",
    points=2,
    sets=2,
    arguments={"T": _ANY_POSE, "T_target": _ANY_POSE},
    cases=_cases,
    tolerance=EXACT,
    library=pose_error,
    reads=numbers(lambda *case: (6,)),
    distance=_distance,
    alike=_alike,
    says="e is p_target - p, and then the logarithm phi of R_target R^T, whose angle is at most pi",
    found=_off,
    otherwise=_otherwise,
    sweeps=(
        Sweep("a small rotation", lambda rng, size: _by(rng, size), _SMALL_ANGLES),
        Sweep("a small distance", _nearly_there, SMALL),
        Sweep("nearly half a revolution", lambda rng, gap: _by(rng, np.pi - gap), _GAPS),
    ),
    hints=(
        "Positions may be subtracted. Rotations are compared by a product: "
        "the rotation between them is X with X R = R_target.",
        "X = R_target R^T is along the world's axes, as the Jacobian's lower half is. log_so3 "
        "gives its vector.",
        "np.concatenate([T_target[:3, 3] - T[:3, 3], rotations.log_so3(T_target[:3, :3] @ T[:3, "
        ":3].T)])",
    ),
    forbidden=("course_lib.ik.pose_error",),
    mistakes=(
        Mistake(
            "the halves are not joined",
            "The error has six numbers. np.concatenate joins arrays.",
            form=lambda array, *case: array.shape in ((2, 3), (3, 2)),
        ),
        Mistake(
            "log_so3 gets a matrix that is not a rotation",
            "Which operation compares two rotations, a difference or a product?",
            raises=("ValueError", "is not a rotation"),
        ),
        Mistake(
            "log_so3 gets the whole pose",
            "Which block of T is the rotation?",
            raises=("ValueError", "of shape (..., 3, 3)"),
        ),
        Mistake(
            "the error, or one half of it, leads away from the target",
            "From which pose to which pose should the error lead?",
            lambda *case: -pose_error(*case),
            lambda *case: pose_error(*case) * [-1, -1, -1, 1, 1, 1],
            lambda *case: pose_error(*case) * [1, 1, 1, -1, -1, -1],
        ),
        Mistake(
            "phi is in degrees",
            "In which unit are the joint angles that the Jacobian multiplies?",
            lambda *case: np.rad2deg(pose_error(*case)[3:]),
            part=slice(3, 6),
        ),
        Mistake(
            "the error, or one half of it, is seen from the end-effector",
            "Along the axes of which frame are the rows of the Jacobian?",
            _from_the_end_effector(True, True),
            _from_the_end_effector(True, False),
            _from_the_end_effector(False, True),
        ),
        Mistake(
            "the translation contains a part of the rotation, because it is that of a product of "
            "poses or of its logarithm",
            "The velocity of which point do the upper rows of the Jacobian give?",
            lambda T, G: np.append((G @ inverse(T))[:3, 3], pose_error(T, G)[3:]),
            lambda T, G: np.roll(log_se3(G @ inverse(T)), 3),
            lambda T, G: np.roll(log_se3(inverse(T) @ G), 3),
            lambda T, G: log_se3(G @ inverse(T)),
            lambda T, G: log_se3(inverse(T) @ G),
        ),
        Mistake(
            "angles, rotation vectors or quaternions of the two rotations are subtracted",
            "Do rotations about different axes add up? By how many degrees does an arm have to "
            "rotate from 179 to -179 degrees?",
            _subtracted(roll_pitch_yaw),
            _subtracted(lambda R: roll_pitch_yaw(R)[::-1]),
            _subtracted(log_so3),
            _subtracted(lambda R: 2 * matrix_to_quaternion(R)[1:]),
            alike=_alike_up_to_two_pi,
        ),
    ),
)
