"""The right pose error, and the known mistakes in it."""

import numpy as np

from course_lib.checks.exercise import Mistake, same
from course_lib.checks.vocabulary import near, remembered
from course_lib.rigid import inverse, log_se3
from course_lib.rotations import length, log_so3, matrix_to_quaternion

NEARLY_PI = np.pi - 1e-6  # rad; beyond it phi and -phi are both right

_POSITION = "Positions are subtracted, target minus current, along the world's axes."
_FROM_TO = "The error leads from T to T_target."
_WORLD = "The Jacobian's lower half is along the world's axes, so phi has to be too."
_LOGARITHM = "phi is the angle times the unit axis of the rotation that takes R to R_target."
_SPACE = (
    "The translation of T_target T^-1 is that of the point at the world's origin, which the rotation moves too: it "
    "fits the space Jacobian."
)
_ANGLES = "From 179 to -179 degrees it is 2, not -358, and such differences fit no Jacobian of angular velocities."


def position_between(T, T_target):
    """Return the difference of the positions, (3,)."""
    return T_target[:3, 3] - T[:3, 3]


def rotation_between(T, T_target):
    """Return the rotation from one orientation to the other, (3, 3), in coordinates of the base."""
    return T_target[:3, :3] @ T[:3, :3].T


@remembered
def pose_error(T, T_target):
    """Return the right answer (6,); at an angle of pi phi and -phi are both right."""
    return np.concatenate([position_between(T, T_target), log_so3(rotation_between(T, T_target))])


def angle_between(T, T_target):
    """Return the angle between the orientations."""
    return length(pose_error(T, T_target)[3:])


def nearly_pi(T, T_target):
    """Return whether the angle between the orientations is nearly pi."""
    return angle_between(T, T_target) > NEARLY_PI


def alike(e, predicted, T, T_target, up_to_two_pi=False):
    """Return whether two errors are the same, phi to the digits that a small angle has, and up to its sign at pi.

    up_to_two_pi: up to multiples of 2 pi in each entry of phi.
    """
    e, predicted = np.asarray(e, float), np.asarray(predicted, float)
    if e.shape != (6,) or not same(e[:3], predicted[:3]):
        return False
    phi = predicted[3:]
    gaps = [e[3:] - guess for guess in ((phi, -phi) if length(phi) > NEARLY_PI else (phi,))]
    gaps = [gap - up_to_two_pi * 2 * np.pi * np.round(gap / (2 * np.pi)) for gap in gaps]
    return min(np.abs(gap).max() for gap in gaps) <= 1e-4 * min(angle_between(T, T_target), 0.01) + 1e-12


def _alike_up_to_two_pi(*case):
    return alike(*case, up_to_two_pi=True)


def _swapped(e, predicted, *case):
    """As alike, for answers whose halves are swapped."""
    return np.shape(e) == (6,) and alike(np.roll(e, 3), np.roll(predicted, 3), *case)


def _with(position=position_between, phi=None):
    """Return an answer with another position(T, T_target), or another phi(R, R_target)."""

    def answer(T, T_target):
        vector = log_so3(rotation_between(T, T_target)) if phi is None else phi(T[:3, :3], T_target[:3, :3])
        return np.concatenate([position(T, T_target), vector])

    return answer


def _log(rotation):
    return _with(phi=lambda R, R_target: log_so3(rotation(R, R_target)))


def _stretched(factor):
    """Return an answer whose phi has the right axis, and is factor(angle) long."""

    def vector(R, R_target):
        phi = log_so3(R_target @ R.T)
        angle = length(phi)
        return factor(angle) * phi / angle if angle > 0 else phi

    return _with(phi=vector)


def _subtracted(measure):
    return _with(phi=lambda R, R_target: measure(R_target) - measure(R))


def _space(T, T_target):
    return T_target @ inverse(T)


def _body(T, T_target):
    return inverse(T) @ T_target


def _in_flange(R, R_target):
    return log_so3(R.T @ R_target)


def _position_in_flange(T, T_target):
    return T[:3, :3].T @ position_between(T, T_target)


def _rolled(answer, sign=1):
    return lambda *case: sign * np.roll(answer(*case), 3)


