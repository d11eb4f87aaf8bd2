"""propagate_arm: a plan of joint velocities; the students find a bug."""

import numpy as np

from course_lib.checks.answer_types import rows
from course_lib.checks.declared import declared
from course_lib.checks.tolerances import EXACT
from course_lib.lessons.rigid_motion.exercises import shared
from course_lib.lessons.rigid_motion.exercises.propagate_body import (
    PLAN,
    drawn_case,
    quarters_of_steps,
    special,
)
from course_lib.planar import propagate_arm

ARM = (True, True)  # both columns are angles


def _cases(rng):
    origin, quarter = np.zeros(2), np.pi / 4
    first, second = (1.0, 0.0), (0.0, 1.0)
    simple = [
        ([0, 0], [((1, 0), 0.25)], 0.1),
        (origin, [(second, 0.5)], 0.25),
        (np.array([1.0, 2.0]), [(first, 0.5)], 0.25),
        (np.array([0.5, -1.0]), [((2.0, -1.0), 0.35)], 0.1),
        (origin, [(first, 0.3)], 1.0),
        (origin, [(first, 0.2005)], 0.1),
        (origin, [(first, 0.2995)], 0.1),
        (np.array([1, 2]), [((1, 1), 1)], 0.5),
    ]
    rounding = (
        (0.3, 0.1),
        (0.9, 0.3),
        (1.0, 0.1),
        (1.1, 0.1),
        (2.1, 0.3),
    )  # a hair above or below a multiple
    sums = [(origin, [(first, duration)], dt) for duration, dt in rounding]
    several = [
        (origin, [(first, 0.25), (second, 0.1)], 0.1),
        ([0.0, 0.0], [((quarter, 0), 1.0), ((0, quarter), 1.0), ((quarter, quarter), 1.0)], 0.3),
        (np.array([3.0, -3.0]), [((2.0, -2.0), 0.5)], 0.25),
    ]
    start, plan, dt = drawn_case(rng, angles=2, lengths=0)
    several.append((np.rint(start), plan, dt))  # whole numbers, and legs that end between them
    drawn = [drawn_case(rng, angles=2, lengths=0) for _ in range(4)]
    return [*simple, *sums, *several, *shared.plans(2), *drawn]


def _step(angles, velocity, h):
    return angles + velocity * h


def _assigned(start, plan, dt):
    """Return what the broken code answers: an angle is the velocity times the time since the pair
    began, and is not added to what was."""
    angles = [np.array(start, float)]
    for velocity, duration in plan:
        for elapsed in np.cumsum(shared.lengths(duration, dt)):
            angles.append(np.array(velocity, float) * elapsed)
    return np.array(angles)


EXERCISE = declared(
    "propagate_arm",
    points=1,
    arguments=PLAN,
    cases=_cases,
    sweeps=(shared.slow_motions(2),),
    special=special(2),
    admits=quarters_of_steps,
    tolerance=EXACT,
    reads=rows(2, "joint angles, an array of shape (n, 2)", most=2000),
    properties=shared.form(ARM),
    library=propagate_arm,
    broken=_assigned,
    alike=shared.same_rows(ARM),
    distance=shared.distance_of_rows(ARM),
    says="in each step each joint angle grows by its velocity times the length of the step",
    found=shared.first_wrong_step(propagate_arm, ARM),
    hints=(
        "Run it on a plan of two pairs, one joint each, and print the rows. Where does an angle "
        "jump?",
        "An angle after a step is the angle before it, plus velocity times the length of the step.",
        "theta = theta + np.array(velocity) * h for each h of step_lengths(duration, dt), and a "
        "row after each step.",
    ),
    forbidden=(
        "course_lib.planar.propagate_arm",
        "course_lib.planar.propagate_body",
        "course_lib.planar.propagate_body_exact",
    ),
    mistakes=shared.step_mistakes(_step),
)
