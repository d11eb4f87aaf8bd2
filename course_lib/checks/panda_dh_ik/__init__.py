"""Checks of notebook 5, inverse kinematics by DH parameters: ``from course_lib.checks import panda_dh_ik as check``."""

from course_lib.checks.notebook import namespace

EXERCISES = (
    "dh_modified",
    "dh_standard",
    "standard_table",
    "find_signs",
    "panda_fk",
    "geometric_jacobian",
    "pose_error",
    "test_pose_error",
    "descent_step",
    "ik_step_dls",
    "weighted_step",
    "panda_ik",
    "reached_targets",
    "null_space_step",
    "bounded_step",
    "follow_velocity",
    "fit_rotation",
    "register_points",
    "good_matches",
    "grasp_pose",
    "straight_path",
)
globals().update(namespace(__name__, EXERCISES))
