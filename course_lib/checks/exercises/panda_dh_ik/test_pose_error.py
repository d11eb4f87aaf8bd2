"""test_pose_error: write the test. Candidates are right and wrong versions of pose_error."""

import numpy as np

from course_lib.checks.exercises.panda_dh_ik.pose_error_mistakes import pose_error, roll_pitch_yaw
from course_lib.checks.write_test import Version, WriteTest
from course_lib.rigid import inverse, is_se
from course_lib.rotations import length, log_so3, matrix_to_quaternion


def _checked(error):
    """Return the candidate that refuses what is no pose, as the library does."""

    def candidate(T, T_target):
        if not (is_se(T) and is_se(T_target)):
            raise ValueError("T and T_target are poses")
        return error(T, T_target)

    return candidate


def _with_phi(phi_of):
    return lambda T, T_target: np.concatenate([pose_error(T, T_target)[:3], phi_of(T[:3, :3], T_target[:3, :3])])


def _with_position(position_of):
    return lambda T, T_target: np.concatenate([position_of(T, T_target), pose_error(T, T_target)[3:]])


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


def _right(kind, error):
    return Version(kind, _checked(error), right=True)


def _wrong(kind, error):
    return Version(kind, _checked(error), right=False)


_FRAME = "that is seen from another frame"
_ANGLE = "whose angle is wrong for large rotations"

EXERCISE = WriteTest(
    name="test_pose_error",
    points=2,
    arguments=("pose_error",),
    cases=lambda rng: [],
    returns=None,
    properties=(),
    mistakes=(),
    hints=(
        "You need no right version to compare with: an error is right if applying it to T gives T_target.",
        "Applying it means: add the first half to the position, and multiply the rotation by exp([phi]) on the left. "
        "Try several pairs: small angles, large ones, and positions far from the origin.",
        "With e = pose_error(T, T_target): rotations.exp_so3(e[3:]) @ T[:3, :3] is to be close to T_target[:3, :3], "
        "and the length of e[3:] at most pi. Use angles such as 1e-5, 1 and 3, and np.allclose with atol=1e-8.",
    ),
    shapes=((4, 4), (4, 4)),
    versions=(
        _right("that is as in the text", pose_error),
        _right("that goes by the quaternion", _with_phi(_by_quaternion)),
        _right("whose last digits differ", lambda *pair: pose_error(*pair) * (1 + 1e-13)),
        _right("that returns a list", lambda *pair: pose_error(*pair).tolist()),
        _wrong("with a wrong sign", lambda *pair: -pose_error(*pair)),
        _wrong("with a wrong sign", lambda *pair: pose_error(*pair) * [1, 1, 1, -1, -1, -1]),
        _wrong("with a wrong sign", lambda *pair: pose_error(*pair) * [-1, -1, -1, 1, 1, 1]),
        _wrong("in another order", lambda *pair: np.roll(pose_error(*pair), 3)),
        _wrong(_FRAME, _with_phi(lambda R, R_target: log_so3(R.T @ R_target))),
        _wrong(_FRAME, _with_position(lambda T, T_target: (T_target @ inverse(T))[:3, 3])),
        _wrong(_FRAME, _with_position(lambda T, T_target: T[:3, :3].T @ pose_error(T, T_target)[:3])),
        _wrong("that subtracts what cannot be subtracted", _with_phi(lambda R, R_t: log_so3(R_t) - log_so3(R))),
        _wrong(
            "that subtracts what cannot be subtracted",
            _with_phi(lambda R, R_t: roll_pitch_yaw(R_t) - roll_pitch_yaw(R)),
        ),
        _wrong(_ANGLE, _stretched(np.sin)),
        _wrong(_ANGLE, _stretched(lambda angle: 2 * np.sin(angle / 2))),
        _wrong("that takes the longer rotation", _stretched(lambda angle: angle - 2 * np.pi)),
        _wrong("that loses small rotations", _stretched(lambda angle: np.where(angle < 1e-3, 0, angle))),
        _wrong("in degrees", lambda *pair: np.concatenate([pose_error(*pair)[:3], np.rad2deg(pose_error(*pair)[3:])])),
    ),
)
