"""Checks of notebook 1, rotations: ``from course_lib.checks import rotations as check``."""

from course_lib.checks.notebook import Check, Progress
from course_lib.checks.rotations import exponential, nearest, poses, predicates, quaternions, sampling

is_so = Check(predicates.IS_SO)
is_quaternion = Check(predicates.IS_QUATERNION)
is_se = Check(poses.IS_SE)
exp_so3 = Check(exponential.EXP_SO3)
log_so3 = Check(exponential.LOG_SO3)
nearest_so = Check(nearest.NEAREST_SO)
nearest_quaternion = Check(nearest.NEAREST_QUATERNION)
nearest_se = Check(poses.NEAREST_SE)
quaternion_to_matrix = Check(quaternions.QUATERNION_TO_MATRIX)
matrix_to_quaternion = Check(quaternions.MATRIX_TO_QUATERNION)
random_rotations_euler = Check(sampling.RANDOM_ROTATIONS_EULER)
random_rotations = Check(sampling.RANDOM_ROTATIONS)
random_quaternions = Check(sampling.RANDOM_QUATERNIONS)

CHECKS = [value for value in list(globals().values()) if isinstance(value, Check)]
progress = Progress(CHECKS)
