"""Checks of notebook 5, inverse kinematics by DH parameters: ``from course_lib.checks import panda_dh_ik as check``."""

from course_lib.checks.notebook import namespace

EXERCISES = (
    "dh_modified",
    "dh_standard",
    "panda_fk",
    "geometric_jacobian",
    "pose_error",
    "ik_step_dls",
    "panda_ik",
    "register_points",
    "grasp_pose",
)
globals().update(namespace(__name__, EXERCISES))
