"""Checks of notebook 2, rigid motion: ``from course_lib.checks import rigid_motion as check``."""

from course_lib.checks.notebook import namespace

EXERCISES = (
    "wrap_angle",
    "test_wrap_angle",
    "cubic_time_scaling",
    "interpolate_body",
    "exp_se2",
    "log_se2",
    "interpolate_body_screw",
    "step_lengths",
    "propagate_body",
    "propagate_body_exact",
    "arm_frames",
    "propagate_arm",
    "two_link_angles",
)
globals().update(namespace(__name__, EXERCISES))
