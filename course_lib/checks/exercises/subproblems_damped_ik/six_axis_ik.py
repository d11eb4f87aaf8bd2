"""six_axis_ik: every solution of the inverse kinematics of a six-axis arm with a spherical wrist."""

import numpy as np

from course_lib.checks.answer_types import rows
from course_lib.checks.exercise import Exercise, Mistake
from course_lib.checks.exercises.subproblems_damped_ik.shared import changed, same_list
from course_lib.checks.exercises.subproblems_damped_ik.six_axis_arm import (
    ARM,
    HOME,
    NOTHING_FOUND,
    WRIST,
    all_solutions,
    arm_solutions,
    every_solution,
    list_mistakes,
)
from course_lib.rigid import inverse, transform
from course_lib.rotations import rot_y, rot_z
from course_lib.subproblems import euler_yxy

_SWAP = np.array([[0.0, 1, 0], [1, 0, 0], [0, 0, -1]])


def _cases(rng):
    named = [[0.3, 0.4, -0.5, 0.6, 0.7, -0.8], [0.5, -0.4, 0.9, 0.8, -0.9, 0.6]]  # a slightly and a well bent arm
    drawn = [rng.uniform(0.3, 1.2, 6) * rng.choice([-1, 1], 6) for _ in range(3)]
    reached = [(ARM.fk(q),) for q in named + drawn]
    return [*reached, (transform(np.eye(3), [0.6, 0.5, 0.5]),)]


def _misses(q, T):
    return np.abs(ARM.fk(q) - T).max()


def _tell(q, T):
    reached = ARM.fk(q)
    position = np.linalg.norm(reached[:3, 3] - T[:3, 3])
    R = reached[:3, :3].T @ T[:3, :3]
    angle = np.arccos(np.clip((np.trace(R) - 1) / 2, -1, 1))
    return f"One of yours ends {position:.3g} m and {angle:.3g} rad away from T."


def _with(center, rest):
    """The angles of somebody with another wrist center, or another rotation left to the wrist."""

    def answer(T):
        found = []
        for q in arm_solutions(center(T)):
            found += [(*q, *b) for b in euler_yxy(rest(q, T)).theta]
        return found

    return answer


def _by_motion(motion):
    """The angles of somebody who takes motion(T) for the motion from home to T."""
    return _with(
        lambda T: motion(T)[:3, :3] @ WRIST + motion(T)[:3, 3],
        lambda q, T: _SWAP @ _rotation(q).T @ motion(T)[:3, :3] @ _SWAP.T,
    )


def _center(T):
    return T[:3, 3] - 0.072 * T[:3, 2]


def _rotation(q):
    return rot_z(q[0]) @ rot_y(q[1] + q[2])


def _rest(q, T):
    return _SWAP @ _rotation(q).T @ T[:3, :3] @ HOME[:3, :3].T @ _SWAP.T


EXERCISE = Exercise(
    name="six_axis_ik",
    points=3,
    arguments=("T",),
    cases=_cases,
    returns=rows(6, "an array of shape (n, 6), with n = 0 if there is no solution"),
    properties=every_solution("each row brings the flange to T", _misses, _tell, all_solutions),
    mistakes=(
        *list_mistakes(all_solutions, _misses),
        Mistake(
            "the flange's position is taken for the wrist center",
            "Joints 4 to 6 move the flange, which is 72 mm beyond the wrist center.",
            _with(lambda T: T[:3, 3], _rest),
        ),
        Mistake(
            "the flange's length is subtracted along another direction",
            "At home the flange is ahead of the wrist center along the flange's own z axis.",
            _with(lambda T: T[:3, 3] + 0.072 * T[:3, 2], _rest),
            _with(lambda T: T[:3, 3] - [0.072, 0, 0], _rest),
            _with(lambda T: T[:3, 3] - 0.072 * T[:3, 0], _rest),
            _with(lambda T: T[:3, 3] - [0, 0, 0.072], _rest),
            shadowed_by=NOTHING_FOUND.name,
        ),
        Mistake(
            "the home orientation is left out",
            "With all joint angles zero the flange is rotated already: HOME.",
            _with(_center, lambda q, T: _SWAP @ _rotation(q).T @ T[:3, :3] @ _SWAP.T),
        ),
        Mistake(
            "the rotation of the first three joints is not undone, or in the wrong order",
            "T HOME^-1 = R(q1) R(q2) R(q3) times the wrist: bring the first three to the other side.",
            _with(_center, lambda q, T: _SWAP @ T[:3, :3] @ HOME[:3, :3].T @ _SWAP.T),
            _with(_center, lambda q, T: _SWAP @ _rotation(q) @ T[:3, :3] @ HOME[:3, :3].T @ _SWAP.T),
            _with(_center, lambda q, T: _SWAP @ T[:3, :3] @ HOME[:3, :3].T @ _rotation(q).T @ _SWAP.T),
        ),
        Mistake(
            "joint 3 is left out of the rotation of the first three joints",
            "Joints 2 and 3 have parallel axes: together they rotate by q2 + q3.",
            _with(_center, lambda q, T: _SWAP @ (rot_z(q[0]) @ rot_y(q[1])).T @ T[:3, :3] @ HOME[:3, :3].T @ _SWAP.T),
        ),
        Mistake(
            "x and y are not exchanged",
            "euler_yxy is for the axes y, x, y; this wrist has x, y, x: SWAP @ W @ SWAP.T.",
            _with(_center, lambda q, T: _rotation(q).T @ T[:3, :3] @ HOME[:3, :3].T),
        ),
        Mistake(
            "HOME stands on the wrong side of T, or is left out",
            "The motion from home to T is T HOME^-1: it takes HOME to T.",
            _by_motion(lambda T: inverse(HOME) @ T),
            _by_motion(lambda T: T),
            _by_motion(lambda T: T @ HOME),
            shadowed_by=NOTHING_FOUND.name,
        ),
        Mistake(
            "the wrist center is not the point to which the motion takes WRIST",
            "motion[:3, :3] @ WRIST + motion[:3, 3].",
            _with(lambda T: (T @ inverse(HOME))[:3, 3], _rest),
            _with(lambda T: WRIST + (T @ inverse(HOME))[:3, 3], _rest),
            _with(lambda T: T[:3, :3] @ WRIST + T[:3, 3], _rest),
            shadowed_by=NOTHING_FOUND.name,
        ),
        Mistake(
            "the wrist's angles are in reverse order",
            "Joint 4 is the one next to the arm: b1.",
            changed(all_solutions, lambda q: q[[0, 1, 2, 5, 4, 3]]),
        ),
    ),
    library=all_solutions,
    alike=same_list,
    hints=(
        "Where is the wrist center? The motion T HOME^-1 has taken it from WRIST to where it is.",
        "For each triple of arm_angles: which rotation do joints 4, 5 and 6 have to add? T HOME^-1 has the rotation "
        "R(z, q1) R(y, q2 + q3) W.",
        "euler_yxy(SWAP @ W @ SWAP.T) gives both (q4, q5, q6): four triples, two each, make eight.",
    ),
)