def roll_pitch_yaw(R):
    """Return the angles of R = Rot_z(yaw) Rot_y(pitch) Rot_x(roll)."""
    pitch = np.arctan2(-R[2, 0], np.hypot(R[0, 0], R[1, 0]))
    return np.array([np.arctan2(R[2, 1], R[2, 2]), pitch, np.arctan2(R[1, 0], R[0, 0])])


def _other_angles(R):
    """Return the angles of R = Rot_x(a) Rot_y(b) Rot_z(c)."""
    return -roll_pitch_yaw(R.T)


def _skew_part(M):
    return np.array([M[2, 1] - M[1, 2], M[0, 2] - M[2, 0], M[1, 0] - M[0, 1]]) / 2


def _cut_off(e, T, T_target):
    return not e[3:].any() and 0 < angle_between(T, T_target) < 0.02 and near(e[:3], position_between(T, T_target))


def _few_small_digits(e, T, T_target):
    return angle_between(T, T_target) < 1e-2 and np.abs(e - pose_error(T, T_target)).max() < 1e-7


def _near_pi(e, T, T_target):
    return angle_between(T, T_target) > np.pi - 1e-3 and near(e[:3], position_between(T, T_target))


def _nearly(e, T, T_target):
    right = pose_error(T, T_target)
    both = (right, right * [1, 1, 1, -1, -1, -1]) if nearly_pi(T, T_target) else (right,)
    return min(np.abs(e - each).max() for each in both) <= 3e-3 * max(1, np.abs(right).max())


_MEASURES = [lambda R, m=m, k=k: m(R)[::k] for m in (roll_pitch_yaw, _other_angles) for k in (1, -1)]
_right = _with()

