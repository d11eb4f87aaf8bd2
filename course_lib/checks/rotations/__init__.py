"""Checks of notebook 1, rotations: ``from course_lib.checks import rotations as check``."""

from course_lib.checks.notebook import namespace

EXERCISES = (
    "rotate_point",
    "compose",
    "exp_so3",
    "test_log_so3",
    "log_so3",
    "euler_angles",
    "quaternion_product",
    "quaternion_to_matrix",
    "matrix_to_quaternion",
    "slerp",
    "nearest_so",
    "nearest_quaternion",
    "nearest_se",
    "is_valid",
    "random_rotations_euler",
    "random_rotations",
    "random_quaternions",
)

globals().update(namespace(__name__, EXERCISES))
