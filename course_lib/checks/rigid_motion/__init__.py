"""The checks of notebook 2, rigid motion: check.<exercise>(your function)."""

from course_lib.checks.notebook import Check, Progress
from course_lib.checks.rigid_motion import (
    bodies,
    euler_steps,
    exact_steps,
    frames,
    joint_steps,
    joints,
    scalings,
    screws,
    wrapping,
)

wrap_angle = Check(wrapping.WRAP_ANGLE)
cubic_time_scaling = Check(scalings.CUBIC_TIME_SCALING)
interpolate_body = Check(bodies.INTERPOLATE_BODY)
interpolate_body_screw = Check(screws.INTERPOLATE_BODY_SCREW)
propagate_body = Check(euler_steps.PROPAGATE_BODY)
propagate_body_exact = Check(exact_steps.PROPAGATE_BODY_EXACT)
arm_frames = Check(frames.ARM_FRAMES)
interpolate_arm = Check(joints.INTERPOLATE_ARM)
propagate_arm = Check(joint_steps.PROPAGATE_ARM)

CHECKS = [value for value in list(globals().values()) if isinstance(value, Check)]
progress = Progress(CHECKS)
