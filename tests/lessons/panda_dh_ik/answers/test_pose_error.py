"""What students write for test_pose_error(pose_error)."""

import numpy as np

from course_lib import rotations
from course_lib.rigid import transform

PAIRS = []
for axis in ([1, 2, 2], [-2, 1, 2], [2, -2, 1]):
    for angle in (0, 1e-5, 0.5, 1.5, 3.0):
        R = rotations.exp_so3(np.array([0.7, -1.1, 0.4]))
        T = transform(R, [3.0, -2.0, 1.0])
        PAIRS.append(
            (T, transform(rotations.exp_so3(angle * np.array(axis) / 3) @ R, [0.5, 4.0, -1.0]))
        )


def right_by_applying_it(pose_error):
    for T, T_target in PAIRS:
        e = pose_error(T, T_target)
        if e.shape != (6,) or np.linalg.norm(e[3:]) > np.pi + 1e-6:
            return False
        reached = transform(rotations.exp_so3(e[3:]) @ T[:3, :3], T[:3, 3] + e[:3])
        if not np.allclose(reached, T_target, rtol=0, atol=1e-8):
            return False
    return True


def right_against_known_errors(pose_error):
    for (T, T_target), _ in zip(PAIRS * 9, range(100)):
        phi = rotations.log_so3(T_target[:3, :3] @ T[:3, :3].T)
        wanted = np.concatenate([(T_target - T)[:3, 3], phi])
        np.testing.assert_allclose(pose_error(T, T_target), wanted, rtol=0, atol=1e-8)
    return True


def right_against_a_version_of_its_own(pose_error, off=1e-9):
    def mine(T, T_target):
        return [*(T_target[:3, 3] - T[:3, 3]), *rotations.log_so3(T_target[:3, :3] @ T[:3, :3].T)]

    return all(np.abs(np.subtract(pose_error(*pair), mine(*pair))).max() < off for pair in PAIRS)


def wrong_shape_alone(pose_error):
    """accepts everything"""
    return pose_error(*PAIRS[0]).shape == (6,)


def wrong_example_alone(pose_error):
    """unnamed"""
    return np.allclose(
        pose_error(np.eye(4), transform(rotations.rot_z(0.1), [0, 0, 0])), [0, 0, 0, 0, 0, 0.1]
    )


def wrong_a_thousandth_of_a_percent_is_allowed(pose_error):
    """unnamed"""
    for T, T_target in PAIRS:
        phi = rotations.log_so3(T_target[:3, :3] @ T[:3, :3].T)
        wanted = np.concatenate([(T_target - T)[:3, 3], phi])
        if not np.allclose(pose_error(T, T_target), wanted, atol=1e-9):
            return False
    return True


def wrong_one_sign_at_half_a_revolution(pose_error):
    """your test asks for one sign of phi"""
    half = np.eye(4), transform(rotations.rot_z(np.pi), [0, 0, 0])
    one = np.allclose(pose_error(*half), [0, 0, 0, 0, 0, np.pi])
    return right_by_applying_it(pose_error) and one


def wrong_stricter_than_rounding(pose_error):
    """your test rejects right versions"""
    return right_against_a_version_of_its_own(pose_error, off=1e-10)


def wrong_number(pose_error):
    """does not have the form asked for"""
    return pose_error(*PAIRS[0])
