"""Checks of notebook 4, product of exponentials: ``from course_lib.checks import poe_kuka_iiwa as check``."""

from course_lib.checks.notebook import Check, Progress
from course_lib.checks.poe_kuka_iiwa import (
    axes,
    axis_angle,
    carrying,
    columns,
    exponential,
    hand_columns,
    hands,
    poses,
    skew,
    twist_matrix,
    views,
)

hat = Check(skew.HAT)
hat_se3 = Check(twist_matrix.HAT_SE3)
rodrigues = Check(axis_angle.RODRIGUES)
exp_se3 = Check(exponential.EXP_SE3)
inverse = Check(poses.INVERSE)
adjoint = Check(carrying.ADJOINT)
screw_axes = Check(axes.SCREW_AXES)
forward_kinematics = Check(hands.FORWARD_KINEMATICS)
space_jacobian = Check(columns.SPACE_JACOBIAN)
body_jacobian = Check(hand_columns.BODY_JACOBIAN)
twist_in_frames = Check(views.TWIST_IN_FRAMES)

CHECKS = [value for value in list(globals().values()) if isinstance(value, Check)]
progress = Progress(CHECKS)
