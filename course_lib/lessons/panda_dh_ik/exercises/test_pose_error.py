"""test_pose_error: write the test. Candidates are right and wrong versions of pose_error."""

import numpy as np

from course_lib.checks.mistake import Mistake
from course_lib.checks.tolerances import EXACT, SIX_DIGITS
from course_lib.checks.write_test import Version, WriteTest
from course_lib.lessons.panda_dh_ik.exercises.shared import pose_error, roll_pitch_yaw
from course_lib.rigid import inverse, transform
from course_lib.rotations import length, log_so3, matrix_to_quaternion


def _with_phi(phi_of):
    return lambda T, T_target: np.concatenate(
        [pose_error(T, T_target)[:3], phi_of(T[:3, :3], T_target[:3, :3])]
    )


def _with_position(position_of):
    return lambda T, T_target: np.concatenate(
        [position_of(T, T_target), pose_error(T, T_target)[3:]]
    )


def _by_quaternion(R, R_target):
    kappa = matrix_to_quaternion(R_target @ R.T)
    size = length(kappa[1:])
    return kappa[1:] * (2 * np.arctan2(size, kappa[0]) / size if size > 0 else 2.0)


def _stretched(factor):
    def phi(R, R_target):
        right = log_so3(R_target @ R.T)
        angle = length(right)
        return right * factor(angle) / angle if angle > 0 else right

    return _with_phi(phi)


def _by_largest_entry(R, R_target):
    """Return a vector along the axis whose largest entry, and not whose length, is the angle."""
    right = log_so3(R_target @ R.T)
    largest = np.abs(right).max()
    return right * length(right) / largest if largest > 0 else right


def _with_the_other_sign(T, T_target):
    """Return the error, with the opposite phi at half a revolution, which is right, too."""
    e = pose_error(T, T_target)
    return e * np.repeat([1, -1 if length(e[3:]) > _NEARLY_PI else 1], 3)


def _divided_by_zero(R, R_target):
    """Return nan for two equal rotations."""
    phi = log_so3(R_target @ R.T)
    return phi if length(phi) > EXACT else phi * np.nan


def _scaled(upper, lower):
    return lambda *pair: pose_error(*pair) * np.repeat([upper, lower], 3)


_NEARLY_PI = np.pi - SIX_DIGITS  # rad; beyond it phi and -phi are both right
_OFF = 4e-10 * np.array([1, -1, 1, -1, 1, -1])
_MOVED = transform(np.eye(3), [0.1, 0.2, 0.3])
_SIGN = "with a wrong sign"
_FRAME = "of whose error a half, or both halves, are seen from another frame"
_SUBTRACTED = "that subtracts what cannot be subtracted"
_ANGLE = "whose angle is wrong for large rotations"

EXERCISE = WriteTest(
    name="test_pose_error",
    points=2,
    arguments=("pose_error",),
    hints=(
        "You need no right version to compare with: an error is right if applying it to T gives "
        "T_target.",
        "Applying it means: add the first half to the position, and multiply the rotation by "
        "exp([phi]) on the left. "
        "Try several pairs: small angles, large ones, and positions far from the origin.",
        "With e = pose_error(T, T_target): rotations.exp_so3(e[3:]) @ T[:3, :3] must be close to "
        "T_target[:3, :3], "
        "and the length of e[3:] at most pi. Use angles such as 0, 1e-5, 1 and 3, and "
        "np.allclose with rtol=0 and atol=1e-8.",
    ),
    shapes=((4, 4), (4, 4)),
    given=lambda pose_error: np.allclose(pose_error(np.eye(4), _MOVED), [0.1, 0.2, 0.3, 0, 0, 0]),
    versions=(
        Version("that is as in the text", pose_error, right=True),
        Version("that goes by the quaternion", _with_phi(_by_quaternion), right=True),
        # Two right versions may differ by 1e-9, as the task says.
        Version("whose last digits differ", lambda *pair: pose_error(*pair) + _OFF, right=True),
        Version(
            "that returns the other sign of phi at half a revolution",
            _with_the_other_sign,
            right=True,
            mistake=Mistake(
                "your test asks for one sign of phi at half a revolution",
                "Which sign of phi does the task of pose_error ask for there?",
            ),
        ),
        Version("that returns six zeros for every pair", lambda *pair: np.zeros(6), example=True),
        Version(_SIGN, _scaled(-1, -1)),
        Version(_SIGN, _scaled(1, -1)),
        Version(_SIGN, _scaled(-1, 1)),
        Version("in another order", lambda *pair: np.roll(pose_error(*pair), 3)),
        Version(_FRAME, _with_phi(lambda R, R_target: log_so3(R.T @ R_target))),
        Version(_FRAME, _with_position(lambda T, T_target: (T_target @ inverse(T))[:3, 3])),
        Version(
            _FRAME, _with_position(lambda T, T_target: T[:3, :3].T @ pose_error(T, T_target)[:3])
        ),
        Version(_SUBTRACTED, _with_phi(lambda R, R_target: log_so3(R_target) - log_so3(R))),
        Version(
            _SUBTRACTED, _with_phi(lambda R, R_target: roll_pitch_yaw(R_target) - roll_pitch_yaw(R))
        ),
        Version(
            "that is right only for rotations about the axes of the world",
            _with_phi(_by_largest_entry),
        ),
        Version(_ANGLE, _stretched(np.sin)),
        Version(_ANGLE, _stretched(lambda angle: 2 * np.sin(angle / 2))),
        Version(_ANGLE, _stretched(lambda angle: np.minimum(angle, np.pi - angle))),
        Version(_ANGLE, _stretched(lambda angle: np.where(angle > 2.95, np.pi, angle))),
        Version(
            "that changes the sign of phi near half a revolution, where it matters",
            _stretched(
                lambda angle: np.where((angle > 2.95) & (angle < _NEARLY_PI), -angle, angle)
            ),
        ),
        Version("that takes the longer rotation", _stretched(lambda angle: angle - 2 * np.pi)),
        Version(
            "that loses small rotations", _stretched(lambda angle: np.where(angle < 1e-3, 0, angle))
        ),
        Version(
            "that loses tiny rotations", _stretched(lambda angle: np.where(angle < 3e-5, 0, angle))
        ),
        Version("that returns nan if the rotations are equal", _with_phi(_divided_by_zero)),
        Version("in degrees", _scaled(1, 180 / np.pi)),
        # By 3e-7 for half a revolution: a tolerance of 1e-6 does not see it, and one of 1e-8 does.
        Version("that is off in the seventh digit", _scaled(1, 1 - 1e-7)),
    ),
)