MISTAKES = (
    Mistake(
        "pi is taken for a rotation of 0, or its axis is wrong",
        "There R_target R^T is symmetric, so X - X^T is 0, as the sine is. rotations.log_so3 handles it.",
        seen=_near_pi,
    ),
    Mistake(
        "small rotations are cut off to zero",
        "The last steps to a target are made of them. A threshold removes them, and so may arccos of a trace near 3.",
        seen=_cut_off,
    ),
    Mistake(
        "digits of small rotations are lost, as arccos of the trace loses them",
        "The trace is 3 - angle^2: an angle of 1e-9 does not change it. rotations.log_so3 keeps all digits.",
        seen=_few_small_digits,
    ),
    Mistake(
        "the logarithm fails both at tiny angles and at pi",
        "At the one arccos loses its digits, at the other X - X^T is 0. rotations.log_so3 handles both.",
        seen=lambda *case: _few_small_digits(*case) or _near_pi(*case),
    ),
    Mistake("the error has the wrong sign: current minus target", _FROM_TO, lambda *case: -_right(*case)),
    Mistake(
        "phi stands before the difference of the positions",
        "This notebook's order is (v, omega): position first.",
        *(
            _rolled(answer, sign)
            for answer in (_right, _with(_position_in_flange, _in_flange), _with(lambda *c: _space(*c)[:3, 3]))
            for sign in (1, -1)
        ),
        lambda *case: log_se3(_space(*case)),
        lambda *case: log_se3(_body(*case)),
        alike=_swapped,
    ),
    Mistake(
        "phi has the wrong sign: the logarithm of R R_target^T", _FROM_TO, _log(lambda R, R_target: R @ R_target.T)
    ),
    Mistake(
        "the position error has the wrong sign: p - p_target", _FROM_TO, _with(lambda *case: -position_between(*case))
    ),
    Mistake(
        "the whole error is seen from the end-effector",
        _POSITION + " " + _WORLD,
        _with(_position_in_flange, _in_flange),
        lambda *case: -_with(_position_in_flange, _in_flange)(*case),
        lambda *case: np.roll(log_se3(_body(*case)), 3),
    ),
    Mistake(
        "phi is seen from the end-effector: the logarithm of R^T R_target",
        _WORLD,
        _with(phi=_in_flange),
        _log(lambda R, R_target: R_target.T @ R),
    ),
    Mistake(
        "the difference of the positions is rotated into the end-effector's axes",
        _POSITION,
        _with(_position_in_flange),
        _with(lambda T, T_target: T_target[:3, :3].T @ position_between(T, T_target)),
    ),
    Mistake(
        "the translation holds a part of the rotation: it is that of T_target T^-1, or of T T_target^-1",
        _SPACE,
        _with(lambda T, T_target: _space(T, T_target)[:3, 3]),
        lambda T, T_target: -_with(lambda T, T_target: _space(T, T_target)[:3, 3])(T, T_target),
        _with(lambda T, T_target: _space(T_target, T)[:3, 3]),
        lambda T, T_target: -_with(lambda T, T_target: -_space(T_target, T)[:3, 3])(T, T_target),
        _with(lambda T, T_target: -_space(T_target, T)[:3, 3]),
        lambda *case: np.roll(log_se3(_space(*case)), 3),
    ),
    Mistake("roll, pitch and yaw are subtracted", _ANGLES, *map(_subtracted, _MEASURES), alike=_alike_up_to_two_pi),
    Mistake(
        "roll, pitch and yaw of R_target R^T stand for its rotation vector",
        "They are three rotations one after the other; phi is one rotation about one axis.",
        *(_with(phi=lambda R, R_target, m=m: m(R_target @ R.T)) for m in _MEASURES),
        alike=_alike_up_to_two_pi,
    ),
    Mistake(
        "two rotation vectors are subtracted",
        "Rotations about different axes do not add up: log(R_target) - log(R) is not the logarithm of R_target R^T.",
        _subtracted(log_so3),
    ),
    Mistake(
        "quaternions are subtracted",
        "Their difference is no rotation vector, and kappa and -kappa are the same rotation. " + _LOGARITHM,
        *(_subtracted(lambda R, k=k: k * matrix_to_quaternion(R)[1:]) for k in (1, 2, -1, -2)),
    ),
    Mistake(
        "only the sine of the angle is taken, which is right for small angles only",
        "Beyond 90 degrees it gets smaller again, and at 180 it is 0. " + _LOGARITHM,
        *map(_stretched, (np.sin, lambda a: 2 * np.sin(a), lambda a: a * np.sin(a))),
    ),
    Mistake(
        "a part of the quaternion of R_target R^T is taken for its rotation vector",
        "It is sin(angle / 2) times the axis, twice that is right for small angles only. " + _LOGARITHM,
        *(_stretched(lambda a, k=k: k * np.sin(a / 2)) for k in (1, 2, 0.5, -1, -2)),
    ),
    Mistake(
        "the longer rotation is taken",
        "2 pi - a about the opposite axis is the same rotation by a smaller angle.",
        _stretched(lambda a: a - 2 * np.pi),
    ),
    Mistake(
        "the angle is wrong beyond 90 degrees: arcsin ends there",
        "arcsin gives the same for a and pi - a. " + _LOGARITHM,
        _stretched(lambda a: np.arcsin(np.sin(a))),
    ),
    Mistake("phi is in degrees", "Angles are in radians throughout.", _stretched(np.rad2deg), _stretched(np.deg2rad)),
    Mistake("phi is twice as long, or half", _LOGARITHM, _stretched(lambda a: 2 * a), _stretched(lambda a: a / 2)),
    Mistake("the axis is returned without the angle", _LOGARITHM, _stretched(lambda a: 1)),
    Mistake(
        "the rotations are subtracted entry by entry",
        "R_target - R is no rotation. Rotations are compared by a product.",
        _with(phi=lambda R, R_target: _skew_part(R_target - R)),
        _with(phi=lambda R, R_target: 2 * _skew_part(R_target - R)),
    ),
    Mistake(
        "the matrices are multiplied entry by entry",
        "In numpy the product of matrices is @.",
        _with(phi=lambda R, R_target: _skew_part(R_target * R.T)),
    ),
    Mistake(
        "R is not transposed: this is the logarithm of a product of R and R_target",
        _WORLD,
        _log(lambda R, R_target: R_target @ R),
        _log(lambda R, R_target: R @ R_target),
    ),
    Mistake("R is left out: this is the logarithm of R_target", _WORLD, _log(lambda R, R_target: R_target)),
    Mistake("phi is left out", _LOGARITHM, _with(phi=lambda *case: np.zeros(3))),
    Mistake(
        "the difference of the positions is left out, or taken from the last row",
        "Positions are in the last column. " + _POSITION,
        _with(lambda *case: np.zeros(3)),
    ),
    Mistake(
        "p is added, or left out",
        _POSITION,
        _with(lambda T, T_target: T_target[:3, 3] + T[:3, 3]),
        _with(lambda T, T_target: T_target[:3, 3]),
    ),
    Mistake("the answer is right to its first digits only", "Compute with all digits: no np.round.", seen=_nearly),
)
