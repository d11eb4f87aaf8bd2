"""arm_angles: the first three joints of a six-axis arm, by subproblems 3 and 2."""

import numpy as np

from course_lib.checks.answer_types import rows
from course_lib.checks.exercise import Exercise, Mistake
from course_lib.checks.exercises.subproblems_damped_ik.shared import same_list
from course_lib.checks.exercises.subproblems_damped_ik.six_axis_arm import (
    ELBOW,
    SHOULDER,
    WRIST,
    arm_solutions,
    center_of,
    every_solution,
    list_mistakes,
)
from course_lib.checks.format_numbers import format_array
from course_lib.subproblems import subproblem2, subproblem3

X, Y, Z = np.eye(3)


def _cases(rng):
    named = [[0.3, 0.4, -0.5], [-1.2, -0.6, 0.7]]
    drawn = [rng.uniform(0.3, 1.2, 3) * rng.choice([-1, 1], 3) for _ in range(3)]
    reached = [(center_of(q),) for q in named + drawn]
    return [*reached, (np.array([0.5, 0.6, 0.4]),), (SHOULDER + np.array([0.0, 0.01, 0.02]),)]


def _misses(q, center):
    return np.linalg.norm(center_of(q) - center)


def _tell(q, center):
    return f"({', '.join(f'{a:.4g}' for a in q)}) brings the wrist center to {format_array(center_of(q), 4)}."


def _with(bend, part, axes=(Y, Z), origin=SHOULDER):
    """The angles of somebody who bends the elbow by bend(center) and rotates part(q3) onto center - origin."""

    def answer(center):
        found = []
        for q3 in bend(center).theta:
            pairs = subproblem2(*axes, part(q3), center - origin).theta
            found += [(-b, a, q3) if axes[0] is Y else (a, -b, q3) for a, b in pairs]
        return found

    return answer


def _distance(center):
    return subproblem3(Y, WRIST - ELBOW, SHOULDER - ELBOW, np.linalg.norm(center - SHOULDER))


def _bent(q3):
    c, s = np.cos(q3), np.sin(q3)
    x, _, z = WRIST - ELBOW
    return ELBOW - SHOULDER + [c * x + s * z, 0, c * z - s * x]


EXERCISE = Exercise(
    name="arm_angles",
    points=3,
    arguments=("center",),
    cases=_cases,
    returns=rows(3, "a list of triples (q1, q2, q3), empty if there is none"),
    properties=every_solution(
        "each triple brings the wrist center to `center`",
        _misses,
        _tell,
        arm_solutions,
    ),
    mistakes=(
        *list_mistakes(arm_solutions, _misses),
        Mistake(
            "the distance is measured from another point than the shoulder",
            "Joints 1 and 2 leave the shoulder where it is, not the base.",
            _with(lambda c: subproblem3(Y, WRIST - ELBOW, SHOULDER - ELBOW, np.linalg.norm(c)), _bent),
            _with(lambda c: subproblem3(Y, WRIST - ELBOW, SHOULDER - ELBOW, np.linalg.norm(c)), _bent, origin=0),
            _with(_distance, _bent, origin=0),
            _with(lambda c: subproblem3(Y, WRIST - ELBOW, -ELBOW, np.linalg.norm(c)), _bent),
            _with(lambda c: subproblem3(Y, WRIST, SHOULDER, np.linalg.norm(c - SHOULDER)), _bent),
        ),
        Mistake(
            "the elbow is not bent when q1 and q2 are computed",
            "The point that joints 1 and 2 rotate is where joint 3 has brought the wrist center.",
            _with(_distance, lambda q3: WRIST - SHOULDER),
        ),
        Mistake(
            "the two axes of subproblem 2 are swapped",
            "p is rotated about the axis of joint 2 first, then about that of joint 1.",
            _with(_distance, _bent, (Z, Y)),
        ),
        Mistake(
            "the elbow is measured from the wrong end",
            "Subproblem 3 wants both points from one origin, here the elbow: WRIST - ELBOW and SHOULDER - ELBOW.",
            _with(lambda c: subproblem3(Y, WRIST - ELBOW, ELBOW - SHOULDER, np.linalg.norm(c - SHOULDER)), _bent),
        ),
    ),
    library=arm_solutions,
    alike=same_list,
    hints=(
        "First q3 alone: joints 1 and 2 do not change how far the wrist center is from the shoulder. Joint 3 has to "
        "make that distance right: subproblem 3, with all points measured from the elbow, which lies on axis 3.",
        "For each q3, compute p, the wrist center measured from the shoulder after joint 3 has moved. Then "
        "R(z, q1) R(y, q2) p = center - SHOULDER.",
        "Bring R(z, q1) to the other side: R(y, q2) p = R(z, -q1) (center - SHOULDER). That is subproblem 2.",
        "for q3 in subproblem3(ey, WRIST - ELBOW, SHOULDER - ELBOW, distance), and inside it "
        "for q2, back in subproblem2(ey, ez, p, center - SHOULDER), with q1 = -back.",
    ),
)
