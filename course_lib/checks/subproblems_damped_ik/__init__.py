"""Checks of notebook 3, subproblems: ``from course_lib.checks import subproblems_damped_ik as check``."""

from course_lib.checks.notebook import namespace

EXERCISES = (
    "subproblem1",
    "subproblem2",
    "test_subproblem2",
    "subproblem4",
    "subproblem3",
    "wrist_sides",
    "euler_yxy",
    "arm_angles",
    "six_axis_ik",
    "rate_matrix",
    "inverse_rate_matrix",
    "planar_jacobian",
    "lm_step",
    "solve_lm",
    "step_limit",
)
globals().update(namespace(__name__, EXERCISES))
