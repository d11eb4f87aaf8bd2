"""Checks of notebook 4, product of exponentials: ``from course_lib.checks import poe_kuka_iiwa as check``."""

from course_lib.checks.notebook import namespace

EXERCISES = (
    "hat_se3",
    "rotation_about",
    "exp_se3",
    "adjoint",
    "test_adjoint",
    "read_iiwa",
    "screw_axes",
    "read_ur5e",
    "ur5e_home",
    "forward_kinematics",
    "tool_positions",
    "space_jacobian",
    "body_screws",
    "body_jacobian",
    "singular_configurations",
    "lost_direction",
    "wrench_in_space",
    "holding_torques",
    "twist_in_frames",
    "first_bad_row",
)

globals().update(namespace(__name__, EXERCISES))
