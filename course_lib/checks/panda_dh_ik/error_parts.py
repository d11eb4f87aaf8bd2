"""The error between two poses, and what a slip in it leads to.

Vectors that stand for what is left of a turn are functions of (R, R_target), and places of (T, T_target).
"""

import numpy as np

from course_lib.rigid import inverse, log_se3
from course_lib.rotations import length, log_so3, matrix_to_quaternion

NEARLY_HALF = np.pi - 1e-6


def place_left(T, T_target):
    return T_target[:3, 3] - T[:3, 3]


def turn_left(T, T_target):
    return T_target[:3, :3] @ T[:3, :3].T


def left(T, T_target):
    """The right answer; at half a turn phi and -phi are both right."""
    return np.concatenate([place_left(T, T_target), log_so3(turn_left(T, T_target))])


def half_turn(T, T_target):
    return length(left(T, T_target)[3:]) > NEARLY_HALF


def log(turn):
    """A vector: the logarithm of turn(R, R_target)."""
    return lambda R, R_target: log_so3(turn(R, R_target))


def stretched(factor):
    """A vector along the right one, factor(angle) long."""

    def vector(R, R_target):
        phi = log_so3(R_target @ R.T)
        angle = length(phi)
        return factor(angle) * phi / angle if angle > 0 else phi

    return vector


def translation(between):
    """A place: the translation of between(T, T_target)."""
    return lambda T, T_target: between(T, T_target)[:3, 3]


def as_twist(between):
    """The place of the twist that is the logarithm of between(T, T_target)."""
    return lambda T, T_target: log_se3(between(T, T_target))[3:]


def from_world(T, T_target):
    """T_target T^-1: what is left as seen from the world's origin."""
    return T_target @ inverse(T)


def from_hand(T, T_target):
    """T^-1 T_target: what is left as seen from the hand."""
    return inverse(T) @ T_target


def roll_pitch_yaw(R):
    """R = Rot_z(yaw) Rot_y(pitch) Rot_x(roll)."""
    return np.array(
        [
            np.arctan2(R[2, 1], R[2, 2]),
            np.arctan2(-R[2, 0], np.hypot(R[0, 0], R[1, 0])),
            np.arctan2(R[1, 0], R[0, 0]),
        ]
    )


def other_angles(R):
    """R = Rot_x(a) Rot_y(b) Rot_z(c)."""
    return -roll_pitch_yaw(R.T)


def subtracted(measure):
    """Vectors: the difference of what is measured on each rotation."""
    return lambda R, R_target: measure(R_target) - measure(R)


def quaternion_parts(R):
    """The three last numbers of the unit quaternion with w >= 0."""
    return matrix_to_quaternion(R)[1:]


def skew_part(M):
    """The vector of (M - M^T) / 2."""
    return np.array([M[2, 1] - M[1, 2], M[0, 2] - M[2, 0], M[1, 0] - M[0, 1]]) / 2
