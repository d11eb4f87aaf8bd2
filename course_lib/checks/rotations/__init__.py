"""Checks of notebook 1, rotations: ``from course_lib.checks import rotations as check``."""

from course_lib.checks.notebook import Check, Progress
from course_lib.checks.rotations import (
    euler,
    exponential,
    logarithm,
    nearest,
    nearest_pose,
    poses,
    predicates,
    quaternions,
    uniform,
    unit_quaternions,
)

is_so = Check(predicates.IS_SO)
is_se = Check(poses.IS_SE)
exp_so3 = Check(exponential.EXP_SO3)
log_so3 = Check(logarithm.LOG_SO3)
is_quaternion = Check(unit_quaternions.IS_QUATERNION)
quaternion_to_matrix = Check(quaternions.QUATERNION_TO_MATRIX)
matrix_to_quaternion = Check(quaternions.MATRIX_TO_QUATERNION)
nearest_so = Check(nearest.NEAREST_SO)
nearest_quaternion = Check(unit_quaternions.NEAREST_QUATERNION)
nearest_se = Check(nearest_pose.NEAREST_SE)
random_rotations_euler = Check(euler.RANDOM_ROTATIONS_EULER)
random_rotations = Check(uniform.RANDOM_ROTATIONS)
random_quaternions = Check(uniform.RANDOM_QUATERNIONS)

CHECKS = [value for value in list(globals().values()) if isinstance(value, Check)]
progress = Progress(CHECKS)
