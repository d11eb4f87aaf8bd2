"""Checks of notebook 6, inverse kinematics by cells: ``from course_lib.checks import decomposition_ik as check``."""

from course_lib.checks.notebook import namespace

EXERCISES = (
    "dh_symbolic",
    "fk_2r",
    "ik_2r",
    "test_ik_2r",
    "cell_index",
    "split_branches",
    "fit_cells",
    "predict",
    "number_distance",
    "approximation_error",
    "convergence_slope",
    "branch_by_sign",
    "fit_square",
    "predict_square",
    "quadratic_terms",
    "newton_step",
)
globals().update(namespace(__name__, EXERCISES))
