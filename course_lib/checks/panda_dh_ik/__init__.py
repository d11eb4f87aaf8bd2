"""Checks of notebook 5, inverse kinematics by DH parameters: ``from course_lib.checks import panda_dh_ik as check``."""

from course_lib.checks.notebook import Check, Progress
from course_lib.checks.panda_dh_ik import (
    damped,
    downhill,
    grasping,
    hands,
    jacobians,
    links,
    pose_errors,
    reaching,
    registering,
)

dh_modified = Check(links.DH_MODIFIED)
dh_standard = Check(links.DH_STANDARD)
panda_fk = Check(hands.PANDA_FK)
geometric_jacobian = Check(jacobians.GEOMETRIC_JACOBIAN)
pose_error = Check(pose_errors.POSE_ERROR)
ik_step_transpose = Check(downhill.IK_STEP_TRANSPOSE)
ik_step_dls = Check(damped.IK_STEP_DLS)
panda_ik = Check(reaching.PANDA_IK)
register_points = Check(registering.REGISTER_POINTS)
grasp_pose = Check(grasping.GRASP_POSE)

CHECKS = [value for value in list(globals().values()) if isinstance(value, Check)]
progress = Progress(CHECKS)
