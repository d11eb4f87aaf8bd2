"""arm_angles: the first three joints of a six-axis arm, by subproblems 3 and 2."""

import numpy as np

from course_lib.checks.answer_types import rows
from course_lib.checks.exercise import Exercise, Mistake, Property
from course_lib.checks.exercises.subproblems_damped_ik.shared import unless_empty
from course_lib.checks.exercises.subproblems_damped_ik.six_axis_arm import (
    SHOULDER,
    WRIST,
    arm_solutions,
    bent,
    center_of,
    every_solution,
)
from course_lib.checks.format_numbers import format_array
from course_lib.checks.vocabulary import same_list
from course_lib.rotations import rot_y


def _cases(rng):
    named = [[0.3, 0.4, -0.5], [-1.2, -0.6, 0.7]]
    drawn = [rng.uniform(0.3, 1.2, 3) * rng.choice([-1, 1], 3) for _ in range(3)]
    reached = [(center_of(q),) for q in named + drawn]
    return [*reached, (np.array([0.5, 0.6, 0.4]),), (SHOULDER + np.array([0.0, 0.01, 0.02]),)]


def _misses(q, center):
    return np.linalg.norm(center_of(q) - center)


def _off(q, center):
    """How far q3 is from bringing the wrist center to its distance from the shoulder."""
    return abs(np.linalg.norm(bent(q[2])) - np.linalg.norm(center - SHOULDER))


def _tell_distance(found, center):
    q = max(found, key=lambda q: _off(q, center))
    reached, wanted = np.linalg.norm(bent(q[2])), np.linalg.norm(center - SHOULDER)
    return f"With q3 = {q[2]:.4g} it is {reached:.4g} m from it; `center` is {wanted:.4g} m from it."


_TRIANGLE = Mistake(
    "q3 is wrong",
    "Shoulder, elbow and wrist center form a triangle. Which of its sides does to_distance get, and are both points "
    "measured from the elbow?",
)
_EMPTY = Mistake("an entry is taken from an empty list", "to_distance finds nothing out of reach: use a loop.")
_AROUND = Mistake(
    "q3 is right, and q1 or q2 is not",
    "In R(z, q1) R(y, q2) p = center - SHOULDER, which rotation has to stand on the other side for subproblem 2, and "
    "what becomes of its angle? Which of the two points does each axis rotate?",
)


def _tell(q, center):
    return f"({', '.join(f'{a:.4g}' for a in q)}) brings the wrist center to {format_array(center_of(q), 4)}."


EXERCISE = Exercise(
    name="arm_angles",
    points=3,
    arguments=("center",),
    cases=_cases,
    returns=unless_empty(rows(3, "a list of triples (q1, q2, q3), empty if there is none"), arm_solutions),
    library=arm_solutions,
    alike=same_list,
    properties=(
        Property(
            "q3 brings the wrist center to its distance from the shoulder",
            lambda found, center: all(_off(q, center) < 1e-8 for q in found),
            _tell_distance,
            where=lambda center: len(arm_solutions(center)) > 0,
            mistake=_TRIANGLE,
        ),
        *every_solution("each triple brings the wrist center to `center`", _misses, _tell, arm_solutions, _AROUND),
    ),
    hints=(
        "First q3 alone: joints 1 and 2 do not change how far the wrist center is from the shoulder. Joint 3 has to "
        "make that distance right: to_distance, with all points measured from the elbow, which lies on axis 3.",
        "For each q3, compute p, the wrist center measured from the shoulder after joint 3 has moved. Then "
        "R(z, q1) R(y, q2) p = center - SHOULDER.",
        "Bring R(z, q1) to the other side: R(y, q2) p = R(z, -q1) (center - SHOULDER). That is subproblem 2.",
        "for q3 in to_distance(ey, WRIST - ELBOW, SHOULDER - ELBOW, distance), and inside it "
        "for q2, back in subproblem2(ey, ez, p, center - SHOULDER), with q1 = -back.",
    ),
    errors=tuple(("IndexError", words, _EMPTY) for words in ("list index out of range", "out of bounds for axis 0")),
)


@EXERCISE.seen
def wrist_not_moved(found, center):
    """p is WRIST - SHOULDER, as if joint 3 did not move. Where has it brought the wrist center when joints 1 and 2
    come?"""
    heights = [(rot_y(q[1]) @ (WRIST - SHOULDER))[2] for q in found]
    return len(found) > 0 and np.allclose(heights, (center - SHOULDER)[2], rtol=0, atol=1e-8)
