"""Checks of notebook 3, subproblems: ``from course_lib.checks import subproblems_damped_ik as check``."""

from course_lib.checks.notebook import namespace

EXERCISES = (
    "subproblem1",
    "subproblem2",
    "subproblem3",
    "subproblem4",
    "euler_yxy",
    "rate_matrix",
    "inverse_rate_matrix",
    "constant_omega",
    "planar_jacobian",
    "lm_step",
    "solve_lm",
)
globals().update(namespace(__name__, EXERCISES))
