"""The checks of notebook 2, rigid motion: check.<exercise>(your function)."""

from course_lib.checks.notebook import namespace

EXERCISES = (
    "wrap_angle",
    "cubic_time_scaling",
    "interpolate_body",
    "interpolate_body_screw",
    "propagate_body",
    "propagate_body_exact",
    "arm_frames",
    "interpolate_arm",
    "propagate_arm",
)
globals().update(namespace(__name__, EXERCISES))
