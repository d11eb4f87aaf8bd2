"""Checks of notebook 3, subproblems: ``from course_lib.checks import subproblems_damped_ik as check``."""

from course_lib.checks.notebook import Check, Progress
from course_lib.checks.subproblems_damped_ik import (
    damped_step,
    damped_way,
    distance,
    euler_triples,
    height,
    meeting_circles,
    rates,
    rates_back,
    steady_turn,
    tip_velocity,
    turn_onto,
)

subproblem1 = Check(turn_onto.SUBPROBLEM1)
subproblem2 = Check(meeting_circles.SUBPROBLEM2)
subproblem3 = Check(distance.SUBPROBLEM3)
subproblem4 = Check(height.SUBPROBLEM4)
euler_yxy = Check(euler_triples.EULER_YXY)
rate_matrix = Check(rates.RATE_MATRIX)
inverse_rate_matrix = Check(rates_back.INVERSE_RATE_MATRIX)
constant_omega = Check(steady_turn.CONSTANT_OMEGA)
planar_jacobian = Check(tip_velocity.PLANAR_JACOBIAN)
lm_step = Check(damped_step.LM_STEP)
solve_lm = Check(damped_way.SOLVE_LM)

CHECKS = [value for value in list(globals().values()) if isinstance(value, Check)]
progress = Progress(CHECKS)
