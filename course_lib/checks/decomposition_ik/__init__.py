"""Checks of notebook 6, inverse kinematics by cells: ``from course_lib.checks import decomposition_ik as check``."""

from course_lib.checks.decomposition_ik import (
    branches,
    cell_models,
    distances,
    grid,
    links,
    places,
    predictions,
    two_solutions,
)
from course_lib.checks.notebook import Check, Progress

dh_symbolic = Check(links.DH_SYMBOLIC)
fk_2r = Check(places.FK_2R)
ik_2r = Check(two_solutions.IK_2R)
cell_index = Check(grid.CELL_INDEX)
split_branches = Check(branches.SPLIT_BRANCHES)
fit_cells = Check(cell_models.FIT_CELLS)
predict = Check(predictions.PREDICT)
approximation_error = Check(distances.APPROXIMATION_ERROR)

CHECKS = [value for value in list(globals().values()) if isinstance(value, Check)]
progress = Progress(CHECKS)
